// A report as one HTML file that needs nothing else: readable on a screen, light or dark, and on paper.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/catalogue.h"
#include "base/message.h"
#include "base/result.h"
#include "draw/svg_plot.h"

namespace breakaway {

/// Collects a report from top to bottom, in one language. All texts are plain text: what means something in HTML is
/// escaped.
class HtmlReport {
 public:
  /// `language` outlives the report.
  explicit HtmlReport(const Saying& title, const Saying& subtitle = {}, const Catalogue& language = english());

  /// A chapter's heading; level 2 or 3.
  void heading(const Saying& text, int level = 2);
  void paragraph(const Saying& text);
  /// A paragraph set off from the others: the verdict, the one thing to read.
  void verdict(const Saying& text);
  void list(const std::vector<Saying>& items);
  /// Names and values side by side.
  void facts(const std::vector<std::pair<Saying, Saying>>& rows);
  /// Every row as long as the header. Cells that begin with a number are set to the right. `links`: where each row's
  /// first cell leads to, an address that holds nothing to be escaped; empty, or of an empty address: nowhere.
  void table(const std::vector<Saying>& header, const std::vector<std::vector<Saying>>& rows,
             const Saying& caption = {}, const std::vector<std::string>& links = {});
  void figure(const Figure& figure, const Saying& caption = {}, int width_px = 860, int height_px = 380);
  /// A figure that is SVG already, e.g. from toSvg().
  void svg(std::string_view svg, const Saying& caption = {});
  /// HTML as it is, for what a report has of its own; texts in it must be escaped already.
  void raw(std::string_view html);
  /// Small print behind a "details" fold, open on paper.
  void details(const Saying& summary, const std::vector<Saying>& paragraphs);

  const Catalogue& language() const { return language_; }

  std::string html() const;
  Result<void> write(const std::string& path) const;

 private:
  static const Catalogue& english();
  /// In the report's language, escaped; what is plain text may be a message, or a name, as a whole.
  std::string said(const Saying& text) const;

  const Catalogue& language_;
  std::string title_;
  std::string subtitle_;
  std::string body_;
};

/// A number for people, typeset(): `digits` significant ones, zeros cut, "3.1·10⁻⁵" below 1e-4 and from 1e6 on.
std::string numberText(double value, int digits = 4);

}  // namespace breakaway
