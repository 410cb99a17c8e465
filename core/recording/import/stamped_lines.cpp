#include "recording/import/stamped_lines.h"

#include <algorithm>
#include <charconv>

#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

struct StampedLine {
  std::string_view stamp, rest;
  bool millis = false;  ///< as ESP-IDF's logger has it: the level's letter, milliseconds in round brackets
};

std::optional<StampedLine> parted(std::string_view line) {
  line = withoutBlanks(line);
  StampedLine out;
  if (line.size() > 3 && std::string_view("EWIDV").find(line[0]) != std::string_view::npos && line[1] == ' ' &&
      line[2] == '(') {
    out.millis = true;
    line.remove_prefix(2);
  }
  const char open = line.empty() ? '\0' : line.front();
  if (open != '[' && !(open == '(' && out.millis)) return std::nullopt;
  const size_t close = line.find(open == '[' ? ']' : ')');
  if (close == std::string_view::npos) return std::nullopt;
  out.stamp = withoutBlanks(line.substr(1, close - 1));
  double value = 0.0;
  const auto [end, code] = std::from_chars(out.stamp.data(), out.stamp.data() + out.stamp.size(), value);
  if (code != std::errc() || end != out.stamp.data() + out.stamp.size()) return std::nullopt;
  out.rest = withoutBlanks(line.substr(close + 1));
  // A tag: "motor: angle=0.3".
  const size_t colon = out.rest.find(": "), label = out.rest.find('=');
  if (colon != std::string_view::npos && label != std::string_view::npos && colon < label)
    out.rest = withoutBlanks(out.rest.substr(colon + 2));
  if (out.rest.find_first_of("=:") == std::string_view::npos) return std::nullopt;
  return out;
}

}  // namespace

std::optional<std::string> withStampsAsCells(std::string_view text) {
  constexpr size_t looksAt = 20;
  const char lineEnd = lineEndOf(text);
  std::string_view ahead = text;
  size_t lines = 0, good = 0, commas = 0;
  while (!ahead.empty() && lines < looksAt) {
    const std::string_view line = takeLine(ahead, lineEnd);
    if (withoutBlanks(line).empty()) continue;
    ++lines;
    const auto one = parted(line);
    good += one ? 1 : 0;
    commas += one && one->rest.find(',') != std::string_view::npos ? 1 : 0;
  }
  if (2 * good <= lines) return std::nullopt;
  const char* between = 2 * commas > good ? ", " : " ";
  std::string out;
  out.reserve(text.size() + text.size() / 4);
  while (!text.empty()) {
    const auto one = parted(takeLine(text, lineEnd));
    if (!one) continue;
    out += one->millis ? "time_ms:" : "time:";
    out += one->stamp;
    out += between;
    out += one->rest;
    out += '\n';
  }
  return out;
}

}  // namespace breakaway
