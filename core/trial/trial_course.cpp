#include "trial/trial_course.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers.h"

namespace breakaway {

namespace {

/// Writes one stretch of a move into rows [from, to): speed as a fraction of the top speed, shake of the peak torque.
class Stretch {
 public:
  Stretch(TrialCourse& course, size_t from, size_t to, Random& random)
      : course_(course), from_(from), to_(to), random_(random) {}

  void write(TrialMove move) {
    switch (move) {
      case TrialMove::multisine:
        return sines(drawn(random_, 0.5, 0.95), 0.15, 3.0);
      case TrialMove::idle:
        return sines(0.25, 0.3, 0.6);
      case TrialMove::steps:
        return held([this] { return drawn(random_, -1.0, 1.0); }, 0.3, 1.2);
      case TrialMove::reversals:
        return alternating(drawn(random_, 0.15, 0.7), 0.2, 0.6);
      case TrialMove::heavy:
        return alternating(drawn(random_, 0.75, 1.0), 0.12, 0.3);
      case TrialMove::turns:
        return alternating(drawnLog(random_, 0.12, 0.7), 1.2, 2.5);
      case TrialMove::ramps:
        return triangles(drawnLog(random_, 0.05, 0.3), drawn(random_, 1.5, 4.0));
      case TrialMove::rests:
        return moveAndRest();
      case TrialMove::chirp:
        return chirp();
    }
  }

 private:
  double seconds(size_t k) const { return static_cast<double>(k - from_) * course_.row_s; }
  double length() const { return static_cast<double>(to_ - from_) * course_.row_s; }

  void sines(double peak, double lowest_Hz, double highest_Hz) {
    std::array<std::array<double, 2>, 5> waves;
    for (auto& [rate, phase] : waves) {
      rate = turn_rad * drawnLog(random_, lowest_Hz, highest_Hz);
      phase = turn_rad * random_.uniform();
    }
    for (size_t k = from_; k < to_; ++k) {
      double sum = 0.0;
      for (const auto& [rate, phase] : waves) sum += std::sin(rate * seconds(k) + phase);
      course_.velocity[k] = peak * std::clamp(sum / 3.0, -1.0, 1.0);
    }
  }

  template <typename Level>
  void held(Level level, double shortest_s, double longest_s) {
    double value = 0.0, until = 0.0;
    for (size_t k = from_; k < to_; ++k) {
      if (seconds(k) >= until) {
        value = level();
        until += drawn(random_, shortest_s, longest_s);
      }
      course_.velocity[k] = value;
    }
  }

  void alternating(double peak, double shortest_s, double longest_s) {
    double way = drawnSign(random_);
    held([&] { return peak * (way = -way) * drawn(random_, 0.8, 1.0); }, shortest_s, longest_s);
  }

  void triangles(double peak, double period_s) {
    const double way = drawnSign(random_);
    for (size_t k = from_; k < to_; ++k) {
      const double phase = std::fmod(seconds(k) / period_s + 0.25, 1.0);
      course_.velocity[k] = way * peak * (phase < 0.5 ? 4.0 * phase - 1.0 : 3.0 - 4.0 * phase);
    }
  }

  /// A slow start, a short move, then a rest of 0.05 to 3 s.
  void moveAndRest() {
    double begin = 0.0, rest = 0.0, move = 0.0, peak = 0.0, way = 1.0;
    for (size_t k = from_; k < to_; ++k) {
      if (seconds(k) >= begin + rest + move) {
        begin = seconds(k);
        rest = drawnLog(random_, 0.05, 3.0);
        move = drawn(random_, 0.4, 0.9);
        peak = drawn(random_, 0.15, 0.5);
        way = random_.uniform() < 0.65 ? -way : way;
      }
      const double into = seconds(k) - begin - rest;
      course_.velocity[k] = into > 0.0 ? way * peak * std::min({1.0, into / 0.25, (move - into) / 0.05}) : 0.0;
    }
  }

  void chirp() {
    sines(0.35, 0.15, 0.5);
    const double peak = drawn(random_, 0.2, 0.4), low = 2.0, high = 100.0;
    const double growth = std::log(high / low) / length();
    for (size_t k = from_; k < to_; ++k) {
      course_.shake[k] = peak * std::sin(turn_rad * low / growth * (std::exp(growth * seconds(k)) - 1.0));
    }
  }

  TrialCourse& course_;
  size_t from_, to_;
  Random& random_;
};

}  // namespace

TrialCourse drawCourse(const TrialRig& rig, const std::vector<TrialMove>& moves, double duration_s, Random& random) {
  TrialCourse course;
  course.row_s = rig.sensors.row_s;
  const auto rows = static_cast<size_t>(std::lround(duration_s / course.row_s));
  course.velocity.assign(rows, 0.0);
  course.shake.assign(rows, 0.0);
  course.position.assign(rows, 0.0);
  size_t from = static_cast<size_t>(0.2 / course.row_s);
  for (size_t move = 0; from < rows; ++move) {
    const size_t to = std::min(rows, from + static_cast<size_t>(drawn(random, 4.0, 8.0) / course.row_s));
    Stretch(course, from, to, random).write(moves[move % moves.size()]);
    from = to;
  }
  const double reach = 0.55 * rig.peakTorque / rig.physics.totalInertia() * course.row_s;
  const double leak_per_s = rig.shortTravel ? 0.8 : 0.0;
  double velocity = 0.0, position = 0.0;
  for (size_t k = 0; k < rows; ++k) {
    const bool rests = course.velocity[k] == 0.0;
    const double wanted = rests ? 0.0 : rig.topSpeed * course.velocity[k] - leak_per_s * position;
    velocity += std::clamp(wanted - velocity, -reach, reach);
    position += velocity * course.row_s;
    course.velocity[k] = velocity;
    course.position[k] = position;
    course.shake[k] *= rig.peakTorque;
  }
  return course;
}

}  // namespace breakaway
