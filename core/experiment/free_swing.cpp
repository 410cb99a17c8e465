#include "experiment/free_swing.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace breakaway {

namespace {
constexpr size_t leastSwings = 4;
constexpr double leastCounts = 3.0, turningCounts = 1.5;
constexpr double alikeCounts = 1.6, alikePart = 0.1;
}  // namespace

void FreeSwing::begin() {
  begun_ = false;
  way_ = 0;
  swings_.clear();
}

void FreeSwing::take(const Sample& sample) {
  const double angle = sample.angle_rad;
  if (!begun_) {
    begun_ = true;
    last_ = extreme_ = turned_ = angle;
    return;
  }
  const double step = std::abs(angle - last_);
  last_ = angle;
  if (step > 0.0) count_ = count_ > 0.0 ? std::min(count_, step) : step;
  const double back = turningCounts * count_;
  if (way_ == 0 && std::abs(angle - extreme_) > back) way_ = angle > extreme_ ? 1 : -1;
  if (way_ == 0) return;
  if (way_ * (angle - extreme_) > 0.0) extreme_ = angle;
  if (way_ * (extreme_ - angle) <= back) return;
  // The first is how it came to the gap's end.
  swings_.push_back(std::abs(extreme_ - turned_));
  turned_ = extreme_;
  extreme_ = angle;
  way_ = -way_;
}

Message FreeSwing::words() const {
  if (swings_.size() < leastSwings + 1) return {};
  const auto [least, most] = std::minmax_element(swings_.begin() + 1, swings_.begin() + 1 + leastSwings);
  if (*least < leastCounts * count_ || *most - *least > std::max(alikeCounts * count_, alikePart * *most)) return {};
  const std::string gap = axis_ == Axis::linear ? fmt::format("{:.2g} mm", 1e3 * *most)
                                                : fmt::format("{:.2g}°", *most * 180.0 / std::numbers::pi);
  return message(
      "with the windings open the encoder swings to and fro by {} between fixed ends: there is play, or something "
      "soft, between motor and encoder; tighten or replace the coupling",
      gap);
}

}  // namespace breakaway
