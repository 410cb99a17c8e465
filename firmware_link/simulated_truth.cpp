#include "firmware_link/simulated_truth.h"

#include <cmath>

#include "base/numbers.h"
#include "firmware_link/presets.h"
#include "plant/rig.h"

namespace breakaway {

namespace {

/// Of the rig's shaft; on a linear axis positions are counted from the index, or from the lower stop without one.
double shaftAngle_rad(const Rig& rig, double place) {
  return rig.axis == Axis::rotary ? place : place / rig.unitPerRad() + rig.encoder.indexPlace_rad;
}

/// Of what hangs on the shaft from the start, towards growing angle.
double hanging_Nm(const Rig& rig, double shaft_rad) {
  double torque = 0.0;
  for (const RigWiring& one : rig.wiring) {
    if (one.kind == WiringKind::load) torque += one.value;
    if (one.kind == WiringKind::pendulum) torque -= one.value * std::sin(shaft_rad - rig.startAngle_rad());
  }
  return torque;
}

}  // namespace

Result<FrictionMap> trueMap(const std::string& uri, const FrictionMap& measured) {
  const auto file = rigFileOf(uri);
  if (!file) return file.error();
  const auto rig = readRig(*file);
  if (!rig) return rig.error();
  FrictionMap map;
  map.rig = rig->name;
  map.axis = rig->axis;
  map.totalVelocity_rad_per_s = measured.totalVelocity_rad_per_s;
  map.bins.resize(measured.bins.size());
  const PlantPhysics physics = physicsOf(*rig);
  const double unit = rig->unitPerRad();
  double coulomb = 0.0, viscous = 0.0;
  for (size_t k = 0; k < map.bins.size(); ++k) {
    MapBin& bin = map.bins[k];
    bin.angle_rad = measured.bins[k].angle_rad;
    const double shaft_rad = shaftAngle_rad(*rig, bin.angle_rad);
    const AngleTorques torques = torquesAt(physics, shaft_rad);
    const double position_Nm = torques.position_Nm + hanging_Nm(*rig, shaft_rad);
    for (size_t w = 0; w < 2; ++w) {
      const double against = w == 0 ? position_Nm : -position_Nm;
      WayBin& way = bin.way[w];
      way.static_Nm.value = (torques.static_Nm[w] + against) / unit;
      way.coulomb_Nm.value = (torques.coulomb_Nm[w] + against) / unit;
      way.viscous_Nm_s_per_rad.value = torques.viscous_Nm_s_per_rad[w] / (unit * unit);
      way.total_Nm = way.coulomb_Nm.value + way.viscous_Nm_s_per_rad.value * map.totalVelocity_rad_per_s;
      coulomb += way.coulomb_Nm.value;
      viscous += way.viscous_Nm_s_per_rad.value;
    }
  }
  const auto both = static_cast<double>(2 * map.bins.size());
  map.coulombAverage_Nm.value = coulomb / both;
  map.viscousAverage_Nm_s_per_rad.value = viscous / both;
  return map;
}

Result<FrictionMap> trueMap(const std::string& uri, size_t bins, double totalVelocity_rad_per_s) {
  FrictionMap turn;
  turn.totalVelocity_rad_per_s = totalVelocity_rad_per_s;
  turn.bins.resize(bins);
  for (size_t k = 0; k < bins; ++k)
    turn.bins[k].angle_rad = (static_cast<double>(k) + 0.5) * turn_rad / static_cast<double>(bins);
  return trueMap(uri, turn);
}

}  // namespace breakaway
