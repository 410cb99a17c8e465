#include "session/slow_strokes.h"

namespace breakaway {

namespace {

constexpr double most_m_per_s = 0.05;
constexpr double stroke_s = 4.0;  // at least, from place to place
constexpr double speedUp_s = 0.2;
constexpr double near = 0.01;  // of the travel

}  // namespace

SlowStrokes::SlowStrokes(const Travel& travel, double tick_s) : travel_(travel), tick_s_(tick_s) {
  const double speed_m_per_s = std::min(most_m_per_s, 0.5 * travel.usable_m() / stroke_s);
  glide_ = Glide(speed_m_per_s, speed_m_per_s / speedUp_s);
}

Command SlowStrokes::step(const Sample& sample) {
  if (status_.state != State::running) return {};
  const double target_m = travel_.middle_m() + way_ * 0.25 * travel_.usable_m();
  if (way_ * (sample.angle_rad - target_m) > -near * travel_.usable_m()) way_ = -way_;
  return {Command::Mode::velocity, glide_.next(sample.angle_rad, target_m, tick_s_), 0.0, false};
}

void SlowStrokes::stop(const std::string& reason) {
  if (status_.state != State::running) return;
  status_.state = State::stopped;
  status_.activity = "stopped";
  status_.failure = reason;
}

}  // namespace breakaway
