#include "firmware_link/simulated_truth.h"

#include <numbers>

#include "firmware_link/presets.h"
#include "motor/rig_torques.h"

namespace breakaway {

Result<FrictionMap> trueMap(const std::string& uri, size_t bins, double totalVelocity_rad_per_s) {
  const auto file = rigFileOf(uri);
  if (!file) return file.error();
  const auto rig = readRig(*file);
  if (!rig) return rig.error();
  FrictionMap map;
  map.rig = rig->name;
  map.totalVelocity_rad_per_s = totalVelocity_rad_per_s;
  map.bins.resize(bins);
  double coulomb = 0.0, viscous = 0.0;
  for (size_t k = 0; k < bins; ++k) {
    MapBin& bin = map.bins[k];
    bin.angle_rad = (static_cast<double>(k) + 0.5) * 2.0 * std::numbers::pi / static_cast<double>(bins);
    const RigTorques torques = torquesAt(*rig, bin.angle_rad);
    for (size_t w = 0; w < 2; ++w) {
      const double against = w == 0 ? torques.position_Nm : -torques.position_Nm;
      WayBin& way = bin.way[w];
      way.static_Nm.value = torques.static_Nm[w] + against;
      way.coulomb_Nm.value = torques.coulomb_Nm[w] + against;
      way.viscous_Nm_s_per_rad.value = torques.viscous_Nm_s_per_rad[w];
      way.total_Nm = way.coulomb_Nm.value + way.viscous_Nm_s_per_rad.value * totalVelocity_rad_per_s;
      coulomb += way.coulomb_Nm.value;
      viscous += way.viscous_Nm_s_per_rad.value;
    }
  }
  map.coulombAverage_Nm.value = coulomb / static_cast<double>(2 * bins);
  map.viscousAverage_Nm_s_per_rad.value = viscous / static_cast<double>(2 * bins);
  return map;
}

}  // namespace breakaway
