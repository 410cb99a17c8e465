#include "experiment/travel_breakaway.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace breakaway {

namespace {
constexpr double usualOverMoving = 1.2;  // breakaway over moving force, before one was measured
constexpr double patience_s = 1.0;       // for it to come to rest
}  // namespace

TravelBreakaway::TravelBreakaway(TravelBreakawayOptions options, const std::vector<BreakawayEvent>& earlier)
    : BreakawayProcedure(Axis::linear, options, options.bins.count, options.passes, earlier),
      options_(std::move(options)),
      watch_(options_.travel, options_.index_m, options_.indexTolerance_m),
      glide_(options_.speed_m_per_s, options_.acceleration_m_per_s2) {
  if (!(options_.count_m > 0.0)) fail(message("the encoder's counts are not known"));
  for (const auto& way : options_.moving_A) {
    if (way.size() != options_.bins.count) fail(message("what keeps the axis moving is not known for each bin"));
  }
  if (state() == State::running && tour_.ended()) finish();
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
  zeroing_.see(sample);
  now_m_ = sample.angle_rad;
  if (isFirst()) {
    first_s_ = sample.time_s;
    enter(Stage::zero, sample);
  }
  if (const Message wrong = watch_.step(sample); !wrong.empty()) fail(wrong);
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

/// Gliding until it is near, by the position loop from there.
Command TravelBreakaway::move(const Sample& sample) {
  const double target_m = options_.bins.centre_m(tour_.bin()), off_m = std::abs(sample.angle_rad - target_m);
  const double tolerance_m = std::max(0.15 * options_.bins.width_m(), 2.0 * options_.count_m);
  const bool near =
      off_m < tolerance_m && std::abs(sample.velocity_rad_per_s) < 2.0 * options_.motionVelocity_rad_per_s;
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
      std::abs(sample.velocity_rad_per_s) < 0.5 * options_.motionVelocity_rad_per_s) {
    enter(Stage::ramp, sample);
    ramp_ = BreakawayRamp(planRamp(expected_A()), sign(), sample.angle_rad, options_.count_m, options_.motionCounts);
  } else if (inStage_s > patience_s) {
    ++missed_;
    advanceStep(sample);
  }
  return current(sign() * hold_A());
}

/// Beyond what holds it; 0: nothing is known.
double TravelBreakaway::expected_A() const {
  const double moving = movingOverHold_A();
  return moving > 0.0 ? overMoving_[static_cast<size_t>(way())].value_or(usualOverMoving) * moving : 0.0;
}

bool TravelBreakaway::moves(const Sample& sample) const {
  const double counts = sign() * (sample.angle_rad - ramp_.standing_rad()) / options_.count_m;
  return counts > static_cast<double>(options_.motionCounts) - 0.5 &&
         sign() * sample.velocity_rad_per_s > options_.motionVelocity_rad_per_s;
}

Command TravelBreakaway::ramp(const Sample& sample) {
  const double part_s = sample.time_s - stageStart_s_;
  ramp_.add({part_s, commanded_A_, sign() * sample.current_A, sample.angle_rad});
  if (moves(sample)) {
    if (cameTooSoon(part_s)) {
      enter(Stage::move, sample);
    } else {
      takeEvent();
      advanceStep(sample);
    }
    return {};
  }
  const double next = ramp_.commandedAt(part_s);
  const bool saturated = std::abs(next) * options_.resistance_ohm + options_.deadZone_V > sample.supply_V;
  if (next <= ramp_.plan().top_A && !saturated) return current(next);
  overMoving_[static_cast<size_t>(way())].reset();
  miss();
  advanceStep(sample);
  return {};
}

void TravelBreakaway::takeEvent() {
  BreakawayEvent event = ended(stageStart_s_);
  event.angle_rad = ramp_.standing_rad();
  const double moving = movingOverHold_A();
  if (moving > 0.0) overMoving_[static_cast<size_t>(way())] = (event.commanded_A - sign() * hold_A()) / moving;
  take(event);
}

Message TravelBreakaway::activity() const {
  const std::string place = millimetresText(now_m_ - options_.travel.low_m);
  switch (stage_) {
    case Stage::zero:
      return zeroingText;
    case Stage::move:
      return message("moving at {} from the lower end", place);
    case Stage::dwell:
      return message("standing at {} from the lower end", place);
    case Stage::ramp:
      return message("ramping {} at {} from the lower end", wayText(sign() > 0.0, Axis::linear), place);
  }
  return {};
}

}  // namespace breakaway
