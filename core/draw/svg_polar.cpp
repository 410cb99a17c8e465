#include "draw/svg_polar.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "base/numbers.h"
#include "draw/svg_canvas.h"
#include "draw/svg_ticks.h"

namespace breakaway {

namespace {

/// From angle and radius to px.
struct Dial {
  double x = 0.0, y = 0.0, radius_px = 0.0;
  double inner = 0.0, outer = 1.0;  ///< radius values at the centre and at the rim
  double zero_rad = 0.0;            ///< where 0° points, counter-clockwise from the right

  Pixel at(double angle_rad, double radius) const {
    const double r = radius_px * std::clamp((radius - inner) / (outer - inner), 0.0, 1.0);
    return {x + r * std::cos(angle_rad + zero_rad), y - r * std::sin(angle_rad + zero_rad)};
  }
  std::vector<Pixel> all(const std::vector<double>& angles, const std::vector<double>& radii) const {
    std::vector<Pixel> points(angles.size());
    for (size_t k = 0; k < angles.size(); ++k) {
      const bool finite = std::isfinite(angles[k]) && std::isfinite(radii[k]);
      points[k] = finite ? at(angles[k], radii[k]) : Pixel{NAN, NAN};
    }
    return points;
  }
};

std::pair<double, double> radiusRange(const Figure& figure) {
  if (figure.yRange && figure.yRange->second - figure.yRange->first > 1e-290) return *figure.yRange;
  double low = 0.0, high = -std::numeric_limits<double>::infinity();
  for (const Curve& curve : figure.curves) {
    for (const auto* values : {&curve.y, &curve.low, &curve.high}) {
      for (const double value : *values) {
        if (!(std::abs(value) < 1e300)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
  }
  if (!(high - low > 1e-290)) return {low, low + 1.0};
  const auto ticks = niceTicks(low, high, 4);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : high - low;
  return {low < 0.0 ? std::floor(low / step) * step : 0.0, high + 0.04 * (high - low)};
}

/// Whether the curve goes once around, so that its last point belongs beside its first.
bool goesAround(const Curve& curve) {
  if (curve.style == Curve::Style::points || curve.x.size() < 8) return false;
  const double span = std::abs(curve.x.back() - curve.x.front());
  const double step = span / static_cast<double>(curve.x.size() - 1);
  return std::isfinite(span) && span < turn_rad + step && turn_rad - span < 2.5 * step;
}

void drawDial(SvgCanvas& canvas, const Dial& dial, const std::string& radiusLabel, double right_px) {
  const auto ticks = niceTicks(dial.inner, dial.outer, 4);
  const TickLabels labels = tickLabels(ticks);
  for (const double tick : ticks) {
    canvas.circle(dial.x, dial.y, dial.radius_px * (tick - dial.inner) / (dial.outer - dial.inner), Ink::grid);
  }
  canvas.circle(dial.x, dial.y, dial.radius_px, Ink::axis);
  for (int degree = 0; degree < 360; degree += 30) {
    const double angle = degree * std::numbers::pi / 180.0;
    const Pixel rim = dial.at(angle, dial.outer);
    canvas.line(dial.x, dial.y, rim.x, rim.y, Ink::grid);
    const double c = std::cos(angle + dial.zero_rad), s = std::sin(angle + dial.zero_rad);
    const auto anchor = c > 0.3    ? SvgCanvas::Anchor::start
                        : c < -0.3 ? SvgCanvas::Anchor::end
                                   : SvgCanvas::Anchor::middle;
    canvas.text(dial.x + (dial.radius_px + 9) * c, dial.y - (dial.radius_px + 11) * s + 4, std::to_string(degree) + "°",
                anchor, Ink::faintText);
  }
  // Radius ticks stand along the spoke at 15°, where no spoke and no label is.
  for (size_t k = 0; k < ticks.size(); ++k) {
    if (ticks[k] <= dial.inner || ticks[k] > dial.outer) continue;
    const Pixel at = dial.at(std::numbers::pi / 12.0, ticks[k]);
    canvas.text(at.x, at.y + 4, labels.texts[k], SvgCanvas::Anchor::middle, Ink::faintText, 11);
  }
  canvas.text(right_px, dial.y + dial.radius_px + 30, radiusLabel + exponentText(labels.exponent),
              SvgCanvas::Anchor::middle, Ink::text);
}

std::string sectorPath(const Dial& dial, const Highlight& one) {
  std::vector<Pixel> rim, centre;
  const double from = std::min(one.from, one.to), to = std::min(std::max(one.from, one.to), from + turn_rad);
  constexpr int steps = 90;
  for (int k = 0; k <= steps; ++k) {
    rim.push_back(dial.at(from + (to - from) * k / steps, dial.outer));
    centre.push_back({dial.x, dial.y});
  }
  return bandPath(centre, rim, {-1e6, -1e6, 1e6, 1e6});
}

void drawCurve(SvgCanvas& canvas, const Dial& dial, const Curve& curve, int colour, bool bands) {
  const Frame everywhere{-1e6, -1e6, 1e6, 1e6};
  const auto closed = [&curve](std::vector<Pixel> points) {
    if (goesAround(curve) && !points.empty()) points.push_back(points.front());
    return points;
  };
  if (bands) {
    if (curve.low.empty() || curve.high.empty()) return;
    assert(curve.low.size() == curve.x.size() && curve.high.size() == curve.x.size());
    canvas.band(bandPath(closed(dial.all(curve.x, curve.low)), closed(dial.all(curve.x, curve.high)), everywhere),
                colour);
    return;
  }
  const auto points = dial.all(curve.x, curve.y);
  const bool dots = curve.style == Curve::Style::points;
  std::vector<Pixel> line = closed(points);
  canvas.curve(dots ? dotPath(points, everywhere) : linePath(thinned(line), everywhere), curve, colour);
}

}  // namespace

std::string toPolarSvg(const Figure& figure, int width_px, int height_px) {
  SvgCanvas canvas(width_px, height_px, figure.title);
  const double centre = 0.5 * width_px;
  const int rows = legendRows(figure.curves, width_px - 40.0);
  const double titleHeight = figure.title.empty() ? 8.0 : 32.0;
  const double top = titleHeight + legendRow_px * rows + 26;
  Dial dial;
  dial.radius_px = std::max(20.0, std::min(0.5 * (height_px - top - 46), centre - 60));
  dial.x = centre;
  dial.y = top + dial.radius_px;
  std::tie(dial.inner, dial.outer) = radiusRange(figure);
  dial.zero_rad = figure.zeroAtTop ? 0.5 * std::numbers::pi : 0.0;

  if (!figure.title.empty()) canvas.text(centre, 22, figure.title, SvgCanvas::Anchor::middle, Ink::text, 15, true);
  canvas.legend(figure.curves, centre, titleHeight + 9, width_px - 40.0);
  for (const Highlight& one : figure.highlights) canvas.area(sectorPath(dial, one), Ink::highlight);
  const auto colour = [&figure](size_t k) {
    return figure.curves[k].colour < 0 ? static_cast<int>(k) : figure.curves[k].colour;
  };
  for (size_t k = 0; k < figure.curves.size(); ++k) drawCurve(canvas, dial, figure.curves[k], colour(k), true);
  drawDial(canvas, dial, figure.yLabel, centre);
  for (const Highlight& one : figure.highlights) {
    const Pixel at = dial.at(0.5 * (one.from + one.to), dial.inner + 0.55 * (dial.outer - dial.inner));
    if (!one.label.empty()) canvas.text(at.x, at.y, one.label, SvgCanvas::Anchor::middle, Ink::faintText, 11);
  }
  for (size_t k = 0; k < figure.curves.size(); ++k) drawCurve(canvas, dial, figure.curves[k], colour(k), false);
  bool any = false;
  for (const Curve& curve : figure.curves) {
    for (size_t k = 0; k < curve.x.size(); ++k) any = any || (std::isfinite(curve.x[k]) && std::isfinite(curve.y[k]));
  }
  if (!any) canvas.text(dial.x, dial.y, "no data", SvgCanvas::Anchor::middle, Ink::faintText, 14);
  return canvas.finish();
}

}  // namespace breakaway
