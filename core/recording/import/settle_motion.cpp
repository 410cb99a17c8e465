#include "recording/import/settle_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/numbers.h"

namespace breakaway {

namespace {

/// Calls `use(k, from)` for each pair of neighbouring rows that are there and between which no pause lies.
template <typename Use>
void forEachStep(const std::vector<double>& values, const std::vector<size_t>& pauses, Use use) {
  size_t next = 0, last = values.size();
  for (size_t k = 0; k < values.size(); ++k) {
    while (next < pauses.size() && pauses[next] < k) ++next;
    if (next < pauses.size() && pauses[next] == k) last = values.size();
    if (!std::isfinite(values[k])) continue;
    if (last < k) use(k, last);
    last = k;
  }
}

std::pair<double, double> extremes(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return {low, high};
}

}  // namespace

bool areWhole(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return !std::isfinite(v) || v == std::floor(v); });
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) most = std::max(most, std::abs(value));
  }
  return most;
}

double rangeOf(const std::vector<double>& values) {
  const auto [low, high] = extremes(values);
  return high >= low ? high - low : 0.0;
}

std::optional<double> periodOf(const std::vector<double>& angle, const std::vector<size_t>& pauses,
                               std::optional<double> expected) {
  const auto [low, high] = extremes(angle);
  const double range = high - low;
  if (!(range > 0.0) || !std::isfinite(range)) return std::nullopt;
  size_t leaps = 0;
  double largestOther = 0.0;
  forEachStep(angle, pauses, [&](size_t k, size_t from) {
    const double step = std::abs(angle[k] - angle[from]);
    if (step > 0.5 * range) {
      ++leaps;
    } else {
      largestOther = std::max(largestOther, step);
    }
  });
  if (leaps == 0 || leaps > angle.size() / 2) return std::nullopt;
  // The period is the expected one, or the next of the usual ones above the range.
  for (const double period :
       {expected.value_or(1.0), 1.0, turn_rad, 360.0, 1024.0, 2000.0, 2048.0, 4000.0, 4096.0, 8000.0, 8192.0, 10000.0,
        16384.0, 32768.0, 36000.0, 65536.0, 131072.0, 262144.0, 1048576.0}) {
    if (range > 1.001 * period || range < 0.86 * period) continue;
    const bool fromZero = low > -0.05 * period, aboutZero = std::abs(high + low) < 0.2 * period;
    bool all = fromZero || aboutZero;
    forEachStep(angle, pauses, [&](size_t k, size_t from) {
      const double step = std::abs(angle[k] - angle[from]);
      if (step > 0.5 * range && period - step > 0.5 * period) all = false;
    });
    if (all) return period;
  }
  return std::nullopt;
}

Unwound unwind(std::vector<double>& angle, double period, const std::vector<size_t>& pauses) {
  Unwound unwound;
  double turns = 0.0, last = std::numeric_limits<double>::quiet_NaN();
  size_t next = 0;
  for (size_t k = 0; k < angle.size(); ++k) {
    while (next < pauses.size() && pauses[next] < k) ++next;
    if (next < pauses.size() && pauses[next] == k) last = std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(angle[k])) continue;
    const double wrapped = angle[k];
    if (std::isfinite(last)) {
      const double step = (wrapped - last) / period, add = std::round(step);
      if (add != 0.0) ++unwound.places;
      turns -= add * period;
      unwound.largestStep = std::max(unwound.largestStep, std::abs(step - add));
    }
    last = wrapped;
    angle[k] = wrapped + turns;
  }
  return unwound;
}

std::optional<MotionFactor> compareMotion(const std::vector<double>& time_s, const std::vector<double>& angle,
                                          const std::vector<double>& speed, const std::vector<size_t>& pauses) {
  // Steps of several rows: a coarse encoder's single steps say little.
  const size_t stride = std::max<size_t>(1, std::min<size_t>(10, angle.size() / 20));
  double both = 0.0, speeds = 0.0, angles = 0.0, way = 0.0, travelled = 0.0;
  size_t start = 0, next = 0;
  for (size_t k = 1; k < angle.size(); ++k) {
    while (next < pauses.size() && pauses[next] < k) ++next;
    const bool pause = next < pauses.size() && pauses[next] == k;
    const bool there = std::isfinite(angle[k]) && std::isfinite(angle[k - 1]) && std::isfinite(speed[k]) &&
                       std::isfinite(speed[k - 1]);
    if (pause || !there) {
      start = k;
      way = travelled = 0.0;
      continue;
    }
    way += 0.5 * (speed[k] + speed[k - 1]) * (time_s[k] - time_s[k - 1]);
    travelled = angle[k] - angle[start];
    if (k - start < stride) continue;
    both += way * travelled;
    speeds += way * way;
    angles += travelled * travelled;
    start = k;
    way = 0.0;
  }
  if (!(speeds > 0.0) || !(angles > 0.0)) return std::nullopt;
  return MotionFactor{both / speeds, both / std::sqrt(speeds * angles)};
}

Likeness likenessOf(const std::vector<double>& one, const std::vector<double>& other) {
  double both = 0.0, first = 0.0, second = 0.0;
  for (size_t k = 0; k < one.size(); ++k) {
    if (!std::isfinite(one[k]) || !std::isfinite(other[k])) continue;
    both += one[k] * other[k];
    first += one[k] * one[k];
    second += other[k] * other[k];
  }
  if (!(first > 0.0) || !(second > 0.0)) return {};
  return {both / std::sqrt(first * second), both / second};
}

double variesAlike(const std::vector<double>& angle, const std::vector<double>& speed) {
  const size_t stride = std::max<size_t>(1, std::min<size_t>(10, angle.size() / 20));
  std::vector<double> ways, speeds;
  for (size_t from = 0; from + stride < angle.size(); from += stride) {
    double sum = 0.0;
    for (size_t k = from; k < from + stride; ++k) sum += 0.5 * (speed[k] + speed[k + 1]);
    if (!std::isfinite(sum) || !std::isfinite(angle[from + stride] - angle[from])) continue;
    ways.push_back(angle[from + stride] - angle[from]);
    speeds.push_back(sum);
  }
  const auto count = static_cast<double>(std::max<size_t>(1, ways.size()));
  const double way = std::accumulate(ways.begin(), ways.end(), 0.0) / count,
               mean = std::accumulate(speeds.begin(), speeds.end(), 0.0) / count;
  double both = 0.0, own = 0.0, other = 0.0;
  for (size_t k = 0; k < ways.size(); ++k) {
    both += (ways[k] - way) * (speeds[k] - mean);
    own += (ways[k] - way) * (ways[k] - way);
    other += (speeds[k] - mean) * (speeds[k] - mean);
  }
  return own > 0.0 && other > 0.0 ? both / std::sqrt(own * other) : 0.0;
}

std::optional<UnitPair> unitsByFactor(double factor) {
  constexpr double degree = turn_rad / 360.0, rpm = turn_rad / 60.0, within = 1.02;
  static constexpr auto pairs = std::to_array<UnitPair>({{"deg", "rpm", degree, rpm},
                                                         {"rad", "rpm", 1.0, rpm},
                                                         {"turns", "rpm", turn_rad, rpm},
                                                         {"deg", "rad/s", degree, 1.0},
                                                         {"turns", "rad/s", turn_rad, 1.0}});
  const auto it = std::find_if(pairs.begin(), pairs.end(), [factor](const UnitPair& one) {
    return std::abs(std::log(factor * one.angle_rad / one.speed_rad_per_s)) < std::log(within);
  });
  return it == pairs.end() ? std::nullopt : std::optional(*it);
}

double usualCounts(double measured) {
  constexpr double within = 1.015;
  for (const double usual : {360.0,   400.0,   500.0,   512.0,   1000.0,  1024.0,   2000.0,   2048.0,   2400.0,
                             2500.0,  3600.0,  4000.0,  4096.0,  5000.0,  8000.0,   8192.0,   10000.0,  16384.0,
                             20000.0, 32768.0, 36000.0, 40000.0, 65536.0, 131072.0, 262144.0, 1048576.0}) {
    if (std::abs(std::log(measured / usual)) < std::log(within)) return usual;
  }
  return std::round(measured);
}

bool hardlyChanges(const std::vector<double>& values) {
  constexpr double sags = 0.25;
  const auto [low, high] = extremes(values);
  return low > 0.0 && high - low <= sags * high;
}

bool goesBothWays(const std::vector<double>& speeds) {
  constexpr double leastShare = 0.2;
  double forward = 0.0, backward = 0.0;
  for (const double speed : speeds) {
    if (std::isfinite(speed)) (speed > 0.0 ? forward : backward) += std::abs(speed);
  }
  return std::min(forward, backward) > leastShare * (forward + backward);
}

size_t turnsBack(const std::vector<double>& values) {
  const double far = rangeOf(values) / 3.0;
  size_t count = 0;
  int way = 0;  // up, down, not yet known
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value) || !(far > 0.0)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
    const bool up = value - low > far && way <= 0, down = high - value > far && way >= 0;
    if (!up && !down) continue;
    count += way == 0 ? 0 : 1;
    way = up ? 1 : -1;
    low = high = value;
  }
  return count;
}

std::vector<double> changesOf(const std::vector<double>& values) {
  std::vector<double> changes(values.size(), std::numeric_limits<double>::quiet_NaN());
  for (size_t k = 1; k < values.size(); ++k) changes[k] = values[k] - values[k - 1];
  return changes;
}

bool arePulseWidths(const std::vector<double>& values) {
  constexpr double shortest_us = 700.0, longest_us = 2300.0, middle_us = 1000.0;
  const auto [low, high] = extremes(values);
  return areWhole(values) && low >= shortest_us && high > middle_us && high < longest_us;
}

std::optional<double> fullDutyOf(const std::vector<double>& values, bool namedPwm) {
  const double most = largest(values);
  if (most <= 1.0 + 1e-6) return 1.0;
  const bool whole = areWhole(values);
  if (!whole) return most <= 100.0 + 1e-6 ? std::optional(100.0) : std::nullopt;
  if (most <= 100.0 && !namedPwm) return 100.0;
  if (most <= 255.0) return 255.0;
  for (const double full : {1000.0, 1023.0, 4095.0, 65535.0}) {
    if (most <= full && most > 0.95 * full) return full;
  }
  return std::nullopt;
}

Leaps leapsIn(const std::vector<double>& time_s, const std::vector<double>& angle, const std::vector<size_t>& pauses) {
  std::vector<double> speeds;
  forEachStep(angle, pauses, [&](size_t k, size_t from) {
    speeds.push_back(std::abs(angle[k] - angle[from]) / (time_s[k] - time_s[from]));
  });
  Leaps leaps;
  if (speeds.size() < 20) return leaps;
  std::vector<double> sorted = speeds;
  const auto place = static_cast<size_t>(0.995 * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(place), sorted.end());
  const double usual = sorted[place];
  if (!(usual > 0.0)) return leaps;
  forEachStep(angle, pauses, [&](size_t k, size_t from) {
    const double step = std::abs(angle[k] - angle[from]);
    if (step / (time_s[k] - time_s[from]) < 10.0 * usual) return;
    if (leaps.count++ == 0) {
      leaps.first = k;
      leaps.size = step;
    }
  });
  return leaps;
}

}  // namespace breakaway
