#include "recording/import/stamped_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>

#include "recording/import/clock_time.h"
#include "recording/import/text_layout.h"

namespace breakaway {

namespace {

struct StampedLine {
  std::string_view stamp, rest;
  std::string since1970 = {};  ///< s, where the stamp is a date
  bool millis = false;         ///< as ESP-IDF's logger has it: the level's letter, milliseconds in round brackets
};

/// "2024-05-01 10:00:00,123 - INFO - motor: angle=1.5 …": a date, a time, and what the logger says before the first
/// value.
std::optional<StampedLine> partedAtDate(std::string_view line) {
  constexpr std::string_view form = "0000-00-00 00:00:00";
  if (line.size() < form.size()) return std::nullopt;
  for (size_t k = 0; k < form.size(); ++k) {
    const bool digit = std::isdigit(static_cast<unsigned char>(line[k])) != 0;
    const bool same = form[k] == '0' ? digit : line[k] == form[k] || (form[k] == ' ' && line[k] == 'T');
    if (!same) return std::nullopt;
  }
  size_t end = form.size();
  if (end + 1 < line.size() && (line[end] == '.' || line[end] == ','))
    end = std::min(line.find_first_not_of("0123456789", end + 1), line.size());
  const size_t equals = line.find('=', end);
  if (equals == std::string_view::npos) return std::nullopt;
  const size_t before = line.find_last_of(" \t,;", equals);
  std::string stamp(line.substr(0, end));
  std::replace(stamp.begin(), stamp.end(), ',', '.');
  const auto clock = readClock(stamp);
  if (before == std::string_view::npos || before < end || !clock) return std::nullopt;
  StampedLine out;
  std::array<char, 48> seconds{};
  const int size = std::snprintf(seconds.data(), seconds.size(), "%lld.%06.0f", static_cast<long long>(clock->whole_s),
                                 std::min(999999.0, std::floor(clock->fraction_s * 1e6 + 0.5)));
  out.since1970 = std::string(seconds.data(), static_cast<size_t>(size));
  out.rest = line.substr(before + 1);
  return out;
}

/// "[12.5] …" and "[INFO] [1712345678.125] [node]: …": the first brackets that hold a number, others around them aside.
bool takeStamp(std::string_view& line, StampedLine& out) {
  while (!line.empty() && (line.front() == '[' || (line.front() == '(' && out.millis))) {
    const size_t close = line.find(line.front() == '[' ? ']' : ')');
    if (close == std::string_view::npos) return false;
    const std::string_view inner = withoutBlanks(line.substr(1, close - 1));
    double value = 0.0;
    const auto [end, code] = std::from_chars(inner.data(), inner.data() + inner.size(), value);
    if (out.stamp.empty() && code == std::errc() && end == inner.data() + inner.size()) out.stamp = inner;
    line.remove_prefix(close + 1);
    while (!line.empty() && (line.front() == ':' || line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
  }
  return !out.stamp.empty();
}

/// "MOTOR: Axis 1 | Pos: 0.3": a word before others with names, and no name itself.
bool isTag(std::string_view text) {
  const size_t colon = text.find(": ");
  if (colon == std::string_view::npos || text.find_first_of(" =,|") < colon || colon + 2 >= text.size()) return false;
  const std::string_view behind = withoutBlanks(text.substr(colon + 2));
  const bool number =
      behind.empty() || std::string_view("+-.0123456789").find(behind.front()) != std::string_view::npos;
  return !number && behind.find_first_of(":=") != std::string_view::npos;
}

std::optional<StampedLine> parted(std::string_view line) {
  line = withoutBlanks(line);
  if (auto dated = partedAtDate(line)) return dated;
  StampedLine out;
  if (line.size() > 3 && std::string_view("EWIDV").find(line[0]) != std::string_view::npos && line[1] == ' ' &&
      line[2] == '(') {
    out.millis = true;
    line.remove_prefix(2);
  }
  if (!takeStamp(line, out)) return std::nullopt;
  out.rest = line;
  // A tag: "motor: angle=0.3".
  const size_t colon = out.rest.find(": "), label = out.rest.find('=');
  if (colon != std::string_view::npos && label != std::string_view::npos && colon < label)
    out.rest = withoutBlanks(out.rest.substr(colon + 2));
  if (isTag(out.rest)) out.rest = withoutBlanks(out.rest.substr(out.rest.find(": ") + 2));
  if (out.rest.find_first_of("=:") == std::string_view::npos) return std::nullopt;
  return out;
}

}  // namespace

std::optional<std::string> withStampsAsCells(std::string_view text) {
  constexpr size_t looksAt = 20;
  const char lineEnd = lineEndOf(text);
  std::string_view ahead = text;
  size_t lines = 0, good = 0, commas = 0, bars = 0;
  while (!ahead.empty() && lines < looksAt) {
    const std::string_view line = takeLine(ahead, lineEnd);
    if (withoutBlanks(line).empty()) continue;
    ++lines;
    const auto one = parted(line);
    good += one ? 1 : 0;
    commas += one && one->rest.find(',') != std::string_view::npos ? 1 : 0;
    bars += one && one->rest.find(" | ") != std::string_view::npos ? 1 : 0;
  }
  if (2 * good <= lines) return std::nullopt;
  const char* between = 2 * bars > good ? " | " : 2 * commas > good ? ", " : " ";
  std::string out;
  out.reserve(text.size() + text.size() / 4);
  while (!text.empty()) {
    const auto one = parted(takeLine(text, lineEnd));
    if (!one) continue;
    out += one->millis ? "time_ms:" : "time:";
    out += one->since1970.empty() ? one->stamp : one->since1970;
    out += between;
    out += one->rest;
    out += '\n';
  }
  return out;
}

}  // namespace breakaway
