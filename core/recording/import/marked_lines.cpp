#include "recording/import/marked_lines.h"

#include <algorithm>
#include <map>

#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

TextCell kindOf(std::string_view cell) {
  TextNumber number;
  return readCell(withoutBlanks(cell), TextLayout{}, number);
}

bool isMarkedNumber(std::string_view cell) {
  return kindOf(cell) == TextCell::number;
}

/// What the line begins with, up to a blank; empty where that is no mark.
std::string_view markOf(std::string_view line) {
  constexpr size_t longest = 16;
  const size_t end = line.find_first_of(" \t");
  if (end == std::string_view::npos || end > longest || isComment(line)) return {};
  const std::string_view mark = line.substr(0, end);
  const bool told = mark.find_first_of(",;|=\"[]()") != std::string_view::npos || kindOf(mark) != TextCell::text;
  return told ? std::string_view{} : mark;
}

/// "0,12,11": at least two numbers, parted by such a separator.
bool beginsWithNumbers(std::string_view rest, char separator) {
  const size_t first = rest.find(separator);
  if (first == std::string_view::npos || !isMarkedNumber(rest.substr(0, first))) return false;
  return isMarkedNumber(rest.substr(first + 1, rest.find(separator, first + 1) - first - 1));
}

bool hasNumbersBehind(std::string_view line, std::string_view mark) {
  const std::string_view rest = withoutBlanks(line.substr(mark.size()));
  return beginsWithNumbers(rest, ',') || beginsWithNumbers(rest, ';') || beginsWithNumbers(rest, '\t');
}

}  // namespace

std::optional<MarkedLines> withoutMarkOfLines(std::string_view text) {
  constexpr size_t looksAt = 200, fewest = 4;
  const char lineEnd = lineEndOf(text);
  std::map<std::string_view, size_t> marks;
  size_t lines = 0;
  std::string_view ahead = text;
  while (!ahead.empty() && lines < looksAt) {
    const std::string_view line = withoutBlanks(takeLine(ahead, lineEnd));
    if (line.empty()) continue;
    ++lines;
    const std::string_view mark = markOf(line);
    if (!mark.empty() && hasNumbersBehind(line, mark)) ++marks[mark];
  }
  const auto most =
      std::max_element(marks.begin(), marks.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == marks.end() || lines < fewest || 4 * most->second < 3 * lines) return std::nullopt;
  MarkedLines out{{}, std::string(most->first)};
  out.text.reserve(text.size());
  while (!text.empty()) {
    std::string_view line = withoutBlanks(takeLine(text, lineEnd));
    if (markOf(line) == out.mark) line = withoutBlanks(line.substr(out.mark.size()));
    out.text += line;
    out.text += '\n';
  }
  return out;
}

}  // namespace breakaway
