#include "experiment/travel_breakaway.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <utility>

namespace breakaway {

namespace {
constexpr double shortRamp = 0.15;       // of ramp_s: a breakaway this soon says little about its current
constexpr double usualOverMoving = 1.2;  // breakaway over moving force, before one was measured
constexpr double patience_s = 1.0;       // for it to come to rest
}  // namespace

TravelBreakaway::TravelBreakaway(TravelBreakawayOptions options, const std::vector<BreakawayEvent>& earlier)
    : options_(std::move(options)),
      tour_(options_.bins.count, options_.passes, earlier),
      zeroing_(options_.zeroing_s),
      watch_(options_.travel, options_.index_m, options_.indexTolerance_m),
      glide_(options_.speed_m_per_s, options_.acceleration_m_per_s2) {
  if (options_.bins.count < 8 || options_.passes == 0) fail("at least 8 bins and one pass are needed");
  if (!(options_.resistance_ohm > 0.0)) fail("the winding's resistance is not known");
  if (!(options_.forceConstant_N_per_A > 0.0)) fail("the force constant is not known");
  if (!(options_.count_m > 0.0)) fail("the encoder's counts are not known");
  for (const auto& way : options_.moving_A) {
    if (way.size() != options_.bins.count) fail("what keeps the axis moving is not known for each bin");
  }
  if (state() == State::running && tour_.ended()) finish();
}

double TravelBreakaway::moving_A(Way way) const {
  return options_.moving_A[static_cast<size_t>(way)][tour_.bin()];
}

Command TravelBreakaway::current(double inWay_A) {
  commanded_A_ = inWay_A;
  const double amps = sign() * inWay_A;
  const double volts = amps == 0.0 ? 0.0 : amps * options_.resistance_ohm + std::copysign(options_.deadZone_V, amps);
  return {Command::Mode::voltage, volts, options_.current_limit_A, false};
}

void TravelBreakaway::enter(Stage stage, const Sample& sample) {
  stage_ = stage;
  stageStart_s_ = near_s_ = sample.time_s;
  if (stage != Stage::move) return;
  glide_.rest();
  const double way_m = std::abs(options_.bins.centre_m(tour_.bin()) - sample.angle_rad);
  allowed_s_ = options_.move_s + 2.0 * way_m / options_.speed_m_per_s;
}

Command TravelBreakaway::run(const Sample& sample) {
  now_s_ = sample.time_s;
  now_m_ = sample.angle_rad;
  if (!begun_) {
    begun_ = true;
    first_s_ = sample.time_s;
    enter(Stage::zero, sample);
  }
  if (const std::string wrong = watch_.step(sample); !wrong.empty()) fail(wrong);
  switch (stage_) {
    case Stage::zero:
      return zero(sample);
    case Stage::move:
      return move(sample);
    case Stage::dwell:
      return dwell(sample);
    case Stage::ramp:
      return ramp(sample);
  }
  return {};
}

Command TravelBreakaway::zero(const Sample& sample) {
  bool done = false;
  const Command command = zeroing_.step(sample, stageStart_s_, done);
  if (!done) return command;
  zeroed_s_ = sample.time_s;
  if (const std::string moved = zeroing_.moved(options_.mostDrift_A); !moved.empty()) fail(moved);
  if (tour_.ended()) {
    finish();
  } else {
    enter(Stage::move, sample);
  }
  return command;
}

/// Gliding until it is near, by the position loop from there.
Command TravelBreakaway::move(const Sample& sample) {
  const double target_m = options_.bins.centre_m(tour_.bin()), off_m = std::abs(sample.angle_rad - target_m);
  const double tolerance_m = std::max(0.15 * options_.bins.width_m(), 2.0 * options_.count_m);
  const bool near = off_m < tolerance_m && std::abs(sample.velocity_rad_per_s) < 2.0 * options_.motionVelocity_m_per_s;
  if (!near) near_s_ = sample.time_s;
  if (sample.time_s - near_s_ > 0.03 || sample.time_s - stageStart_s_ > allowed_s_) {
    enter(Stage::dwell, sample);
    return current(sign() * hold_A());
  }
  if (off_m > 2.0 * options_.bins.width_m())
    return {Command::Mode::velocity, glide_.next(sample.angle_rad, target_m, tick_s()), options_.current_limit_A,
            false};
  return {Command::Mode::position, target_m, options_.current_limit_A, false};
}

Command TravelBreakaway::dwell(const Sample& sample) {
  const double inStage_s = sample.time_s - stageStart_s_;
  if (inStage_s > options_.settle_s + options_.dwell_s &&
      std::abs(sample.velocity_rad_per_s) < 0.5 * options_.motionVelocity_m_per_s) {
    enter(Stage::ramp, sample);
    ramp_ = BreakawayRamp(planRamp(), sign(), sample.angle_rad, options_.count_m, options_.motionCounts);
  } else if (inStage_s > patience_s) {
    ++missed_;
    advanceStep(sample);
  }
  return current(sign() * hold_A());
}

RampPlan TravelBreakaway::planRamp() const {
  const double hold = sign() * hold_A();
  const double limit = options_.current_limit_A > 0.0 ? options_.current_limit_A : 1e3;
  const double moving = moving_A(way()) - hold;
  if (moving <= 0.0) return {hold, 0.0, limit, true};
  const double expected = overMoving_[static_cast<size_t>(way())].value_or(usualOverMoving) * moving;
  const double starts[] = {options_.rampStart, 0.5 * options_.rampStart, 0.0};
  return {hold + starts[std::min(attempt_, 2)] * expected, (1.0 - options_.rampStart) * expected / options_.ramp_s,
          std::min(limit, hold + options_.mostOverExpected * expected), false};
}

bool TravelBreakaway::moves(const Sample& sample) const {
  const double counts = sign() * (sample.angle_rad - ramp_.standing_rad()) / options_.count_m;
  return counts > static_cast<double>(options_.motionCounts) - 0.5 &&
         sign() * sample.velocity_rad_per_s > options_.motionVelocity_m_per_s;
}

Command TravelBreakaway::ramp(const Sample& sample) {
  const double part_s = sample.time_s - stageStart_s_;
  ramp_.add({part_s, commanded_A_, sign() * sample.current_A, sample.angle_rad});
  if (moves(sample)) {
    if (!ramp_.plan().learning && part_s < shortRamp * options_.ramp_s && attempt_ < 2) {
      ++attempt_;  // the start was too high: come back and begin lower
      enter(Stage::move, sample);
    } else {
      takeEvent();
      advanceStep(sample);
    }
    return {};
  }
  const double next = ramp_.commandedAt(part_s), most = ramp_.plan().top_A;
  const bool saturated = std::abs(next) * options_.resistance_ohm + options_.deadZone_V > sample.supply_V;
  if (next <= most && !saturated) return current(next);
  ++missed_;
  overMoving_[static_cast<size_t>(way())].reset();
  if (++missedInARow_ >= 3) {
    fail(fmt::format("the axis does not break away {} at up to {:.2f} A, three times in a row; is it held?",
                     wayText(sign() > 0.0, Axis::linear), most));
  }
  advanceStep(sample);
  return {};
}

void TravelBreakaway::takeEvent() {
  const BreakawayLag motor{options_.mass_kg, options_.forceConstant_N_per_A, options_.backEmfConstant_V_s_per_m,
                           options_.resistance_ohm};
  BreakawayEvent event = ramp_.event(motor, tick_s());
  event.time_s += stageStart_s_;
  event.zero_A = zeroing_.zero_A();
  event.angle_rad = ramp_.standing_rad();
  event.torque_Nm = options_.forceConstant_N_per_A * event.current_A;
  const double moving = moving_A(way()) - sign() * hold_A();
  if (moving > 0.0) overMoving_[static_cast<size_t>(way())] = (event.commanded_A - sign() * hold_A()) / moving;
  missedInARow_ = 0;
  tour_.take(event);
}

void TravelBreakaway::advanceStep(const Sample& sample) {
  tour_.advance();
  attempt_ = 0;
  enter(tour_.ended() || sample.time_s - zeroed_s_ > options_.zeroEvery_s ? Stage::zero : Stage::move, sample);
}

double TravelBreakaway::progress() const {
  return tour_.progress();
}

double TravelBreakaway::remaining_s() const {
  return tour_.remaining_s(now_s_ - first_s_, options_.settle_s + options_.dwell_s + options_.ramp_s + 0.3);
}

std::string TravelBreakaway::activity() const {
  const std::string where = "at " + millimetresText(now_m_ - options_.travel.low_m) + " from the lower end";
  switch (stage_) {
    case Stage::zero:
      return "zeroing the current sensor";
    case Stage::move:
      return "moving " + where;
    case Stage::dwell:
      return "standing " + where;
    case Stage::ramp:
      return "ramping " + wayText(sign() > 0.0, Axis::linear) + " " + where;
  }
  return {};
}

}  // namespace breakaway
