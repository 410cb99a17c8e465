#include "draw/svg_canvas.h"

#include <array>
#include <cmath>
#include <utility>

namespace breakaway {

namespace {

struct Palette {
  const char *light, *dark;
};

constexpr std::array<Palette, 7> curvePalette{{{"#0072b2", "#4aa8e0"},
                                               {"#d55e00", "#f0853a"},
                                               {"#009e73", "#2cc79c"},
                                               {"#e69f00", "#f2b632"},
                                               {"#56b4e9", "#8ccdf2"},
                                               {"#b3669a", "#dc96c0"},
                                               {"#222222", "#dddddd"}}};

constexpr std::array<Palette, 6> inkPalette{{{"#ffffff", "#16181c"},    // paper
                                             {"#22252a", "#e4e6ea"},    // text
                                             {"#5f6670", "#9aa2ad"},    // faintText
                                             {"#e6e8eb", "#2c3037"},    // grid
                                             {"#8b929c", "#6b727d"},    // axis
                                             {"#fbe3c2", "#4a3a20"}}};  // highlight

constexpr std::array<const char*, 6> inkNames{"p", "t", "u", "g", "a", "h"};

size_t paletteIndex(int colour) {
  const int count = static_cast<int>(curvePalette.size());
  return static_cast<size_t>(((colour % count) + count) % count);
}

/// The colour as an attribute for every reader of SVG, and as a class that the dark theme overrides.
std::string fill(Ink ink) {
  const auto k = static_cast<size_t>(ink);
  return std::string(" class=\"bw-f") + inkNames[k] + "\" fill=\"" + inkPalette[k].light + "\"";
}

std::string stroke(Ink ink) {
  const auto k = static_cast<size_t>(ink);
  return std::string(" class=\"bw-s") + inkNames[k] + "\" stroke=\"" + inkPalette[k].light + "\"";
}

std::string curveStroke(int colour) {
  const size_t k = paletteIndex(colour);
  return " class=\"bw-sc" + std::to_string(k) + "\" stroke=\"" + curvePalette[k].light + "\"";
}

std::string darkStyle() {
  std::string rules;
  const auto rule = [&rules](const std::string& name, const char* dark) {
    rules += ".bw-f" + name + "{fill:" + dark + "}.bw-s" + name + "{stroke:" + dark + "}";
  };
  for (size_t k = 0; k < inkPalette.size(); ++k) rule(inkNames[k], inkPalette[k].dark);
  for (size_t k = 0; k < curvePalette.size(); ++k) rule("c" + std::to_string(k), curvePalette[k].dark);
  return "<style>@media screen and (prefers-color-scheme:dark){" + rules + "}</style>";
}

double entryWidth(const Curve& curve) {
  return 26.0 + textWidth(curve.label.english(), 12) + 18.0;
}

/// The legend's rows as indices into the curves.
std::vector<std::vector<size_t>> legendLayout(const std::vector<Curve>& curves, double width_px) {
  std::vector<std::vector<size_t>> rows;
  double used = 0.0;
  for (size_t k = 0; k < curves.size(); ++k) {
    if (curves[k].label.empty()) continue;
    const double width = entryWidth(curves[k]);
    if (rows.empty() || used + width > width_px) {
      rows.emplace_back();
      used = 0.0;
    }
    rows.back().push_back(k);
    used += width;
  }
  return rows;
}

}  // namespace

std::string colourOf(int index) {
  return curvePalette[paletteIndex(index)].light;
}

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        // XML 1.0 has no place for control characters.
        out += (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') ? ' ' : c;
    }
  }
  return out;
}

double textWidth(const std::string& text, double size_px) {
  double width = 0.0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) continue;  // inside one UTF-8 character
    const bool narrow = std::string_view("iIjl.,:;'| ()[]tfr").find(c) != std::string_view::npos;
    width += narrow ? 0.36 : 0.59;
  }
  return width * size_px;
}

int legendRows(const std::vector<Curve>& curves, double width_px) {
  return static_cast<int>(legendLayout(curves, width_px).size());
}

SvgCanvas::SvgCanvas(int width_px, int height_px, const std::string& title) {
  const std::string w = std::to_string(width_px), h = std::to_string(height_px);
  body_ =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " +
      h +
      "\" role=\"img\" font-family=\"system-ui, 'Segoe UI', 'DejaVu Sans', Helvetica, Arial, sans-serif\">\n<title>" +
      escaped(title) + "</title>" + darkStyle() + "\n";
  box({0, 0, static_cast<double>(width_px), static_cast<double>(height_px)}, Ink::paper);
}

void SvgCanvas::line(double x1, double y1, double x2, double y2, Ink ink, double width_px) {
  body_ += "<path d=\"M" + px(x1) + " " + px(y1) + "L" + px(x2) + " " + px(y2) + "\" fill=\"none\"" + stroke(ink) +
           " stroke-width=\"" + px(width_px) + "\"/>\n";
}

void SvgCanvas::box(const Frame& frame, Ink ink) {
  body_ += "<rect x=\"" + px(frame.left) + "\" y=\"" + px(frame.top) + "\" width=\"" + px(frame.right - frame.left) +
           "\" height=\"" + px(frame.bottom - frame.top) + "\"" + fill(ink) + "/>\n";
}

void SvgCanvas::circle(double x, double y, double radius, Ink ink) {
  body_ +=
      "<circle cx=\"" + px(x) + "\" cy=\"" + px(y) + "\" r=\"" + px(radius) + "\" fill=\"none\"" + stroke(ink) + "/>\n";
}

void SvgCanvas::text(double x, double y, const std::string& text, Anchor anchor, Ink ink, double size_px, bool bold) {
  static const std::array<const char*, 3> anchors{"start", "middle", "end"};
  body_ += "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" text-anchor=\"" + anchors[static_cast<size_t>(anchor)] +
           "\" font-size=\"" + px(size_px) + "\"" + (bold ? " font-weight=\"600\"" : "") + fill(ink) + ">" +
           escaped(text) + "</text>\n";
}

void SvgCanvas::verticalText(double x, double y, const std::string& text, double size_px) {
  body_ += "<text transform=\"translate(" + px(x) + " " + px(y) +
           ") rotate(-90)\" text-anchor=\"middle\" font-size=\"" + px(size_px) + "\"" + fill(Ink::text) + ">" +
           escaped(text) + "</text>\n";
}

void SvgCanvas::area(const std::string& path, Ink ink) {
  if (!path.empty()) body_ += "<path d=\"" + path + "\"" + fill(ink) + "/>\n";
}

void SvgCanvas::band(const std::string& path, int colour) {
  if (path.empty()) return;
  const size_t k = paletteIndex(colour);
  body_ += "<path d=\"" + path + "\" class=\"bw-fc" + std::to_string(k) + "\" fill=\"" + curvePalette[k].light +
           "\" fill-opacity=\"0.2\" fill-rule=\"evenodd\"/>\n";
}

void SvgCanvas::curve(const std::string& path, const Curve& curve, int colour) {
  if (path.empty()) return;
  const bool points = curve.style == Curve::Style::points;
  body_ += "<path d=\"" + path + "\" fill=\"none\"" + curveStroke(colour) + " stroke-width=\"" +
           px(points ? 2.0 * curve.width_px : curve.width_px) + "\" stroke-linejoin=\"round\"" +
           (curve.style == Curve::Style::dashed ? " stroke-dasharray=\"6 4\"" : " stroke-linecap=\"round\"") + "/>\n";
}

int SvgCanvas::legend(const std::vector<Curve>& curves, double centre_px, double top, double width_px) {
  const auto rows = legendLayout(curves, width_px);
  for (size_t row = 0; row < rows.size(); ++row) {
    double total = -18.0;
    for (const size_t k : rows[row]) total += entryWidth(curves[k]);
    double x = centre_px - 0.5 * total;
    const double y = top + legendRow_px * static_cast<double>(row);
    for (const size_t k : rows[row]) {
      const Curve& one = curves[k];
      const bool dot = one.style == Curve::Style::points;
      Curve sample = one;
      sample.width_px = dot ? 3.0 : 2.2;
      curve(dot ? "M" + px(x + 10) + " " + px(y) + "h.1" : "M" + px(x) + " " + px(y) + "h20", sample,
            one.colour < 0 ? static_cast<int>(k) : one.colour);
      text(x + 26, y + 4, one.label, Anchor::start, Ink::text);
      x += entryWidth(one);
    }
  }
  return static_cast<int>(rows.size());
}

std::string SvgCanvas::finish() {
  return std::move(body_) + "</svg>\n";
}

}  // namespace breakaway
