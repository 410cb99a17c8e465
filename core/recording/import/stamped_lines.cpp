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

std::string secondsText(const ClockTime& clock) {
  std::array<char, 48> seconds{};
  const int size = std::snprintf(seconds.data(), seconds.size(), "%lld.%06.0f", static_cast<long long>(clock.whole_s),
                                 std::min(999999.0, std::floor(clock.fraction_s * 1e6 + 0.5)));
  return {seconds.data(), static_cast<size_t>(size)};
}

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
  out.since1970 = secondsText(*clock);
  out.rest = line.substr(before + 1);
  return out;
}

bool isTaken(const StampedLine& line) {
  return !line.stamp.empty() || !line.since1970.empty();
}

/// A number as "(1712345678.125)" has it, since 1970: what else stands in round brackets is no stamp.
bool isSince1970(double value) {
  return value > 1e8;
}

/// "[12.5] …", "[2024-05-01 10:00:00.123] …" and "[INFO] [1712345678.125] [node]: …": the first brackets that hold a
/// number or a date, others around them aside.
bool takeStamp(std::string_view& line, StampedLine& out) {
  while (!line.empty() && (line.front() == '[' || (line.front() == '(' && !isTaken(out)))) {
    const bool round = line.front() == '(';
    const size_t close = line.find(round ? ')' : ']');
    if (close == std::string_view::npos) return false;
    const std::string_view inner = withoutBlanks(line.substr(1, close - 1));
    double value = 0.0;
    const auto [end, code] = std::from_chars(inner.data(), inner.data() + inner.size(), value);
    const bool number = code == std::errc() && end == inner.data() + inner.size();
    if (round && !out.millis && !(number && isSince1970(value))) break;
    if (!isTaken(out) && number) out.stamp = inner;
    const auto clock = isTaken(out) || number ? std::nullopt : readClock(inner);
    if (clock && clock->dated) out.since1970 = secondsText(*clock);
    line.remove_prefix(close + 1);
    while (!line.empty() && (line.front() == ':' || line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
  }
  return isTaken(out);
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

std::optional<StampedLine> stampTaken(std::string_view line) {
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
    const auto one = stampTaken(line);
    good += one ? 1 : 0;
    commas += one && one->rest.find(',') != std::string_view::npos ? 1 : 0;
    bars += one && one->rest.find(" | ") != std::string_view::npos ? 1 : 0;
  }
  if (2 * good <= lines) return std::nullopt;
  const char* between = 2 * bars > good ? " | " : 2 * commas > good ? ", " : " ";
  std::string out;
  out.reserve(text.size() + text.size() / 4);
  while (!text.empty()) {
    const auto one = stampTaken(takeLine(text, lineEnd));
    if (!one) continue;
    out += one->millis ? "time_ms:" : "time:";
    out += one->since1970.empty() ? one->stamp : one->since1970;
    out += between;
    out += one->rest;
    out += '\n';
  }
  return out;
}

std::optional<std::string> withStampsBeforeRows(std::string_view text) {
  constexpr size_t looksAt = 20;
  const char lineEnd = lineEndOf(text);
  const auto separatorIn = [](std::string_view rest) {
    const size_t at = rest.find_first_of(",;\t");
    return at == std::string_view::npos ? ' ' : rest[at];
  };
  const auto stamped = [](std::string_view line) {
    StampedLine out;
    line = withoutBlanks(line);
    if (takeStamp(line, out)) out.rest = line;
    return out;
  };
  const auto beginsWithNumber = [](std::string_view rest) {
    TextNumber number;
    const std::string_view first = rest.substr(0, rest.find_first_of(",;\t "));
    return readCell(withoutBlanks(first), TextLayout{}, number) == TextCell::number;
  };
  size_t lines = 0, rows = 0;
  for (std::string_view ahead = text; !ahead.empty() && lines < looksAt;) {
    const std::string_view line = takeLine(ahead, lineEnd);
    if (withoutBlanks(line).empty()) continue;
    ++lines;
    const StampedLine one = stamped(line);
    rows += isTaken(one) && beginsWithNumber(one.rest) ? 1 : 0;
  }
  if (2 * rows <= lines) return std::nullopt;
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::string_view line = takeLine(text, lineEnd);
    const StampedLine one = stamped(line);
    if (!isTaken(one)) {
      const char separator = separatorIn(line);  // names stand without a stamp, too
      if (separator != ' ' && !beginsWithNumber(line) && !isComment(withoutBlanks(line)))
        out += std::string("time") + separator;
      out += line;
    } else {
      const bool row = beginsWithNumber(one.rest);
      out += !row ? "time" : one.since1970.empty() ? one.stamp : one.since1970;
      out += separatorIn(one.rest);
      out += one.rest;
    }
    out += '\n';
  }
  return out;
}

}  // namespace breakaway
