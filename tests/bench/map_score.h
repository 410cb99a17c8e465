// One commissioning against the truth, in figures that fit on a line of a log.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/result.h"
#include "commission/commission.h"
#include "friction/friction_map.h"
#include "plant/rig.h"

namespace breakaway::test {

/// One curve of a map: RMS error, its Cramér–Rao bound, mean error (parts of the true mean), and the share of bins
/// whose 95 % interval holds the truth.
struct CurveScore {
  double rms = 0.0, bound = 0.0, mean = 0.0, covered = 0.0;
  /// Within the target, or within 1.5 times the bound where that is larger.
  bool within(double target) const { return rms <= (target > 1.5 * bound ? target : 1.5 * bound); }
};

struct WayScore {
  CurveScore still, coulomb, viscous;
  double correlation = 0.0;
  double noiseOverSpread = 0.0;  ///< of one turn, over the true curve's spread
};

struct MapScore {
  std::string rig;
  std::string failure;  ///< empty when it was commissioned
  std::array<WayScore, 2> way;
  CurveScore friction, position;  ///< static_friction_Nm and position_torque_Nm, parts of the mean static friction
  double rig_s = 0.0, cpu_s = 0.0, missed = 0.0;

  std::string line() const;
  static std::optional<MapScore> fromLine(const std::string& line);
};

inline constexpr double staticTarget = 0.03, coulombTarget = 0.03, viscousTarget = 0.08;
inline constexpr double repeatableNoise = 0.23, leastCorrelation = 0.95;

/// Every measured curve of `done` beside the truth and the bound of `rig`'s sensors.
void compare(const Commission& done, const FrictionMap& truth, const Rig& rig, MapScore& score);

}  // namespace breakaway::test
