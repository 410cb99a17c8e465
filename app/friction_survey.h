// What is known of the friction so far, from breakaways and runs at constant speed, and the map that they make.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "commission/travel_plan.h"
#include "friction/friction_map.h"
#include "friction/measurements.h"
#include "identify/map_estimation.h"
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

  // Of a linear axis, counted from the index: turns are passes.
  Axis axis = Axis::rotary;
  Identity board;                ///< that it was measured on
  std::optional<Travel> travel;  ///< that the bins lie over
  std::vector<TravelRun> strokes;
  size_t strokeBins = 0;  ///< that the strokes were taken apart into
  double strokesZeroError_A = 0.0, eventsZeroError_A = 0.0;
  std::vector<std::pair<std::string, double>> settings;  ///< of the breakaway sweep

  // Estimated by estimate().
  std::optional<std::array<MovingFriction, 2>> moving;
  std::optional<FrictionMap> map;
  std::string mapObstacle;  ///< why there is no map, in words

  /// Coulomb and viscous friction as the mean of both ways.
  std::optional<Estimate> coulombAverage_Nm() const;
  std::optional<Estimate> viscousAverage_Nm_s_per_rad() const;

  /// The travel as it was felt anew. Bins stay where they were as long as the ends are where they were; else what was
  /// measured over the travel is forgotten, and the answer is false.
  bool layOver(const Travel& felt);
  /// What is known of the axis, if it is: counted from the index.
  std::optional<KnownAxis> knownAxis() const;

  /// Moving friction from the runs, and the map from the breakaways with it; what can't be estimated stays empty.
  void estimate();

 private:
  bool sweepIsThere();  ///< or why there is none as the map's obstacle
  MapOptions mapOptions() const;
  void estimateAroundRotor();
  void estimateOverTravel();
};

/// All breakaways as CSV text: angle_rad, way, turn, bin, current_A, torque_Nm, outlier; on a linear axis position_m
/// and force_N.
std::string breakawayTable(const std::vector<BreakawayEvent>& events, Axis axis = Axis::rotary);

}  // namespace breakaway
