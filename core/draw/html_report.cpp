#include "draw/html_report.h"

#include <fmt/core.h>
#include <cassert>
#include <cctype>
#include <cmath>

#include "base/atomic_file.h"
#include "base/made.h"
#include "base/typeset.h"

namespace breakaway {

namespace {

const char* const style = R"(
:root { color-scheme: light dark; --paper: #ffffff; --text: #22252a; --faint: #5f6670; --rule: #dde0e4; --mark: #0072b2; --wash: #f4f6f8; }
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #16181c; --text: #e4e6ea; --faint: #9aa2ad; --rule: #343941; --mark: #4aa8e0; --wash: #1f2227; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 60rem; background: var(--paper); color: var(--text);
  font: 16px/1.55 system-ui, "Segoe UI", "DejaVu Sans", Helvetica, Arial, sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .3rem; } h2 { font-size: 1.35rem; margin: 2.2rem 0 .6rem; }
h3 { font-size: 1.1rem; margin: 1.6rem 0 .4rem; } p { margin: .6rem 0; max-width: 48rem; }
.subtitle, figcaption, caption { color: var(--faint); } .subtitle { margin: 0 0 1.5rem; }
.verdict { border-left: 4px solid var(--mark); background: var(--wash); padding: .8rem 1.1rem; font-size: 1.1rem; white-space: pre-line; }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding-bottom: .3rem; } th, td { padding: .3rem .9rem .3rem 0; text-align: left; vertical-align: top; }
thead th { border-bottom: 2px solid var(--rule); font-weight: 600; } tbody td, tbody th { border-bottom: 1px solid var(--rule); }
tbody th { font-weight: 400; color: var(--faint); } td.number, th.number { text-align: right; }
.wide { overflow-x: auto; } figure { margin: 1.4rem 0; } figure svg { max-width: 100%; height: auto; display: block; }
figcaption { font-size: .92rem; margin-top: .3rem; max-width: 48rem; } details { margin: 1rem 0; } summary { cursor: pointer; color: var(--faint); }
.made { margin-top: 3rem; font-size: .85rem; overflow-wrap: anywhere; } pre { white-space: pre-wrap; }
@media print { body { max-width: none; padding: 0; font-size: 10.5pt; } figure, table, .verdict { break-inside: avoid; }
  h2, h3 { break-after: avoid; } @page { margin: 18mm 16mm; } }
)";

bool startsWithNumber(const std::string& text) {
  size_t k = 0;
  if (text.starts_with("\u2212")) k = 3;
  while (k < text.size() && (text[k] == '-' || text[k] == '+' || text[k] == '.')) ++k;
  return k < text.size() && std::isdigit(static_cast<unsigned char>(text[k])) != 0;
}

}  // namespace

HtmlReport::HtmlReport(const Saying& title, const Saying& subtitle, const Catalogue& language)
    : language_(language), title_(said(title)), subtitle_(said(subtitle)) {
}

const Catalogue& HtmlReport::english() {
  static const Catalogue nothing;
  return nothing;
}

std::string HtmlReport::said(const Saying& text) const {
  const std::string words = text.in(language_);
  const std::string* whole = words == text.english() ? language_.find(words) : nullptr;
  return escaped(whole != nullptr ? *whole : words);
}

void HtmlReport::heading(const Saying& text, int level) {
  assert(level == 2 || level == 3);
  const std::string tag = "h" + std::to_string(level);
  body_ += "<" + tag + ">" + said(text) + "</" + tag + ">\n";
}

void HtmlReport::paragraph(const Saying& text) {
  body_ += "<p>" + said(text) + "</p>\n";
}

void HtmlReport::verdict(const Saying& text) {
  body_ += "<p class=\"verdict\">" + said(text) + "</p>\n";
}

void HtmlReport::list(const std::vector<Saying>& items) {
  body_ += "<ul>\n";
  for (const auto& item : items) body_ += "<li>" + said(item) + "</li>\n";
  body_ += "</ul>\n";
}

void HtmlReport::facts(const std::vector<std::pair<Saying, Saying>>& rows) {
  body_ += "<div class=\"wide\"><table><tbody>\n";
  for (const auto& [name, value] : rows) body_ += "<tr><th>" + said(name) + "</th><td>" + said(value) + "</td></tr>\n";
  body_ += "</tbody></table></div>\n";
}

void HtmlReport::table(const std::vector<Saying>& header, const std::vector<std::vector<Saying>>& rows,
                       const Saying& caption, const std::vector<std::string>& links) {
  assert(links.empty() || links.size() == rows.size());
  std::vector<bool> numeric(header.size(), !rows.empty());
  for (const auto& row : rows) {
    assert(row.size() == header.size());
    for (size_t c = 0; c < row.size(); ++c) numeric[c] = numeric[c] && (row[c].empty() || startsWithNumber(row[c]));
  }
  const auto tag = [&numeric](const char* name, size_t c) {
    return std::string("<") + name + (numeric[c] ? " class=\"number\">" : ">");
  };
  body_ += "<div class=\"wide\"><table>";
  if (!caption.empty()) body_ += "<caption>" + said(caption) + "</caption>";
  body_ += "<thead><tr>";
  for (size_t c = 0; c < header.size(); ++c) body_ += tag("th", c) + said(header[c]) + "</th>";
  body_ += "</tr></thead><tbody>\n";
  for (size_t k = 0; k < rows.size(); ++k) {
    const auto& row = rows[k];
    const bool leads = !links.empty() && !links[k].empty();
    body_ += "<tr>";
    for (size_t c = 0; c < row.size(); ++c) {
      const std::string text = said(row[c]);
      body_ += tag("td", c) + (leads && c == 0 ? "<a href=\"" + links[k] + "\">" + text + "</a>" : text) + "</td>";
    }
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

void HtmlReport::figure(const Figure& figure, const Saying& caption, int width_px, int height_px) {
  svg(toSvg(inLanguage(figure, language_), width_px, height_px), caption);
}

void HtmlReport::svg(std::string_view svg, const Saying& caption) {
  body_ += "<figure>\n";
  body_ += svg;
  if (!caption.empty()) body_ += "<figcaption>" + said(caption) + "</figcaption>\n";
  body_ += "</figure>\n";
}

void HtmlReport::raw(std::string_view html) {
  body_ += html;
}

void HtmlReport::details(const Saying& summary, const std::vector<Saying>& paragraphs) {
  body_ += "<details><summary>" + said(summary) + "</summary>\n";
  for (const auto& text : paragraphs) paragraph(text);
  body_ += "</details>\n";
}

std::string HtmlReport::html() const {
  // The language's own code stands where "en" does.
  return "<!DOCTYPE html>\n<html lang=\"" + said(message("en")) +
         "\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         title_ + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" + title_ + "</h1>\n" +
         (subtitle_.empty() ? "" : "<p class=\"subtitle\">" + subtitle_ + "</p>\n") + body_ + htmlOfMade() +
         "</body>\n</html>\n";
}

Result<void> HtmlReport::write(const std::string& path) const {
  return writeFile(path, html());
}

std::string numberText(double value, int digits) {
  if (!std::isfinite(value)) return std::isnan(value) ? "–" : value > 0 ? "∞" : "\u2212∞";
  const double size = std::abs(value);
  if (size != 0.0 && (size < 1e-4 || size >= 1e6)) {
    std::string result = fmt::format("{:.{}e}", value, digits - 1);
    const size_t e = result.find('e');
    size_t end = e;
    while (end > 0 && result[end - 1] == '0') --end;
    if (end > 0 && result[end - 1] == '.') --end;
    if (result.find('.') < e) result.erase(end, e - end);
    return typeset(result);
  }
  const std::string result = fmt::format("{:.{}g}", value, digits);
  return typeset(result.find('e') == std::string::npos ? result : fmt::format("{:.0f}", value));
}

}  // namespace breakaway
