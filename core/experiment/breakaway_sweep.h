// Breakaway torque around the rotor: at each angle a slow current ramp from standstill until the rotor moves, both
// ways, some turns.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiment/breakaway_procedure.h"
#include "experiment/index_watch.h"

namespace breakaway {

/// `moving_A` in any number of equal bins from the index; empty: unknown.
struct BreakawaySweepOptions : BreakawayOptions {
  size_t bins = 180;
  size_t turns = 2;
  double indexAngle_rad = 0.0;  ///< from homing
  std::array<double, 2> expected_A{
      0.0, 0.0};                    ///< first look at the breakaway current by Way; 0: found by a first, long ramp
  double move_s = 1.5;              ///< at most, to the next angle
  double countsPerRev = 0.0;        ///< from the board's identity
  double indexTolerance_rad = 0.0;  ///< between the index and where homing found it; 0: not watched
};

/// Each pass around the rotor begins beyond the index, so that lost counts show. Then each angle is one leg. Fails in
/// words also when the index comes elsewhere or not at all.
class BreakawaySweep : public BreakawayProcedure {
 public:
  explicit BreakawaySweep(BreakawaySweepOptions options, const std::vector<BreakawayEvent>& earlier = {});

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override { return progressWith(activity(), 0.2); }
  void beginZeroing(const Sample& sample) override { enter(Stage::zero, sample); }
  void goToPlace(const Sample& sample) override;
  double moving_A(Way way) const override;

 private:
  enum class Stage { zero, index, angle };
  using Machine = BreakawayLeg<double>;
  double binAngle_rad() const;
  double expected_A() const;
  void enter(Stage stage, const Sample& sample);
  Command passIndex(const Sample& sample);
  void begin(const Sample& sample);
  void follow(const Sample& sample);
  void end(const Sample& sample);
  void takeEvent();
  Message activity() const;

  BreakawaySweepOptions options_;
  Stage stage_ = Stage::zero;
  std::optional<size_t> indexPass_;  ///< pass around the rotor, of one way, that has begun with the index
  IndexWatch index_;
  std::array<std::optional<double>, 2> recent_A_;          ///< last breakaway less the holding current, by Way
  std::array<std::optional<double>, 2> recentOverMoving_;  ///< and over what keeps it moving there
  double target_rad_ = 0.0, indexFrom_rad_ = 0.0, rampStart_s_ = 0.0, commanded_A_ = 0.0, boardAngle_rad_ = 0.0;
  double leastTick_s_ = 0.0;
  LegPhase seen_ = notBegun;  ///< of the angle's leg
  RampPlan planned_;
  bool rampSeen_ = false;  ///< no sample was lost where the ramp began
};

}  // namespace breakaway
