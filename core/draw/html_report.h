// A report as one HTML file that needs nothing else: readable on a screen, light or dark, and on paper.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "draw/svg_plot.h"

namespace breakaway {

/// Collects a report from top to bottom. All texts are plain text: what means something in HTML is escaped.
class HtmlReport {
 public:
  explicit HtmlReport(std::string title, std::string subtitle = {});

  /// A chapter's heading; level 2 or 3.
  void heading(const std::string& text, int level = 2);
  void paragraph(const std::string& text);
  /// A paragraph set off from the others: the verdict, the one thing to read.
  void verdict(const std::string& text);
  void list(const std::vector<std::string>& items);
  /// Names and values side by side.
  void facts(const std::vector<std::pair<std::string, std::string>>& rows);
  /// Every row as long as the header. Cells that begin with a number are set to the right.
  void table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
             const std::string& caption = {});
  void figure(const Figure& figure, const std::string& caption = {}, int width_px = 860, int height_px = 380);
  /// A figure that is SVG already, e.g. from toSvg().
  void svg(std::string_view svg, const std::string& caption = {});
  /// HTML as it is, for what a report has of its own; texts in it must be escaped already.
  void raw(std::string_view html);
  /// Small print behind a "details" fold, open on paper.
  void details(const std::string& summary, const std::vector<std::string>& paragraphs);

  std::string html() const;
  Result<void> write(const std::string& path) const;

 private:
  std::string title_;
  std::string subtitle_;
  std::string body_;
};

/// A number for people: `digits` significant digits, trailing zeros cut, "3.1e-05" below 1e-4 and from 1e6 on.
std::string numberText(double value, int digits = 4);

}  // namespace breakaway
