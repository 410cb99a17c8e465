#include "experiment/timed_procedure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace breakaway {

Command TimedProcedure::step(const Sample& sample) {
  if (state_ != State::running) return {};
  first_ = !std::exchange(begun_, true);
  if (first_) {
    start_s_ = sample.time_s;
  } else {
    tick_s_ = sample.time_s - last_s_;
  }
  last_s_ = sample.time_s;
  phase_ = !leg_ ? notBegun : runner_ ? runner_->step(sample) : sample.legPhase;
  if (const Message dead = sensor_.step(sample); !dead.empty()) fail(dead);
  if (state_ != State::running) return {};
  const Command command = run(sample);
  if (state_ != State::running) return {};
  return leg_ && runner_ ? runner_->command() : command;
}

void TimedProcedure::beginLeg(const Leg& leg, double countsPerRev) {
  leg_ = leg;
  phase_ = notBegun;
  ++legNumber_;
  if (legsElsewhere_) return;
  runner_.emplace(countsPerRev);
  runner_->begin(leg);
}

Procedure::Status TimedProcedure::status() const {
  if (state_ == State::finished) return {state_, 1.0, 0.0, {}, failure_};
  if (state_ != State::running) return {state_, begun_ ? progress().part : 0.0, 0.0, {}, failure_};
  Progress now = progress();
  return {state_, now.part, now.remaining_s, std::move(now.activity), failure_};
}

TimedProcedure::Progress TimedProcedure::timed(double gone_s, double whole_s, const Saying& activity) {
  return {whole_s > 0.0 ? std::clamp(gone_s / whole_s, 0.0, 1.0) : 1.0, std::max(0.0, whole_s - gone_s), activity};
}

void TimedProcedure::stop(const Saying& reason) {
  if (state_ != State::running) return;
  state_ = State::stopped;
  failure_ = reason;
}

void TimedProcedure::finish() {
  if (state_ == State::running) state_ = State::finished;
}

void TimedProcedure::fail(const Saying& reason) {
  if (state_ != State::running) return;
  state_ = State::failed;
  failure_ = reason;
}

std::string degreesText(double angle_rad) {
  const double degrees = angle_rad * 180.0 / std::numbers::pi;
  return std::to_string(static_cast<int>(std::floor(degrees - 360.0 * std::floor(degrees / 360.0)))) + "°";
}

Message bodyText(Axis axis) {
  return axis == Axis::linear ? message("the axis") : message("the rotor");
}

Message wayText(bool ccw, Axis axis) {
  if (axis == Axis::linear) return ccw ? message("forwards") : message("backwards");
  return ccw ? message("counter-clockwise") : message("clockwise");
}

Message heavyLoadText(bool ccw, Axis axis) {
  return message(
      "{} keeps moving {} once it is loose, driven by nothing: a load heavier than its friction pulls it; hold or "
      "balance the load, or take it off",
      bodyText(axis), wayText(ccw, axis));
}

}  // namespace breakaway
