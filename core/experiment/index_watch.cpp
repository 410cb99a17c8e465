#include "experiment/index_watch.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace breakaway {

double indexTolerance_rad(double countsPerRev) {
  const double half_degree_rad = turn_rad / 720.0;
  return half_degree_rad + (countsPerRev > 0.0 ? 8.0 * turn_rad / countsPerRev : 0.0);
}

double IndexWatch::fromIndex(double angle_rad) const {
  const double off_rad = angle_rad - index_rad_;
  return axis_ == Axis::linear ? off_rad : std::remainder(off_rad, turn_rad);
}

/// Whole turns from the index; on a linear axis whether it lies below.
double IndexWatch::sideOf(double angle_rad) const {
  const double off_rad = angle_rad - index_rad_;
  return axis_ == Axis::linear ? (off_rad < 0.0 ? -1.0 : 0.0) : std::floor(off_rad / turn_rad);
}

Message IndexWatch::step(const Sample& sample) {
  if (!(tolerance_rad_ > 0.0)) return {};
  if (!begun_) before_rad_ = sample.angle_rad;
  begun_ = true;
  const double middle_rad = 0.5 * (before_rad_ + sample.angle_rad);
  const double room_rad = 0.5 * std::abs(sample.angle_rad - before_rad_) + tolerance_rad_;
  before_rad_ = sample.angle_rad;
  if (sample.index) {
    seen_ = true;
    const double off_rad = fromIndex(middle_rad);
    if (std::abs(off_rad) <= room_rad) return {};
    const std::string off = axis_ == Axis::linear ? fmt::format("{:.2f} mm", 1e3 * off_rad)
                                                  : fmt::format("{:.1f}°", off_rad * (360.0 / turn_rad));
    return message("the index came {} from where homing found it: the encoder lost counts; home again, then go on",
                   off);
  }
  if (std::abs(fromIndex(sample.angle_rad)) <= tolerance_rad_) return {};
  const double side = sideOf(sample.angle_rad);
  const bool missed = besideOnce_ && side != side_ && !seen_;
  side_ = side;
  besideOnce_ = true;
  seen_ = false;
  if (!missed) return {};
  return message(
      "the index did not come where homing found it; check the encoder's index wire, and whether its counts per turn "
      "still hold (A and B, coupling); home again, then go on");
}

}  // namespace breakaway
