#include "diagnose/simulate/drive_reading.h"

#include <algorithm>

namespace breakaway {

DriveReading::DriveReading(const Track& track, double late_s) : track_(track), late_s_(late_s) {
  const double rows = track.usualStep_s > 0.0 ? std::clamp(late_s / track.usualStep_s, 0.0, 1.0) : 0.0;
  course_ = 4.0 * rows * (1.0 - rows);
}

std::vector<double> DriveReading::means(size_t first, size_t count) const {
  const std::vector<double>&time = track_.time, &u = track_.input;
  const auto begin = u.begin() + static_cast<std::ptrdiff_t>(first);
  std::vector<double> out(begin, begin + static_cast<std::ptrdiff_t>(count));
  if (late_s_ == 0.0) return out;
  const auto bend = [&u](size_t k) { return k > 0 && k + 1 < u.size() ? u[k - 1] - 2.0 * u[k] + u[k + 1] : 0.0; };
  for (size_t k = first; k < first + count && k + 1 < u.size(); ++k)
    out[k - first] =
        heldMean(time, u, time[k] + late_s_, time[k + 1] + late_s_, k) - course_ / 24.0 * (bend(k) + bend(k + 1));
  return out;
}

double DriveReading::lag(size_t k) const {
  const double dt = track_.time[k + 1] - track_.time[k];
  if (late_s_ < 0.0) {  // steps that fall within the row
    const auto rows = static_cast<size_t>(-late_s_ / dt);
    const double after_s = -late_s_ - static_cast<double>(rows) * dt;
    if (k < rows + 1) return 0.0;
    return 0.5 * after_s * (dt - after_s) * (track_.input[k - rows] - track_.input[k - rows - 1]);
  }
  return course_ * dt * dt / 12.0 * (track_.input[k + 1] - track_.input[k]);
}

}  // namespace breakaway
