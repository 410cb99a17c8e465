#include "diagnose/simulate/followed_load.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr double longerSteps = 5.0;  // than the effect's own longest: the motor's motion is given

double speedAt(const Track& track, size_t row) {
  return (track.position[row + 1] - track.position[row]) / (track.time[row + 1] - track.time[row]);
}

double middleOf(const Track& track, size_t row) {
  return 0.5 * (track.time[row] + track.time[row + 1]);
}

}  // namespace

FollowedLoad::FollowedLoad(const Effect& effect, std::span<const double> parameters, const Track& track, size_t row)
    : effect_(effect),
      load_(*effect.load()),
      parameters_(parameters.begin(), parameters.end()),
      track_(track),
      row_(row),
      size_(load_.size()),
      longest_s_(longerSteps * effect.longestStep_s(parameters)),
      now_s_(middleOf(track, row)),
      motor_(speedAt(track, row)) {
  load_.place(0.0, 0.0, motor_, now_s_, std::span(memory_).first(size_));
}

void FollowedLoad::advance() {
  ++row_;
  const double next_s = middleOf(track_, row_), next = speedAt(track_, row_), dt = next_s - now_s_;
  const auto parts = std::clamp(static_cast<int>(std::ceil(dt / longest_s_)), 1, 50);
  for (int part = 1; part <= parts; ++part) {
    const double share = static_cast<double>(part) / parts;
    const std::array<double, 8> before = memory_;
    Situation at;
    at.time_s = now_s_ + share * dt;
    at.velocity = (1.0 - share) * motor_ + share * next;
    at.memory = std::span(before).first(size_);
    load_.remember(parameters_, at, dt / parts, std::span(memory_).first(size_));
  }
  now_s_ = next_s;
  motor_ = next;
}

double FollowedLoad::torque() const {
  Situation at;
  at.time_s = now_s_;
  at.velocity = motor_;
  at.memory = std::span(memory_).first(size_);
  return effect_.term(parameters_, at).load_Nm;
}

}  // namespace breakaway
