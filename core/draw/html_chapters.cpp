#include "draw/html_chapters.h"

#include <algorithm>
#include <string_view>

#include "draw/svg_plot.h"

namespace breakaway {

namespace {

constexpr std::string_view begin = "<h2>", end = "</h2>", closing = "<details class=\"made\"";

/// What escaped() has replaced.
std::string plain(std::string text) {
  constexpr std::pair<std::string_view, std::string_view> marks[] = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}};
  for (const auto& [mark, letter] : marks) {
    for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + letter.size()))
      text.replace(at, mark.size(), letter);
  }
  return text;
}

/// A chapter reaches to the next heading, or to where it is said where the report comes from.
struct Chapter {
  std::string heading;
  size_t first = 0, last = 0;
};

std::vector<Chapter> foundIn(const std::string& html) {
  std::vector<Chapter> chapters;
  const size_t closes = std::min(html.rfind(closing), html.rfind("</body>"));
  for (size_t at = html.find(begin); at < closes; at = html.find(begin, at + 1)) {
    if (!chapters.empty()) chapters.back().last = at;
    const size_t from = at + begin.size();
    chapters.push_back({plain(html.substr(from, html.find(end, from) - from)), at, closes});
  }
  return chapters;
}

std::string withBreaks(const std::string& text) {
  std::string lines;
  for (const char letter : escaped(text)) lines += letter == '\n' ? std::string("<br>\n") : std::string(1, letter);
  return lines;
}

}  // namespace

std::vector<std::string> chaptersOf(const std::string& html) {
  std::vector<std::string> headings;
  for (const Chapter& chapter : foundIn(html)) headings.push_back(chapter.heading);
  return headings;
}

std::string editedReport(const std::string& html, const ReportEdit& edit) {
  std::string edited = html;
  std::vector<Chapter> chapters = foundIn(html);
  std::reverse(chapters.begin(), chapters.end());
  for (const Chapter& chapter : chapters) {
    if (std::find(edit.leftOut.begin(), edit.leftOut.end(), chapter.heading) != edit.leftOut.end())
      edited.erase(chapter.first, chapter.last - chapter.first);
  }
  std::string words;
  if (!edit.customer.empty()) words += "<p><b>" + withBreaks(edit.customer) + "</b></p>\n";
  if (!edit.remarks.empty()) words += "<p>" + withBreaks(edit.remarks) + "</p>\n";
  const size_t title = edited.find("</h1>");
  if (title == std::string::npos || words.empty()) return edited;
  size_t at = title + std::string_view("</h1>\n").size();
  if (edited.compare(at, std::string_view("<p class=\"subtitle\"").size(), "<p class=\"subtitle\"") == 0)
    at = edited.find('\n', at) + 1;
  return edited.insert(at, words);
}

}  // namespace breakaway
