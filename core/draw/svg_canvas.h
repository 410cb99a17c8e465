// The pen of the figures: SVG elements in the house's light and dark colours.
#pragma once

#include <string>
#include <vector>

#include "draw/svg_path.h"
#include "draw/svg_plot.h"

namespace breakaway {

/// What a mark is for; its colour follows in either theme.
enum class Ink { paper, text, faintText, grid, axis, highlight };

class SvgCanvas {
 public:
  SvgCanvas(int width_px, int height_px, const std::string& title);

  void line(double x1, double y1, double x2, double y2, Ink ink, double width_px = 1.0);
  void box(const Frame& frame, Ink fill);
  void circle(double x, double y, double radius, Ink ink);
  enum class Anchor { start, middle, end };
  void text(double x, double y, const std::string& text, Anchor anchor, Ink ink, double size_px = 12,
            bool bold = false);
  void verticalText(double x, double y, const std::string& text, double size_px = 12);
  /// A filled path, e.g. a highlighted sector.
  void area(const std::string& path, Ink ink);
  /// The curve's band in its colour, translucent.
  void band(const std::string& path, int colour);
  /// The curve itself.
  void curve(const std::string& path, const Curve& curve, int colour);
  /// Legend entries, centred at `centre_px` in rows of at most `width_px`, the first row's middle at `top`; returns the
  /// rows used.
  int legend(const std::vector<Curve>& curves, double centre_px, double top, double width_px);

  std::string finish();

 private:
  std::string body_;
};

/// About how wide `text` is drawn, in px: SVG knows only when it draws.
double textWidth(const std::string& text, double size_px);
/// How many rows the legend of these curves takes.
int legendRows(const std::vector<Curve>& curves, double width_px);
constexpr double legendRow_px = 18.0;

}  // namespace breakaway
