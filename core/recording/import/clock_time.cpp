#include "recording/import/clock_time.h"

#include <array>
#include <utility>

namespace breakaway {

namespace {

/// Reads on from the front of a text.
class Reading {
 public:
  explicit Reading(std::string_view text) : rest_(text) {}

  bool atEnd() const { return rest_.empty(); }
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool takeOneOf(std::string_view some) {
    if (rest_.empty() || some.find(rest_.front()) == std::string_view::npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool takeWord(std::string_view lower) {
    if (rest_.size() < lower.size()) return false;
    for (size_t k = 0; k < lower.size(); ++k) {
      if ((rest_[k] | 0x20) != lower[k]) return false;
    }
    rest_.remove_prefix(lower.size());
    return true;
  }
  /// A number of `least` to `most` digits, or −1.
  int64_t digits(size_t least, size_t most) {
    int64_t value = 0;
    size_t count = 0;
    while (count < rest_.size() && count < most && rest_[count] >= '0' && rest_[count] <= '9')
      value = 10 * value + (rest_[count++] - '0');
    if (count < least) return -1;
    lastCount_ = count;
    rest_.remove_prefix(count);
    return value;
  }
  size_t lastCount() const { return lastCount_; }
  double fraction() {
    double value = 0.0, places = 1.0;
    for (int count = 0; !rest_.empty() && rest_.front() >= '0' && rest_.front() <= '9'; ++count) {
      if (count < 15) {
        places *= 10.0;
        value = 10.0 * value + (rest_.front() - '0');
      }
      rest_.remove_prefix(1);
    }
    value /= places;
    return value;
  }
  void skipBlanks() {
    while (take(' ')) {
    }
  }

 private:
  std::string_view rest_;
  size_t lastCount_ = 0;
};

/// Days from 1970-01-01 in the Gregorian calendar (H. Richards' algorithm with March as the first month).
int64_t daysSince1970(int64_t year, int64_t month, int64_t day) {
  const int64_t y = month <= 2 ? year - 1 : year;
  const int64_t m = month <= 2 ? month + 9 : month - 3;
  return 365 * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + day - 1 - 719468;
}

/// A date at the front; nothing is taken when there is none.
std::optional<int64_t> takeDate(Reading& reading) {
  Reading trial = reading;
  const int64_t first = trial.digits(1, 4);
  const bool yearFirst = trial.lastCount() == 4;
  for (const char mark : {'-', '/', '.'}) {
    Reading one = trial;
    if (first < 0 || !one.take(mark)) continue;
    const int64_t second = one.digits(1, 2);
    if (second < 0 || !one.take(mark)) continue;
    const int64_t third = one.digits(yearFirst ? 1 : 2, yearFirst ? 2 : 4);
    if (third < 0) continue;
    int64_t year = yearFirst ? first : third, month = second, day = yearFirst ? third : first;
    if (!yearFirst && mark == '/' && first <= 12) std::swap(month, day);  // month first, as Americans write
    if (!yearFirst && one.lastCount() == 2) year += 2000;
    if (month < 1 || month > 12 || day < 1 || day > 31) continue;
    reading = one;
    return daysSince1970(year, month, day);
  }
  return std::nullopt;
}

/// "20240501T102010.5" and "20240501_102010_500", as files are named and ISO 8601 has it without marks.
std::optional<ClockTime> takeCompact(Reading& reading) {
  Reading trial = reading;
  const int64_t date = trial.digits(8, 8);
  if (date < 0 || !trial.takeOneOf("Tt_-")) return std::nullopt;
  const int64_t clock = trial.digits(6, 6);
  const int64_t month = date / 100 % 100, day = date % 100, minute = clock / 100 % 100, second = clock % 100;
  if (clock < 0 || month < 1 || month > 12 || day < 1 || day > 31 || clock >= 240000 || minute > 59 || second > 60)
    return std::nullopt;
  ClockTime time;
  time.dated = true;
  time.whole_s = daysSince1970(date / 10000, month, day) * 86400 + clock / 10000 * 3600 + minute * 60 + second;
  if (trial.takeOneOf("._,")) time.fraction_s = trial.fraction();
  reading = trial;
  return time;
}

/// A zone's name or offset, of which there is nothing to be told, and no more.
bool endsInZone(Reading& reading) {
  reading.takeOneOf("Zz");
  if (reading.takeOneOf("+-")) {
    if (reading.digits(1, 4) < 0) return false;
    if (reading.take(':') && reading.digits(2, 2) < 0) return false;
  }
  return reading.atEnd();
}

}  // namespace

std::optional<ClockTime> readClock(std::string_view text) {
  if (text.size() < 5 || text.size() > 40) return std::nullopt;
  if (text.front() == '[' && text.back() == ']') text = text.substr(1, text.size() - 2);
  if (text.empty() || text.front() < '0' || text.front() > '9') return std::nullopt;
  Reading reading(text);
  ClockTime time;
  if (const auto compact = takeCompact(reading)) return endsInZone(reading) ? compact : std::nullopt;
  Reading days = reading;  // a span of time: "0 days 00:00:01.5"
  const int64_t count = days.digits(1, 6);
  days.skipBlanks();
  if (count >= 0 && days.takeWord("day")) {
    days.takeOneOf("s");
    days.takeOneOf(",");
    days.skipBlanks();
    if (days.atEnd()) return std::nullopt;
    time.whole_s = count * 86400;
    reading = days;
  }
  const auto date = takeDate(reading);
  if (date) {
    time.dated = true;
    time.whole_s = *date * 86400;
    if (reading.atEnd()) return time;
    reading.takeOneOf("Tt_,");
    reading.skipBlanks();
  }
  std::array<int64_t, 3> parts{-1, -1, -1};
  parts[0] = reading.digits(1, 3);
  if (parts[0] < 0 || !reading.take(':')) return std::nullopt;
  parts[1] = reading.digits(2, 2);
  if (parts[1] < 0 || parts[1] > 59) return std::nullopt;
  Reading thousandths = reading;  // "01:07:040": minutes, seconds, milliseconds
  if (!time.dated && thousandths.take(':')) {
    const int64_t count_ms = thousandths.digits(3, 3);
    if (count_ms >= 0 && thousandths.atEnd()) {
      time.whole_s += parts[0] * 60 + parts[1];
      time.fraction_s = 1e-3 * static_cast<double>(count_ms);
      return time;
    }
  }
  const bool seconds = reading.take(':');
  if (seconds) parts[2] = reading.digits(2, 2);
  if (seconds && (parts[2] < 0 || parts[2] > 60)) return std::nullopt;
  bool fraction = false;
  if (reading.takeOneOf(".,") || (seconds && reading.takeOneOf(":;"))) {
    reading.take(':');
    time.fraction_s = reading.fraction();
    fraction = true;
  }
  if (seconds || !fraction) {
    time.whole_s += parts[0] * 3600 + parts[1] * 60 + (seconds ? parts[2] : 0);
  } else {
    time.whole_s += parts[0] * 60 + parts[1];
  }
  reading.skipBlanks();
  if (reading.takeWord("pm")) {
    if (parts[0] < 12) time.whole_s += 43200;
  } else if (reading.takeWord("am")) {
    if (parts[0] == 12) time.whole_s -= 43200;
  }
  if (!endsInZone(reading)) return std::nullopt;
  return time;
}

}  // namespace breakaway
