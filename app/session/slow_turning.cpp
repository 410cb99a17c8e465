#include "session/slow_turning.h"

#include <cmath>

#include "base/numbers.h"

namespace breakaway {

Command SlowTurning::step(const Sample& sample) {
  if (status_.state != State::running) return {};
  if (!start_s_) start_s_ = sample.time_s;
  const double phase = turn_rad * (sample.time_s - *start_s_) / options_.period_s;
  return {Command::Mode::velocity, options_.amplitude_rad_per_s * std::sin(phase)};
}

void SlowTurning::stop(const std::string& reason) {
  if (status_.state != State::running) return;
  status_.state = State::stopped;
  status_.activity = "stopped";
  status_.failure = reason;
}

}  // namespace breakaway
