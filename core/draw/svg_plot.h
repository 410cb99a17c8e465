// Figures as SVG, written without any library: curves over an axis or around a turn, with ticks, legend and highlighted
// bands.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/catalogue.h"
#include "base/message.h"
#include "base/result.h"

namespace breakaway {

/// One curve. NaN in x or y is a gap. On a polar figure x is an angle in rad and y the radius.
struct Curve {
  enum class Style { line, dashed, points };
  Saying label;           ///< stands in the legend; empty: not listed
  std::vector<double> x;  ///< same length as y
  std::vector<double> y;
  std::vector<double> low = {};  ///< optional band around the curve, same length as y
  std::vector<double> high = {};
  Style style = Style::line;
  int colour = -1;        ///< index into the colour-blind-safe palette (see colourOf); -1: by the curve's position
  double width_px = 1.6;  ///< width of the line, or half the diameter of a point
};

/// A stretch of the x axis (an angle range on a polar figure) that the reader is to look at.
struct Highlight {
  double from = 0.0;
  double to = 0.0;
  Saying label = {};
};

struct Figure {
  Saying title;
  Saying xLabel;  ///< with its unit, e.g. "time / s"; on a polar figure unused
  Saying yLabel;  ///< on a polar figure what the radius is
  std::vector<Curve> curves = {};
  std::vector<Highlight> highlights = {};
  bool polar = false;
  bool zeroAtTop = false;  ///< polar: 0° points up instead of to the right; angle grows counter-clockwise either way
  bool logX = false;       ///< decades; values that are not positive are gaps
  bool logY = false;
  bool equalScale = false;                               ///< one unit is as long on x as on y (root locus, phase plane)
  std::optional<std::pair<double, double>> xRange = {};  ///< default: all of the data
  std::optional<std::pair<double, double>> yRange = {};  ///< default: all of the data with a margin; polar: from 0
};

/// The figure as one SVG document of the given size in px. It carries its own light and dark colours
/// (prefers-color-scheme), uses no identifiers, so that many can stand in one HTML page, and needs no font but the
/// system's. Long curves are thinned to the smallest and largest value per pixel column, which draws the same. A figure
/// without any finite point says "no data". Its words are English; see inLanguage().
std::string toSvg(const Figure& figure, int width_px = 860, int height_px = 380);

/// The same figure with the words of a language.
Figure inLanguage(Figure figure, const Catalogue& language);

/// toSvg() into a file.
Result<void> writeSvg(const Figure& figure, const std::string& path, int width_px = 860, int height_px = 380);

/// The light theme's colour of a palette index as #rrggbb: 0 blue, 1 vermilion, 2 green, 3 orange, 4 sky blue, 5
/// purple, 6 black (Okabe and Ito, "Color Universal Design", 2008, without its yellow, which white paper swallows).
/// Indices wrap around.
std::string colourOf(int index);

/// `text` with the characters that mean something in XML and HTML replaced.
std::string escaped(std::string_view text);

}  // namespace breakaway
