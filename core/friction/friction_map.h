// Friction around the rotor, or over a linear axis' travel: what a sweep measured, per bin and direction.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/axis.h"
#include "base/estimate.h"
#include "base/numbers.h"

namespace breakaway {

/// cw is falling angle, ccw is growing angle.
enum class Way { cw = 0, ccw = 1 };
constexpr double signOf(Way way) {
  return signOfWay(static_cast<int>(way));
}

/// One bin and one way. Torques are whole motor torques (friction and position torque), positive in the way's
/// direction.
struct WayBin {
  Estimate static_Nm;             ///< starts motion from standstill; mean over repeats
  Estimate coulomb_Nm;            ///< keeps it moving, extrapolated to zero speed
  Estimate viscous_Nm_s_per_rad;  ///< its slope with speed
  double total_Nm = 0.0;          ///< coulomb + viscous × the map's total velocity
  size_t samples = 0;             ///< breakaways that the static value rests on
  bool outlier = false;           ///< marked, never hidden
};

struct MapBin {
  double angle_rad = 0.0;     ///< bin centre, 0 at the index, in [0, 2π); in m, within the travel, on a linear axis
  std::array<WayBin, 2> way;  ///< indexed by Way

  double staticFriction_Nm() const { return 0.5 * (way[0].static_Nm.value + way[1].static_Nm.value); }
  double positionTorque_Nm() const { return 0.5 * (way[0].static_Nm.value - way[1].static_Nm.value); }
};

/// How well consecutive turns of the breakaway sweep repeat, per way.
struct Repeatability {
  double correlation = 0.0;
  double rmsDifference_Nm = 0.0;
};

/// On a linear axis read m for rad and N for Nm: bins lie side by side over the travel that was measured, and files
/// name the columns so.
struct FrictionMap {
  std::string rig;
  Axis axis = Axis::rotary;
  size_t turns = 0;
  double totalVelocity_rad_per_s = 0.0;
  std::vector<MapBin> bins;
  /// Static friction per turn and way, bins.size() long each; for the picture of turn 1 against turn 2.
  std::array<std::vector<std::vector<double>>, 2> turnStatic_Nm;
  std::array<Repeatability, 2> repeatability;
  Estimate coulombAverage_Nm;
  Estimate viscousAverage_Nm_s_per_rad;
  Estimate stribeckVelocity_rad_per_s;  ///< over which friction falls from static to Coulomb; 0: not known
  std::vector<std::pair<std::string, double>> settings;  ///< name with unit and value: how it was measured
  std::vector<std::string> remarks;                      ///< contradictions that it was measured in spite of, loads
};

}  // namespace breakaway
