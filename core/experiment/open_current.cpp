#include "experiment/open_current.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr double sure = 4.0;  // standard errors, beyond which a move is no noise

}  // namespace

void OpenCurrent::begin() {
  sum_A_ = squares_A2_ = 0.0;
  samples_ = 0;
}

void OpenCurrent::take(const Sample& sample) {
  if (sample.enabled) return;
  if (samples_ == 0) start_s_ = sample.time_s;
  sum_A_ += sample.current_A;
  squares_A2_ += sample.current_A * sample.current_A;
  ++samples_;
}

Message OpenCurrent::moved(double most_A) {
  if (samples_ == 0) return {};
  const auto n = static_cast<double>(samples_);
  const double mean_A = sum_A_ / n;
  const double error_A = std::sqrt(std::max(0.0, squares_A2_ / n - mean_A * mean_A) / n);
  const double noise_A = sure * std::hypot(error_A, beforeError_A_);
  const double move_A = known_ ? mean_A - before_A_ : 0.0, passed_s = start_s_ - before_s_;
  known_ = true;
  before_A_ = mean_A;
  beforeError_A_ = error_A;
  before_s_ = start_s_;
  begin();
  return zeroMoved(move_A, passed_s, std::max(most_A, noise_A));
}

Message zeroMoved(double move_A, double passed_s, double most_A) {
  if (std::abs(move_A) <= most_A) return {};
  return message(
      "the current sensor's zero moved by {:.3f} A within {:.1f} s, more than {:.2f} A; let the bench come to a steady "
      "temperature, or check the sensor, then go on",
      move_A, passed_s, most_A);
}

}  // namespace breakaway
