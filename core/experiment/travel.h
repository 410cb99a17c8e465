// A linear axis' travel: its ends, and how one moves between them without coming near.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "base/message.h"
#include "experiment/index_watch.h"

namespace breakaway {

/// As the encoder counts it.
struct Travel {
  double low_m = 0.0, high_m = 0.0;  ///< where the stops were felt
  double margin_m = 0.0;             ///< that procedures keep from them

  double first_m() const { return low_m + margin_m; }
  double last_m() const { return high_m - margin_m; }
  double usable_m() const { return last_m() - first_m(); }
  double middle_m() const { return 0.5 * (low_m + high_m); }
};

/// Speeds towards a place with bounded speed and acceleration, tick by tick.
class Glide {
 public:
  Glide() = default;
  Glide(double speed_m_per_s, double acceleration_m_per_s2)
      : speed_(speed_m_per_s), acceleration_(acceleration_m_per_s2) {}

  /// The next tick's speed; it can come to rest at the place with three quarters of the acceleration.
  double next(double position_m, double target_m, double tick_s) {
    const double left_m = target_m - position_m;
    const double wanted = std::copysign(std::min(speed_, std::sqrt(1.5 * acceleration_ * std::abs(left_m))), left_m);
    const double step = acceleration_ * tick_s;
    now_ = std::clamp(wanted, now_ - step, now_ + step);
    return now_;
  }
  double acceleration_m_per_s2() const { return acceleration_; }
  double speed_m_per_s() const { return speed_; }
  void rest() { now_ = 0.0; }

 private:
  double speed_ = 0.0, acceleration_ = 0.0, now_ = 0.0;
};

/// Whether the encoder still counts as it did when ends and index were found.
class TravelWatch {
 public:
  /// `index_m`: from homing, with `tolerance_m`; a tolerance of 0: there is no index.
  TravelWatch(const Travel& travel, double index_m, double tolerance_m)
      : travel_(travel), index_(index_m, tolerance_m, Axis::linear) {}

  /// Takes every sample; what is wrong in words, empty as long as nothing is.
  Message step(const Sample& sample) {
    const double beyond_m = std::max(travel_.low_m - sample.angle_rad, sample.angle_rad - travel_.high_m);
    if (beyond_m > 0.5 * travel_.margin_m)
      return message(
          "the axis is beyond the ends that were felt: the encoder lost counts; search the ends again, then go on");
    return index_.step(sample);
  }

 private:
  Travel travel_;
  IndexWatch index_;
};

/// "12.3 mm" of a length in m.
std::string millimetresText(double length_m);
/// Tolerance between two sights of the index of an encoder with counts of that length.
double indexTolerance_m(double count_m);

}  // namespace breakaway
