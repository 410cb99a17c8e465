#include "draw/svg_plot.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/atomic_file.h"
#include "base/made.h"
#include "draw/svg_canvas.h"
#include "draw/svg_polar.h"
#include "draw/svg_ticks.h"

namespace breakaway {

namespace {

using Range = std::pair<double, double>;

// Beyond these, differences and ratios of doubles are no numbers to draw with.
constexpr double smallest = 1e-290, largest = 1e300;
constexpr size_t highlightRows = 3;
constexpr double highlightRow_px = 14.0;

/// One axis: from data to px.
struct Scale {
  Range range;
  double from_px = 0.0, to_px = 0.0;
  bool log = false;

  double operator()(double value) const {
    if (log && !(value > 0.0)) return std::numeric_limits<double>::quiet_NaN();
    const auto at = [this](double v) { return log ? std::log10(v) : v; };
    const double part = (at(value) - at(range.first)) / (at(range.second) - at(range.first));
    // far outside is as good as outside, and keeps the numbers printable
    return std::clamp(from_px + part * (to_px - from_px), -1e6, 1e6);
  }
  std::vector<double> ticks(int count) const {
    return log ? decadeTicks(range.first, range.second, count) : niceTicks(range.first, range.second, count);
  }
};

void widen(Range& range, double value, bool log) {
  if (!(std::abs(value) < largest) || (log && !(value > smallest))) return;
  range.first = std::min(range.first, value);
  range.second = std::max(range.second, value);
}

/// Adds room around the data, and makes an empty range a proper one.
Range withMargin(Range range, double margin, bool log) {
  if (!(range.first <= range.second)) return log ? Range{0.1, 10.0} : Range{0.0, 1.0};
  if (log) {
    const double factor = range.second > range.first ? std::pow(range.second / range.first, margin) : 3.0;
    return {range.first / factor, range.second * factor};
  }
  const double width = range.second - range.first;
  const double size = std::max(std::abs(range.first), std::abs(range.second));
  if (width <= 1e-12 * size || width < smallest) {
    const double room = size > smallest ? 0.5 * size : 1.0;
    return {range.first - room, range.second + room};
  }
  return {range.first - margin * width, range.second + margin * width};
}

Range dataRange(const Figure& figure, bool ofX) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const bool log = ofX ? figure.logX : figure.logY;
  bool points = false;
  for (const Curve& curve : figure.curves) {
    assert(curve.x.size() == curve.y.size());
    points = points || curve.style == Curve::Style::points;
    for (size_t k = 0; k < curve.x.size(); ++k) {
      if (!std::isfinite(curve.x[k]) || !std::isfinite(curve.y[k])) continue;
      widen(range, ofX ? curve.x[k] : curve.y[k], log);
    }
    if (ofX) continue;
    for (const double value : curve.low) widen(range, value, log);
    for (const double value : curve.high) widen(range, value, log);
  }
  return withMargin(range, ofX ? (points ? 0.02 : 0.0) : 0.06, log);
}

/// The range asked for, or that of the data; never empty.
Range rangeOf(const Figure& figure, bool ofX) {
  const auto& wanted = ofX ? figure.xRange : figure.yRange;
  return wanted ? withMargin(*wanted, 0.0, ofX ? figure.logX : figure.logY) : dataRange(figure, ofX);
}

bool anyPoint(const Figure& figure) {
  for (const Curve& curve : figure.curves) {
    for (size_t k = 0; k < curve.x.size(); ++k) {
      if (std::isfinite(curve.x[k]) && std::isfinite(curve.y[k])) return true;
    }
  }
  return false;
}

TickLabels labelsOf(const Scale& scale, const std::vector<double>& ticks) {
  if (!scale.log) return tickLabels(ticks);
  TickLabels labels;
  for (const double tick : ticks) labels.texts.push_back(decadeLabel(tick));
  return labels;
}

std::vector<Pixel> toPixels(const std::vector<double>& x, const std::vector<double>& y, const Scale& xScale,
                            const Scale& yScale) {
  std::vector<Pixel> points(x.size());
  for (size_t k = 0; k < x.size(); ++k) points[k] = {xScale(x[k]), yScale(y[k])};
  return points;
}

/// The highlighted bands, their labels in rows above the frame.
void drawHighlights(SvgCanvas& canvas, const Figure& figure, const Scale& xScale, const Frame& frame) {
  std::vector<double> rowEnds;  // where the last label of each row ends
  for (const Highlight& one : figure.highlights) {
    double from = xScale(one.from), to = xScale(one.to);
    if (!(from <= to)) std::swap(from, to);
    if (!std::isfinite(from) || !std::isfinite(to) || to < frame.left || from > frame.right) continue;
    from = std::max(from, frame.left);
    to = std::max(std::min(to, frame.right), from + 1.5);
    canvas.box({from, frame.top, to, frame.bottom}, Ink::highlight);
    if (one.label.empty()) continue;
    const double width = textWidth(one.label.english(), 11);
    const double x = std::clamp(0.5 * (from + to - width), frame.left, std::max(frame.left, frame.right - width));
    size_t row = 0;
    while (row < rowEnds.size() && row + 1 < highlightRows && rowEnds[row] > x) ++row;
    if (row == rowEnds.size()) rowEnds.push_back(0.0);
    rowEnds[row] = x + width + 8;
    canvas.text(x, frame.top - 5 - highlightRow_px * static_cast<double>(row), one.label, SvgCanvas::Anchor::start,
                Ink::faintText, 11);
  }
}

/// Room above the frame for the highlights' labels.
double highlightRoom(const Figure& figure) {
  const auto labels = static_cast<size_t>(std::count_if(figure.highlights.begin(), figure.highlights.end(),
                                                        [](const Highlight& one) { return !one.label.empty(); }));
  return highlightRow_px * static_cast<double>(std::min(labels, highlightRows));
}

/// Grid, ticks, axis lines and axis labels.
void drawAxes(SvgCanvas& canvas, const Figure& figure, const Scale& xScale, const Scale& yScale, const Frame& frame) {
  const auto xTicks = xScale.ticks(std::max(2, static_cast<int>((frame.right - frame.left) / 90)));
  const auto yTicks = yScale.ticks(std::max(2, static_cast<int>((frame.bottom - frame.top) / 48)));
  const TickLabels xLabels = labelsOf(xScale, xTicks), yLabels = labelsOf(yScale, yTicks);
  double widest = 0.0;
  for (size_t k = 0; k < xTicks.size(); ++k) {
    const double x = xScale(xTicks[k]);
    canvas.line(x, frame.top, x, frame.bottom, Ink::grid);
    canvas.text(x, frame.bottom + 17, xLabels.texts[k], SvgCanvas::Anchor::middle, Ink::faintText);
  }
  for (size_t k = 0; k < yTicks.size(); ++k) {
    const double y = yScale(yTicks[k]);
    const bool zero = yTicks[k] == 0.0 && y < frame.bottom - 1 && !yScale.log;
    canvas.line(frame.left, y, frame.right, y, zero ? Ink::axis : Ink::grid, zero ? 0.8 : 1.0);
    canvas.text(frame.left - 7, y + 4, yLabels.texts[k], SvgCanvas::Anchor::end, Ink::faintText);
    widest = std::max(widest, textWidth(yLabels.texts[k], 12));
  }
  canvas.line(frame.left, frame.bottom, frame.right, frame.bottom, Ink::axis);
  canvas.line(frame.left, frame.top, frame.left, frame.bottom, Ink::axis);
  canvas.text(0.5 * (frame.left + frame.right), frame.bottom + 37,
              figure.xLabel.english() + exponentText(xLabels.exponent), SvgCanvas::Anchor::middle, Ink::text);
  canvas.verticalText(std::max(14.0, frame.left - widest - 18), 0.5 * (frame.top + frame.bottom),
                      figure.yLabel.english() + exponentText(yLabels.exponent));
}

void drawCurves(SvgCanvas& canvas, const Figure& figure, const Scale& xScale, const Scale& yScale, const Frame& frame) {
  const auto colour = [&figure](size_t k) {
    return figure.curves[k].colour < 0 ? static_cast<int>(k) : figure.curves[k].colour;
  };
  for (size_t k = 0; k < figure.curves.size(); ++k) {
    const Curve& curve = figure.curves[k];
    if (curve.low.empty() || curve.high.empty()) continue;
    assert(curve.low.size() == curve.x.size() && curve.high.size() == curve.x.size());
    auto low = toPixels(curve.x, curve.low, xScale, yScale);
    auto high = toPixels(curve.x, curve.high, xScale, yScale);
    thinBand(low, high);
    canvas.band(bandPath(low, high, frame), colour(k));
  }
  for (size_t k = 0; k < figure.curves.size(); ++k) {
    const Curve& curve = figure.curves[k];
    const auto points = toPixels(curve.x, curve.y, xScale, yScale);
    const bool dots = curve.style == Curve::Style::points;
    canvas.curve(dots ? dotPath(points, frame) : linePath(thinned(points), frame), curve, colour(k));
  }
}

/// Makes one unit as long on both axes by widening the range of one.
void equalise(Scale& x, Scale& y) {
  const auto unit = [](const Scale& s) { return (s.range.second - s.range.first) / std::abs(s.to_px - s.from_px); };
  const double wanted = std::max(unit(x), unit(y));
  for (Scale* s : {&x, &y}) {
    const double middle = 0.5 * (s->range.first + s->range.second);
    const double half = 0.5 * wanted * std::abs(s->to_px - s->from_px);
    s->range = {middle - half, middle + half};
  }
}

std::string plot(const Figure& figure, int width_px, int height_px) {
  SvgCanvas canvas(width_px, height_px, figure.title);
  const double legendWidth = width_px - 40.0;
  const int rows = legendRows(figure.curves, legendWidth);
  const double titleHeight = figure.title.empty() ? 8.0 : 32.0;
  Frame frame{0, titleHeight + legendRow_px * rows + 8 + highlightRoom(figure), width_px - 22.0, height_px - 48.0};
  Scale yScale{rangeOf(figure, false), frame.bottom, frame.top, figure.logY};
  double widest = 0.0;
  for (const auto& text :
       labelsOf(yScale, yScale.ticks(std::max(2, static_cast<int>((frame.bottom - frame.top) / 48)))).texts) {
    widest = std::max(widest, textWidth(text, 12));
  }
  frame.left = 34.0 + widest;
  Scale xScale{rangeOf(figure, true), frame.left, frame.right, figure.logX};
  if (figure.equalScale && !figure.logX && !figure.logY) equalise(xScale, yScale);
  if (!figure.title.empty()) {
    canvas.text(0.5 * (frame.left + frame.right), 22, figure.title, SvgCanvas::Anchor::middle, Ink::text, 15, true);
  }
  canvas.legend(figure.curves, 0.5 * (frame.left + frame.right), titleHeight + 9, legendWidth);
  drawHighlights(canvas, figure, xScale, frame);
  drawAxes(canvas, figure, xScale, yScale, frame);
  drawCurves(canvas, figure, xScale, yScale, frame);
  if (!anyPoint(figure)) {
    canvas.text(0.5 * (frame.left + frame.right), 0.5 * (frame.top + frame.bottom), "no data",
                SvgCanvas::Anchor::middle, Ink::faintText, 14);
  }
  return canvas.finish();
}

}  // namespace

Figure inLanguage(Figure figure, const Catalogue& language) {
  const auto say = [&language](Saying& text) { text = text.in(language); };
  for (Saying* text : {&figure.title, &figure.xLabel, &figure.yLabel}) say(*text);
  for (Curve& curve : figure.curves) say(curve.label);
  for (Highlight& one : figure.highlights) say(one.label);
  return figure;
}

std::string toSvg(const Figure& figure, int width_px, int height_px) {
  return figure.polar ? toPolarSvg(figure, width_px, height_px) : plot(figure, width_px, height_px);
}

Result<void> writeSvg(const Figure& figure, const std::string& path, int width_px, int height_px) {
  return writeFile(path, svgWithMade(toSvg(figure, width_px, height_px)));
}

}  // namespace breakaway
