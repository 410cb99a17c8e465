#include "session/overview.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {
constexpr std::size_t finest = 64, factor = 8;  // rows of a stretch, and how many make one of the next level
constexpr double leftBy = 0.01;                 // of its range, before it counts as moving
}  // namespace

Overview::Overview(const Recording& recording, const std::string& channel)
    : recording_(recording), time_(recording_.time()), values_(recording_.channel(channel)) {
  if (values_.empty()) return;
  std::vector<Extremes> level;
  level.reserve(values_.size() / finest + 1);
  for (std::size_t row = 0; row < values_.size(); row += finest)
    level.push_back(extremesOf(row, std::min(row + finest, values_.size())));
  levels_.push_back(std::move(level));
  while (levels_.back().size() > factor) {
    const std::vector<Extremes>& below = levels_.back();
    std::vector<Extremes> above;
    above.reserve(below.size() / factor + 1);
    for (std::size_t k = 0; k < below.size(); k += factor) {
      Extremes all = below[k];
      for (std::size_t next = k + 1; next < std::min(k + factor, below.size()); ++next) add(all, below[next]);
      above.push_back(all);
    }
    levels_.push_back(std::move(above));
  }
  Extremes all = levels_.back().front();
  for (const Extremes& one : levels_.back()) add(all, one);
  if (!missing(all.least)) range_ = {values_[all.least], values_[all.greatest]};
  findBegin();
}

void Overview::findBegin() {
  std::size_t first = 0;
  while (first + 1 < values_.size() && missing(first)) ++first;
  const double away = leftBy * (range_.second - range_.first);
  std::size_t row = first;
  while (row < values_.size() && !(std::abs(values_[row] - values_[first]) > away)) ++row;
  begin_ = {time_[row < values_.size() ? row : first], values_[first]};
}

/// Of the rows [first, last); rows without a value count only where there are no others.
Overview::Extremes Overview::extremesOf(std::size_t first, std::size_t last) const {
  Extremes all{first, first};
  for (std::size_t row = first + 1; row < last; ++row) add(all, {row, row});
  return all;
}

void Overview::add(Extremes& all, const Extremes& part) const {
  if (missing(part.least)) return;
  if (missing(all.least)) {
    all = part;
    return;
  }
  if (values_[part.least] < values_[all.least]) all.least = part.least;
  if (values_[part.greatest] > values_[all.greatest]) all.greatest = part.greatest;
}

std::vector<Overview::Point> Overview::between(double from_s, double to_s, std::size_t pixels) const {
  std::vector<Point> points;
  if (values_.empty()) return points;
  const auto rowAt = [this](auto where) { return static_cast<std::size_t>(where - time_.begin()); };
  std::size_t first = rowAt(std::lower_bound(time_.begin(), time_.end(), from_s));
  std::size_t last = rowAt(std::upper_bound(time_.begin(), time_.end(), to_s));
  first -= first > 0 ? 1 : 0;
  last += last < time_.size() ? 1 : 0;
  const auto take = [&](std::size_t row) { points.push_back({time_[row], values_[row]}); };
  if (last - first <= std::max<std::size_t>(4 * pixels, finest)) {
    points.reserve(last - first);
    for (std::size_t row = first; row < last; ++row) take(row);
    return points;
  }
  const auto takeBoth = [&](const Extremes& one) {
    take(std::min(one.least, one.greatest));
    if (one.least != one.greatest) take(std::max(one.least, one.greatest));
  };
  if (last - first < 2 * pixels * finest) {
    const std::size_t rows = (last - first) / (2 * pixels) + 1;
    points.reserve(4 * pixels + 2);
    for (std::size_t row = first; row < last; row += rows) takeBoth(extremesOf(row, std::min(row + rows, last)));
    return points;
  }
  // The coarsest level that still has two stretches a pixel.
  std::size_t level = 0, rows = finest;
  while (level + 1 < levels_.size() && (last - first) / (rows * factor) >= 2 * pixels) {
    ++level;
    rows *= factor;
  }
  const std::vector<Extremes>& stretches = levels_[level];
  const std::size_t begin = first / rows, end = std::min((last + rows - 1) / rows, stretches.size());
  const std::size_t together = std::max<std::size_t>(1, (end - begin) / (2 * pixels));
  points.reserve(2 * ((end - begin) / together + 1));
  for (std::size_t k = begin; k < end; k += together) {
    Extremes all = stretches[k];
    for (std::size_t next = k + 1; next < std::min(k + together, end); ++next) add(all, stretches[next]);
    takeBoth(all);
  }
  return points;
}

}  // namespace breakaway
