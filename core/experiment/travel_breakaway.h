// Breakaway force over a linear axis' travel: at each place a slow current ramp from standstill until it moves, both
// ways, some times.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiment/breakaway_ramp.h"
#include "experiment/breakaway_tour.h"
#include "experiment/timed_procedure.h"
#include "experiment/travel.h"
#include "experiment/travel_bins.h"
#include "experiment/zeroing.h"
#include "friction/measurements.h"

namespace breakaway {

struct TravelBreakawayOptions {
  Travel travel;
  TravelBins bins;
  size_t passes = 2;  ///< over the travel, each way
  double forceConstant_N_per_A = 0.0;
  /// The winding's steady line: the ramp is made by voltage along it, as in the rotary sweep.
  double resistance_ohm = 0.0, deadZone_V = 0.0;
  double mass_kg = 0.0, backEmfConstant_V_s_per_m = 0.0;  ///< for the lag's correction
  /// What keeps it moving slowly, per bin and Way, positive in the way's direction.
  std::array<std::vector<double>, 2> moving_A;
  double current_limit_A = 0.0;
  double speed_m_per_s = 0.0, acceleration_m_per_s2 = 0.0;  ///< from place to place
  double move_s = 2.0;                                      ///< at most, beyond what the way takes
  double settle_s = 0.04, dwell_s = 0.08;
  double ramp_s = 0.45;  ///< of the ramp's last part, from rampStart of what is expected
  double rampStart = 0.7;
  double zeroEvery_s = 12.0, zeroing_s = 0.6;
  double motionVelocity_m_per_s = 0.0;  ///< that counts as motion, with motionCounts
  size_t motionCounts = 4;
  double count_m = 0.0;
  double mostOverExpected = 4.0;
  double index_m = 0.0, indexTolerance_m = 0.0;
  double mostDrift_A = 0.1;
};

/// At each place: settle, dwell, ramp; motion counts when it is sustained in counts and in speed, and is dated back as
/// in the rotary sweep. `angle_rad` of an event is the place in m as the encoder counts it, `torque_Nm` N. Fails in
/// words when the axis doesn't break away three times in a row, when the encoder doesn't count as it did, and when the
/// current sensor drifts.
class TravelBreakaway : public TimedProcedure {
 public:
  /// `earlier`: the breakaways of an interrupted sweep with the same bins.
  explicit TravelBreakaway(TravelBreakawayOptions options, const std::vector<BreakawayEvent>& earlier = {});

  const std::vector<BreakawayEvent>& events() const { return tour_.events(); }
  const std::vector<ZeroReading>& zeros() const { return zeroing_.readings(); }
  size_t missed() const { return missed_; }

 protected:
  Command run(const Sample& sample) override;
  double progress() const override;
  double remaining_s() const override;
  std::string activity() const override;

 private:
  enum class Stage { zero, move, dwell, ramp };
  void enter(Stage stage, const Sample& sample);
  Command zero(const Sample& sample);
  Command move(const Sample& sample);
  Command dwell(const Sample& sample);
  Command ramp(const Sample& sample);
  Command current(double inWay_A);
  bool moves(const Sample& sample) const;
  RampPlan planRamp() const;
  void takeEvent();
  void advanceStep(const Sample& sample);
  double moving_A(Way way) const;
  double hold_A() const { return 0.5 * (moving_A(Way::ccw) - moving_A(Way::cw)); }
  Way way() const { return tour_.way(); }
  double sign() const { return tour_.sign(); }

  TravelBreakawayOptions options_;
  BreakawayTour tour_;
  Zeroing zeroing_;
  TravelWatch watch_;
  Glide glide_;
  BreakawayRamp ramp_;
  Stage stage_ = Stage::zero;
  size_t missed_ = 0, missedInARow_ = 0;
  int attempt_ = 0;
  std::array<std::optional<double>, 2> overMoving_;  ///< last breakaway over what keeps it moving there
  double stageStart_s_ = 0.0, near_s_ = 0.0, zeroed_s_ = 0.0, first_s_ = 0.0, now_s_ = 0.0, now_m_ = 0.0;
  double allowed_s_ = 0.0, commanded_A_ = 0.0;
  bool begun_ = false;
};

}  // namespace breakaway
