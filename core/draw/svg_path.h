// Curves as SVG path data: gaps, clipping, thinning to what a screen can show.
#pragma once

#include <string>
#include <vector>

namespace breakaway {

/// A point in px; NaN in either is a gap.
struct Pixel {
  double x = 0.0;
  double y = 0.0;
};

/// The drawing area in px.
struct Frame {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  bool holds(const Pixel& p) const { return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom; }
};

/// A number with one decimal, as short as can be.
std::string px(double value);

/// Keeps the first, lowest, highest and last point of every pixel column where x never falls; elsewhere drops points
/// that lie within a quarter pixel of the last one kept. Gaps stay. The drawn line is the same.
std::vector<Pixel> thinned(const std::vector<Pixel>& points);

/// `M…L…` along the points, clipped to the frame, a new start after each gap.
std::string linePath(const std::vector<Pixel>& points, const Frame& frame);
/// A dot per point inside the frame (to be stroked with round caps), at most one per 1.5 px cell.
std::string dotPath(const std::vector<Pixel>& points, const Frame& frame);
/// Thins the two edges of a band alike: one pair per pixel column that holds all of the column's pairs, where x never
/// falls.
void thinBand(std::vector<Pixel>& low, std::vector<Pixel>& high);
/// Closed areas between two curves of the same length, one per stretch without gaps; y is clamped to the frame.
std::string bandPath(const std::vector<Pixel>& low, const std::vector<Pixel>& high, const Frame& frame);

}  // namespace breakaway
