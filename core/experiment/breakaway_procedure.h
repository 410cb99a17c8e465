// What breakaway sweeps around a rotor and over a travel share: the tour of places, zeroings, the ramp's plan, the
// event.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "experiment/breakaway_ramp.h"
#include "experiment/breakaway_tour.h"
#include "experiment/timed_procedure.h"
#include "experiment/zeroing.h"
#include "friction/measurements.h"

namespace breakaway {

/// On a linear axis N/A for Nm/A, kg for kg m², m for rad.
struct BreakawayOptions {
  double torqueConstant_Nm_per_A = 0.0;
  /// The winding's steady line, from the winding test or, with a zero dead zone, from the bench's resistance. The ramp
  /// is made by voltage along it, because a current loop would bring the sensor's noise into the winding.
  double resistance_ohm = 0.0, deadZone_V = 0.0;
  double windingTime_s = 0.0;                ///< L/R, by which the current comes after the ramp's first step
  double inertia_kg_m2 = 0.0;                ///< for the lag's correction; 0: none
  double backEmfConstant_V_s_per_rad = 0.0;  ///< likewise
  /// What keeps it moving at low speed, per place and Way, positive in the way's direction. Its half difference holds
  /// the motor against position torque.
  std::array<std::vector<double>, 2> moving_A;
  double current_limit_A = 0.0;  ///< 0: the controller's own
  double settle_s = 0.04, dwell_s = 0.08;
  double ramp_s = 0.45;  ///< of the ramp's last part, from rampStart of what is expected
  double rampStart = 0.7;
  double zeroEvery_s = 12.0;  ///< the current sensor is zeroed this often
  double zeroing_s = 0.6;
  double motionVelocity_rad_per_s = 0.15;  ///< that counts as motion, with motionCounts
  size_t motionCounts = 4;
  double mostOverExpected = 4.0;  ///< a ramp gives up at this many times the expected current, or the usual one
  double mostDrift_A = 0.1;       ///< of the current sensor's zero, from one zeroing to the next
};

/// At each place: settle, dwell, ramp; motion counts when it is sustained in counts and in speed; it is dated back to
/// the last standing sample, and the time needed for the first count is taken off. The place where it stood is the
/// event's. Fails in words when nothing breaks away three times in a row, when the encoder doesn't count as it did, and
/// when the current sensor drifts.
class BreakawayProcedure : public TimedProcedure {
 public:
  /// All breakaways so far, in the order they were measured; outliers are marked against their neighbours.
  const std::vector<BreakawayEvent>& events() const { return tour_.events(); }
  /// The sensor's zeros on the way: before the first breakaway, every zeroEvery_s, and after the last.
  const std::vector<ZeroReading>& zeros() const { return zeroing_.readings(); }
  /// Places at which it didn't break away.
  size_t missed() const { return missed_; }

 protected:
  /// `earlier` are the breakaways of an interrupted sweep with the same places; they are kept, and what is missing of
  /// the passes is measured.
  BreakawayProcedure(Axis axis, const BreakawayOptions& options, size_t places, size_t passes,
                     const std::vector<BreakawayEvent>& earlier);

  virtual void beginZeroing(const Sample& sample) = 0;
  virtual void goToPlace(const Sample& sample) = 0;
  /// At the tour's place.
  virtual double moving_A(Way way) const = 0;

  Way way() const { return tour_.way(); }
  double sign() const { return tour_.sign(); }
  /// The current that holds the motor in the middle of what friction allows, towards growing angle.
  double hold_A() const { return 0.5 * (moving_A(Way::ccw) - moving_A(Way::cw)); }
  /// What friction takes there beyond holding, in the way's direction.
  double movingOverHold_A() const { return moving_A(way()) - sign() * hold_A(); }

  Command zero(const Sample& sample);
  /// What friction takes on average over all places; 0: not known.
  double usual_A() const;
  /// `expected_A` beyond holding; 0: not known, the ramp is to find it. That may be the little which cogging or an arm
  /// leaves at a place, and wrong by as much as they are: a ramp gives up by what is usual, where that is more.
  RampPlan planRamp(double expected_A) const;
  /// Whether a breakaway came so soon after the ramp's beginning that it is to be made once more from lower.
  bool cameTooSoon(double inRamp_s);
  /// The ramp's breakaway, but for its place; `begun_s`: when the ramp did.
  BreakawayEvent ended(double begun_s) const;
  void take(const BreakawayEvent& event);
  /// It didn't break away up to the ramp's top.
  void miss();
  void advanceStep(const Sample& sample);

  /// `way_s`: that going to a place takes, roughly.
  Progress progressWith(const Saying& activity, double way_s) const;

  BreakawayTour tour_;
  Zeroing zeroing_;
  BreakawayRamp ramp_;
  double stageStart_s_ = 0.0, now_s_ = 0.0, first_s_ = 0.0;
  size_t missed_ = 0;

 private:
  Axis axis_;
  BreakawayOptions shared_;
  size_t missedInARow_ = 0;
  int attempt_ = 0;
  double zeroed_s_ = 0.0;
};

}  // namespace breakaway
