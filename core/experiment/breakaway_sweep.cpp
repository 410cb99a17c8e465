#include "experiment/breakaway_sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr double beyondIndex_rad = 0.1;
constexpr double indexMove_s = 3.0;

double inTurn(double angle_rad) {
  return angle_rad - turn_rad * std::floor(angle_rad / turn_rad);
}

}  // namespace

BreakawaySweep::BreakawaySweep(BreakawaySweepOptions options, const std::vector<BreakawayEvent>& earlier)
    : BreakawayProcedure(Axis::rotary, options, options.bins, options.turns, earlier),
      options_(std::move(options)),
      index_(options_.indexAngle_rad, options_.indexTolerance_rad) {
  if (!(options_.countsPerRev > 0.0)) fail(message("the encoder's counts are not known"));
  if (state() == State::running && tour_.ended()) finish();
}

double BreakawaySweep::binAngle_rad() const {
  return (static_cast<double>(tour_.bin()) + 0.5) * turn_rad / static_cast<double>(options_.bins);
}

double BreakawaySweep::moving_A(Way way) const {
  const auto& table = options_.moving_A[static_cast<size_t>(way)];
  if (table.empty()) return 0.0;
  const double place = inTurn(binAngle_rad()) / turn_rad * static_cast<double>(table.size());
  return table[std::min(static_cast<size_t>(place), table.size() - 1)];
}

/// Beyond what holds it; 0: nothing is known yet.
double BreakawaySweep::expected_A() const {
  const auto w = static_cast<size_t>(way());
  const double moving = movingOverHold_A();
  if (moving > 0.0) return recentOverMoving_[w].value_or(1.0) * moving;
  return recent_A_[w].value_or(options_.expected_A[w]);
}

void BreakawaySweep::enter(Stage stage, const Sample& sample) {
  stage_ = stage;
  stageStart_s_ = sample.time_s;
  indexFrom_rad_ = sample.angle_rad;
  if (stage == Stage::angle) begin(sample);
}

/// The leg at the step's angle.
void BreakawaySweep::begin(const Sample& sample) {
  // The nearest turn in which the target lies ahead in the way, with a margin for a rotor that has just run past it.
  const double wanted = binAngle_rad() + options_.indexAngle_rad;
  target_rad_ = wanted - turn_rad * std::round((wanted - sample.angle_rad) / turn_rad);
  BreakawayPlan<double> plan;
  plan.near_rad =
      std::max(0.15 * turn_rad / static_cast<double>(options_.bins), 2.0 * turn_rad / options_.countsPerRev);
  plan.nearSpeed_rad_per_s = 0.3;
  plan.near_s = 0.03;
  plan.move_s = options_.move_s;
  plan.dwell_s = options_.settle_s + options_.dwell_s;
  plan.mostDwell_s = 1.0;
  plan.restSpeed_rad_per_s = 0.5 * options_.motionVelocity_rad_per_s;
  plan.growing = way() == Way::ccw;
  plan.hold_A = sign() * hold_A();
  plan.resistance_ohm = options_.resistance_ohm;
  plan.deadZone_V = options_.deadZone_V;
  plan.ramp = planned_ = planRamp(expected_A());
  plan.motionCounts = static_cast<std::uint16_t>(std::min<size_t>(options_.motionCounts, 10'000));
  plan.motionSpeed_rad_per_s = options_.motionVelocity_rad_per_s;
  commanded_A_ = plan.hold_A;
  seen_ = notBegun;
  rampSeen_ = false;
  beginLeg({plan, target_rad_, options_.current_limit_A}, options_.countsPerRev);
}

Command BreakawaySweep::run(const Sample& sample) {
  now_s_ = sample.time_s;
  zeroing_.see(sample);
  boardAngle_rad_ = sample.angle_rad;
  if (isFirst()) {
    first_s_ = sample.time_s;
    enter(Stage::zero, sample);
  }
  if (const Message wrong = index_.step(sample); !wrong.empty()) fail(wrong);
  switch (stage_) {
    case Stage::zero:
      return zero(sample);
    case Stage::index:
      return passIndex(sample);
    case Stage::angle:
      follow(sample);
      return {};
  }
  return {};
}

/// Takes the ramp's rows as the leg goes through its stages.
void BreakawaySweep::follow(const Sample& sample) {
  const LegPhase before = std::exchange(seen_, legPhase());
  leastTick_s_ = leastTick_s_ > 0.0 ? std::min(leastTick_s_, tick_s()) : tick_s();
  if (seen_ == Machine::ramp && before != Machine::ramp) {
    rampStart_s_ = sample.time_s;
    ramp_ = BreakawayRamp(planned_, sign(), sample.angle_rad, turn_rad / options_.countsPerRev, options_.motionCounts);
    rampSeen_ = tick_s() < 1.5 * leastTick_s_;
  } else if (before == Machine::ramp) {
    ramp_.add({sample.time_s - rampStart_s_, commanded_A_, sign() * sample.current_A, sample.angle_rad});
    commanded_A_ = ramp_.commandedAt(sample.time_s - rampStart_s_);
  }
  if (legHasEnded(seen_)) end(sample);
}

void BreakawaySweep::end(const Sample& sample) {
  endLeg();
  if (seen_ == Machine::broke) {
    // Samples of it may have been lost on the way.
    if (ramp_.empty() || !rampSeen_ || cameTooSoon(sample.time_s - rampStart_s_)) return begin(sample);
    takeEvent();
  } else if (seen_ == Machine::restless) {
    ++missed_;
  } else {
    // What was expected may have been wrong.
    recent_A_[static_cast<size_t>(way())].reset();
    recentOverMoving_[static_cast<size_t>(way())].reset();
    miss();
  }
  advanceStep(sample);
}

void BreakawaySweep::goToPlace(const Sample& sample) {
  const size_t pass = tour_.oneWay();
  const bool passes = options_.indexTolerance_rad > 0.0 && indexPass_ != pass;
  indexPass_ = pass;
  enter(passes ? Stage::index : Stage::angle, sample);
}

/// To the other side of the index than the pass begins at.
Command BreakawaySweep::passIndex(const Sample& sample) {
  const double beyond_rad = options_.indexAngle_rad - sign() * (options_.indexTolerance_rad + beyondIndex_rad);
  target_rad_ = beyond_rad - turn_rad * std::round((beyond_rad - indexFrom_rad_) / turn_rad);
  const bool there = std::abs(sample.angle_rad - target_rad_) < 0.5 * beyondIndex_rad;
  if (there || sample.time_s - stageStart_s_ > indexMove_s) enter(Stage::angle, sample);
  return {Command::Mode::position, target_rad_, options_.current_limit_A, false};
}

void BreakawaySweep::takeEvent() {
  BreakawayEvent event = ended(rampStart_s_);
  event.angle_rad = inTurn(ramp_.standing_rad() - options_.indexAngle_rad);
  const auto w = static_cast<size_t>(way());
  const double moving = movingOverHold_A();
  recent_A_[w] = event.commanded_A - sign() * hold_A();
  if (moving > 0.0) recentOverMoving_[w] = *recent_A_[w] / moving;
  take(event);
}

Message BreakawaySweep::activity() const {
  const std::string angle = degreesText(boardAngle_rad_ - options_.indexAngle_rad);
  switch (stage_) {
    case Stage::zero:
      return zeroingText;
    case Stage::index:
      return message("passing the index");
    case Stage::angle:
      break;
  }
  switch (seen_) {
    case Machine::stand:
      return message("standing at {}", angle);
    case Machine::ramp:
      return message("ramping {} at {}, turn {}", wayText(sign() > 0.0), angle, tour_.pass() + 1);
    default:
      return message("moving {} at {}", wayText(sign() > 0.0), angle);
  }
}

}  // namespace breakaway
