#include "draw/svg_path.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <unordered_set>

namespace breakaway {

namespace {

bool finite(const Pixel& p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

/// Adds the points [from, to) of one pixel column: first, lowest, highest and last in their order.
void addColumn(const std::vector<Pixel>& points, size_t from, size_t to, std::vector<Pixel>& out) {
  const auto lower = [](const Pixel& a, const Pixel& b) { return a.y < b.y; };
  const auto begin = points.begin() + static_cast<std::ptrdiff_t>(from);
  const auto end = points.begin() + static_cast<std::ptrdiff_t>(to);
  const auto [least, most] = std::minmax_element(begin, end, lower);
  std::array<size_t, 4> kept{from, static_cast<size_t>(least - points.begin()),
                             static_cast<size_t>(most - points.begin()), to - 1};
  std::sort(kept.begin(), kept.end());
  for (size_t k = 0; k < kept.size(); ++k) {
    if (k == 0 || kept[k] != kept[k - 1]) out.push_back(points[kept[k]]);
  }
}

/// Thins one stretch without gaps, [from, to).
void thinRun(const std::vector<Pixel>& points, size_t from, size_t to, std::vector<Pixel>& out) {
  bool rising = true;
  for (size_t k = from + 1; k < to && rising; ++k) rising = points[k].x >= points[k - 1].x;
  if (rising) {
    for (size_t start = from; start < to;) {
      size_t stop = start + 1;
      while (stop < to && std::floor(points[stop].x) == std::floor(points[start].x)) ++stop;
      addColumn(points, start, stop, out);
      start = stop;
    }
    return;
  }
  for (size_t k = from; k < to; ++k) {
    const bool edge = k == from || k + 1 == to;
    if (edge || std::hypot(points[k].x - out.back().x, points[k].y - out.back().y) > 0.25) out.push_back(points[k]);
  }
}

/// The part of the segment a–b inside the frame (Liang and Barsky), or nothing.
std::optional<std::pair<Pixel, Pixel>> clipped(const Pixel& a, const Pixel& b, const Frame& frame) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  double from = 0.0, to = 1.0;
  const std::array<std::pair<double, double>, 4> edges{
      {{-dx, a.x - frame.left}, {dx, frame.right - a.x}, {-dy, a.y - frame.top}, {dy, frame.bottom - a.y}}};
  for (const auto& [direction, distance] : edges) {
    if (direction == 0.0) {
      if (distance < 0.0) return std::nullopt;
      continue;
    }
    const double at = distance / direction;
    if (direction < 0.0) {
      from = std::max(from, at);
    } else {
      to = std::min(to, at);
    }
  }
  if (from > to) return std::nullopt;
  return std::pair{Pixel{a.x + from * dx, a.y + from * dy}, Pixel{a.x + to * dx, a.y + to * dy}};
}

void add(std::string& path, char letter, const Pixel& p) {
  path += letter;
  path += px(p.x);
  path += ' ';
  path += px(p.y);
}

}  // namespace

std::string px(double value) {
  std::string result = fmt::format("{:.1f}", value);
  if (result.ends_with(".0")) result.resize(result.size() - 2);
  return result == "-0" ? "0" : result;
}

std::vector<Pixel> thinned(const std::vector<Pixel>& points) {
  std::vector<Pixel> out;
  for (size_t k = 0; k < points.size();) {
    if (!finite(points[k])) {
      if (!out.empty() && finite(out.back())) out.push_back({NAN, NAN});
      ++k;
      continue;
    }
    size_t end = k;
    while (end < points.size() && finite(points[end])) ++end;
    thinRun(points, k, end, out);
    k = end;
  }
  return out;
}

std::string linePath(const std::vector<Pixel>& points, const Frame& frame) {
  std::string path;
  bool pen = false;  // whether the path ends at the last point, inside the frame
  for (size_t k = 0; k < points.size(); ++k) {
    const bool lone =
        finite(points[k]) && (k == 0 || !finite(points[k - 1])) && (k + 1 == points.size() || !finite(points[k + 1]));
    if (lone && frame.holds(points[k])) {
      add(path, 'M', points[k]);
      path += "h.1";
    }
    if (k == 0 || !finite(points[k]) || !finite(points[k - 1])) {
      pen = false;
      continue;
    }
    const auto part = clipped(points[k - 1], points[k], frame);
    if (!part) {
      pen = false;
      continue;
    }
    if (!pen || !frame.holds(points[k - 1])) add(path, 'M', part->first);
    add(path, 'L', part->second);
    pen = frame.holds(points[k]);
  }
  return path;
}

std::string dotPath(const std::vector<Pixel>& points, const Frame& frame) {
  constexpr double cell_px = 1.5;
  std::unordered_set<long> taken;
  std::string path;
  for (const Pixel& p : points) {
    if (!finite(p) || !frame.holds(p)) continue;
    const long key = std::lround(p.x / cell_px) * 100000 + std::lround(p.y / cell_px);
    if (!taken.insert(key).second) continue;
    add(path, 'M', p);
    path += "h.1";
  }
  return path;
}

void thinBand(std::vector<Pixel>& low, std::vector<Pixel>& high) {
  assert(low.size() == high.size());
  size_t kept = 0;
  for (size_t k = 0; k < low.size(); ++k) {
    const bool both = finite(low[k]) && finite(high[k]);
    const bool sameColumn = both && kept > 0 && finite(low[kept - 1]) && finite(high[kept - 1]) &&
                            std::floor(low[k].x) == std::floor(low[kept - 1].x) && low[k].x >= low[kept - 1].x;
    if (!sameColumn) {
      low[kept] = both ? low[k] : Pixel{NAN, NAN};
      high[kept++] = both ? high[k] : Pixel{NAN, NAN};
      continue;
    }
    low[kept - 1].y = std::max(low[kept - 1].y, low[k].y);  // px grow downwards
    high[kept - 1].y = std::min(high[kept - 1].y, high[k].y);
  }
  low.resize(kept);
  high.resize(kept);
}

std::string bandPath(const std::vector<Pixel>& low, const std::vector<Pixel>& high, const Frame& frame) {
  assert(low.size() == high.size());
  const auto held = [&frame](const Pixel& p) {
    return Pixel{std::clamp(p.x, frame.left, frame.right), std::clamp(p.y, frame.top, frame.bottom)};
  };
  std::string path;
  for (size_t k = 0; k < low.size();) {
    size_t end = k;
    while (end < low.size() && finite(low[end]) && finite(high[end])) ++end;
    for (size_t j = k; j < end; ++j) add(path, j == k ? 'M' : 'L', held(low[j]));
    for (size_t j = end; j > k; --j) add(path, 'L', held(high[j - 1]));
    if (end > k) path += 'Z';
    k = end + 1;
  }
  return path;
}

}  // namespace breakaway
