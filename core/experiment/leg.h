// A procedure's leg as the host asks for it, and what runs it here where a board can't.
#pragma once

#include <variant>

#include "control/leg/breakaway_leg.h"
#include "control/leg/homing_leg.h"
#include "control/leg/speed_leg.h"
#include "experiment/drive.h"

namespace breakaway {

/// The breakaway's target stands as an angle; whoever runs the leg sets its counts.
struct Leg {
  std::variant<HomingPlan<double>, BreakawayPlan<double>, SpeedPlan<double>> plan;
  double target_rad = 0.0;
  double current_limit_A = 0.0;  ///< 0: the controller's own
};

/// Runs one leg from the host, sample by sample.
class LegRunner {
 public:
  /// `countsPerRev` of the encoder; 0: unknown.
  explicit LegRunner(double countsPerRev);
  void begin(const Leg& leg);
  LegPhase step(const Sample& sample);
  Command command() const;

 private:
  std::int32_t countOf(double angle_rad) const;

  double countsPerTurn_;
  double current_limit_A_ = 0.0;
  std::variant<HomingLeg<double>, BreakawayLeg<double>, SpeedLeg<double>> leg_;
};

}  // namespace breakaway
