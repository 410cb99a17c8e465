// Breakaway torque around the rotor: at each angle a slow current ramp from standstill until the rotor moves, both
// ways, some turns.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "experiment/breakaway_ramp.h"
#include "experiment/breakaway_tour.h"
#include "experiment/index_watch.h"
#include "experiment/timed_procedure.h"
#include "experiment/zeroing.h"
#include "friction/measurements.h"
#include "motor/winding_line.h"

namespace breakaway {

struct BreakawaySweepOptions {
  size_t bins = 180;
  size_t turns = 2;
  double indexAngle_rad = 0.0;  ///< from homing
  double torqueConstant_Nm_per_A = 0.0;
  /// The winding's steady line, from the winding test or, with a zero dead zone, from the bench's resistance. The ramp
  /// is made by voltage along it, because a current loop would bring the sensor's noise into the winding.
  double resistance_ohm = 0.0;
  double deadZone_V = 0.0;
  double inertia_kg_m2 = 0.0;                ///< for the lag's correction; 0: none
  double backEmfConstant_V_s_per_rad = 0.0;  ///< likewise
  std::array<double, 2> expected_A{
      0.0, 0.0};  ///< first look at the breakaway current by Way; 0: found by a first, long ramp
  /// What keeps it moving at low speed, per angle and Way, positive in the way's direction, any number of equal bins
  /// from the index; empty: unknown. Its half difference holds the rotor against position torque.
  std::array<std::vector<double>, 2> moving_A;
  double current_limit_A = 0.0;  ///< 0: the controller's own
  double move_s = 1.5;           ///< at most, to the next angle
  double settle_s = 0.04;
  double dwell_s = 0.08;
  double ramp_s = 0.45;  ///< of the ramp's last part, from rampStart of what is expected
  double rampStart = 0.7;
  double zeroEvery_s = 12.0;  ///< the current sensor is zeroed this often
  double zeroing_s = 0.6;
  double motionVelocity_rad_per_s = 0.15;
  size_t motionCounts = 4;
  double countsPerRev = 0.0;        ///< from the board's identity
  double mostOverExpected = 4.0;    ///< a ramp gives up at this many times the expected current
  double indexTolerance_rad = 0.0;  ///< between the index and where homing found it; 0: not watched
  double mostDrift_A = 0.1;         ///< of the current sensor's zero, from one zeroing to the next
};

/// Each pass around the rotor begins beyond the index, so that lost counts show. Then at each angle, as one leg:
/// settle, dwell, ramp; motion counts when it is sustained in counts and in speed; it is dated back to the last
/// standing sample, and the time the rotor needed for its first count is taken off. The angle where it stood is the
/// event's angle.
class BreakawaySweep : public TimedProcedure {
 public:
  /// `earlier` are the breakaways of an interrupted sweep with the same bins; they are kept, and what is missing of the
  /// turns is measured. Fails in words when the rotor doesn't break away three times in a row, when the index comes
  /// elsewhere or not at all, and when the current sensor drifts.
  explicit BreakawaySweep(BreakawaySweepOptions options, const std::vector<BreakawayEvent>& earlier = {});

  /// All breakaways so far, in the order they were measured; outliers are marked against their neighbours.
  const std::vector<BreakawayEvent>& events() const { return tour_.events(); }
  const BreakawaySweepOptions& options() const { return options_; }
  /// Angles at which the rotor didn't break away.
  size_t missed() const { return missed_; }
  /// The sensor's zeros on the way: before the first breakaway, every zeroEvery_s, and after the last.
  const std::vector<ZeroReading>& zeros() const { return zeroing_.readings(); }

 protected:
  Command run(const Sample& sample) override;
  double progress() const override;
  double remaining_s() const override;
  std::string activity() const override;

 private:
  enum class Stage { zero, index, angle };
  using Machine = BreakawayLeg<double>;
  Way way() const { return tour_.way(); }
  double sign() const { return tour_.sign(); }
  double binAngle_rad() const;
  double moving_A(Way way, double angle_rad) const;
  double hold_A() const;
  Command zero(const Sample& sample);
  void enter(Stage stage, const Sample& sample);
  void approach(const Sample& sample);
  Command passIndex(const Sample& sample);
  void begin(const Sample& sample);
  RampPlan planRamp() const;
  void follow(const Sample& sample);
  void end(const Sample& sample);
  void missed(const Sample& sample);
  void takeEvent();
  void advanceStep(const Sample& sample);

  BreakawaySweepOptions options_;
  BreakawayTour tour_;
  Zeroing zeroing_;
  Stage stage_ = Stage::zero;
  size_t missed_ = 0, missedInARow_ = 0;
  int attempt_ = 0;
  std::optional<size_t> indexPass_;  ///< pass around the rotor, of one way, that has begun with the index
  IndexWatch index_;
  std::array<std::optional<double>, 2> recent_A_;          ///< last breakaway less the holding current, by Way
  std::array<std::optional<double>, 2> recentOverMoving_;  ///< and over what keeps it moving there
  BreakawayRamp ramp_;
  double stageStart_s_ = 0.0, now_s_ = 0.0, zeroed_s_ = 0.0, first_s_ = 0.0, target_rad_ = 0.0, indexFrom_rad_ = 0.0,
         rampStart_s_ = 0.0, commanded_A_ = 0.0, boardAngle_rad_ = 0.0;
  double leastTick_s_ = 0.0;
  LegPhase seen_ = notBegun;  ///< of the angle's leg
  RampPlan planned_;
  bool rampSeen_ = false;  ///< no sample was lost where the ramp began
  bool begun_ = false;
};

}  // namespace breakaway
