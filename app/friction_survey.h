// What is known of the friction so far, from breakaways and runs at constant speed, and the map that they make.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "friction/friction_map.h"
#include "friction/measurements.h"
#include "identify/velocity_friction.h"
#include "run.h"

namespace breakaway {

struct FrictionSurvey {
  std::string rig;
  std::optional<Identification> identification;
  size_t bins = 180;
  size_t turns = 2;
  size_t missed = 0;
  std::vector<BreakawayEvent> events;
  bool sweepComplete = false;
  std::vector<VelocityRun> runs;

  // Estimated by estimate().
  std::optional<std::array<MovingFriction, 2>> moving;
  std::optional<FrictionMap> map;
  std::string mapObstacle;  ///< why there is no map, in words

  /// Coulomb and viscous friction as the mean of both ways.
  std::optional<Estimate> coulombAverage_Nm() const;
  std::optional<Estimate> viscousAverage_Nm_s_per_rad() const;

  /// Moving friction from the runs, and the map from the breakaways with it; what can't be estimated stays empty.
  void estimate();
};

/// All breakaways as CSV text: angle_rad, way, turn, bin, current_A, torque_Nm, outlier.
std::string breakawayTable(const std::vector<BreakawayEvent>& events);

}  // namespace breakaway
