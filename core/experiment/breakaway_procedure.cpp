#include "experiment/breakaway_procedure.h"

#include <algorithm>
#include <iterator>

#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr double shortRamp = 0.15;                // of ramp_s: a breakaway this soon says little about its current
constexpr double rampStarts[] = {1.0, 0.5, 0.0};  // of rampStart, attempt by attempt

}  // namespace

BreakawayProcedure::BreakawayProcedure(Axis axis, const BreakawayOptions& options, size_t places, size_t passes,
                                       const std::vector<BreakawayEvent>& earlier)
    : tour_(places, passes, earlier), zeroing_(options.zeroing_s), axis_(axis), shared_(options) {
  if (places < 8 || passes == 0) fail(message("at least 8 bins and one pass are needed"));
  if (!(options.resistance_ohm > 0.0)) fail(message("the winding's resistance is not known"));
  if (!(options.torqueConstant_Nm_per_A > 0.0))
    fail(axis == Axis::linear ? message("the force constant is not known")
                              : message("the torque constant is not known"));
}

Command BreakawayProcedure::zero(const Sample& sample) {
  bool done = false;
  const Command command = zeroing_.step(sample, stageStart_s_, done);
  if (!done) return command;
  zeroed_s_ = sample.time_s;
  if (const Message moved = zeroing_.moved(shared_.mostDrift_A); !moved.empty()) fail(moved);
  if (tour_.ended()) {
    finish();
  } else {
    goToPlace(sample);
  }
  return command;
}

double BreakawayProcedure::usual_A() const {
  const auto& ways = shared_.moving_A;
  return ways[0].empty() || ways[1].empty() ? 0.0 : 0.5 * (mean(ways[0]) + mean(ways[1]));
}

RampPlan BreakawayProcedure::planRamp(double expected_A) const {
  const double hold = sign() * hold_A();
  const double limit = shared_.current_limit_A > 0.0 ? shared_.current_limit_A : 1e3;
  if (expected_A <= 0.0) return {hold, 0.0, limit, true};
  const double from = rampStarts[attempt_] * shared_.rampStart;
  return {hold + from * expected_A, (1.0 - shared_.rampStart) * expected_A / shared_.ramp_s,
          std::min(limit, hold + shared_.mostOverExpected * std::max(expected_A, usual_A())), false};
}

bool BreakawayProcedure::cameTooSoon(double inRamp_s) {
  const bool again = !ramp_.plan().learning && inRamp_s < shortRamp * shared_.ramp_s &&
                     attempt_ + 1 < static_cast<int>(std::size(rampStarts));
  if (again) ++attempt_;
  return again;
}

BreakawayEvent BreakawayProcedure::ended(double begun_s) const {
  const BreakawayLag motor{shared_.inertia_kg_m2,
                           shared_.torqueConstant_Nm_per_A,
                           shared_.backEmfConstant_V_s_per_rad,
                           shared_.resistance_ohm,
                           0.0,
                           shared_.windingTime_s};
  BreakawayEvent event = ramp_.event(motor, tick_s());
  event.time_s += begun_s;
  event.zero_A = zeroing_.zero_A();
  event.torque_Nm = shared_.torqueConstant_Nm_per_A * event.current_A;
  return event;
}

void BreakawayProcedure::take(const BreakawayEvent& event) {
  missedInARow_ = 0;
  tour_.take(event);
}

void BreakawayProcedure::miss() {
  ++missed_;
  if (++missedInARow_ < 3) return;
  fail(message("{} does not break away {} at up to {:.2f} A, three times in a row; is {} held?", bodyText(axis_),
               wayText(sign() > 0.0, axis_), ramp_.plan().top_A,
               axis_ == Axis::linear ? message("it") : message("the shaft")));
}

void BreakawayProcedure::advanceStep(const Sample& sample) {
  tour_.advance();
  attempt_ = 0;
  if (tour_.ended() || sample.time_s - zeroed_s_ > shared_.zeroEvery_s) {
    beginZeroing(sample);
  } else {
    goToPlace(sample);
  }
}

TimedProcedure::Progress BreakawayProcedure::progressWith(const Saying& activity, double way_s) const {
  const double usual_s = shared_.settle_s + shared_.dwell_s + shared_.ramp_s + way_s;
  return {tour_.progress(), tour_.remaining_s(now_s_ - first_s_, usual_s), activity};
}

}  // namespace breakaway
