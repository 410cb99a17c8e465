#include "recording/import/settle_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/exact_text.h"
#include "base/marked_text.h"
#include "recording/import/number_text.h"

namespace breakaway {

namespace {

constexpr double firstStamp_s = 9e8, lastStamp_s = 4.2e9;  // 1998 to 2103 since 1970
constexpr double pauseWhenUnknown_s = 1.0;

bool isWhole(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return !std::isfinite(v) || v == std::floor(v); });
}

/// Median of the steps that aren't 0; 0 when there is none.
double usualStep(const std::vector<double>& values) {
  std::vector<double> steps;
  double last = NAN;
  for (const double value : values) {
    if (value > last) steps.push_back(value - last);
    if (std::isfinite(value)) last = value;
  }
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

struct UnitGuess {
  double unit_s = 1.0;
  MessageText<0> name = "s";
  bool sure = false;  ///< by the size of the stamps
  MessageText<0> since = "1970";
};

/// Clocks that count otherwise than from 1970, by the stamps that they have between 2000 and 2050: Windows' and .NET's
/// in 100 ns, Excel's in days, whose steps are fractions.
std::optional<UnitGuess> otherClock(double start, double step) {
  constexpr double slowest_d = 2e-5;
  if (start > 1.25e17 && start < 1.42e17) return UnitGuess{1e-7, "100 ns", true, "1601"};
  if (start > 6.3e17 && start < 6.47e17) return UnitGuess{1e-7, "100 ns", true, marked("the year 1")};
  if (start > 36526.0 && start < 54789.0 && step > 0.0 && step < slowest_d)
    return UnitGuess{86400.0, marked("days"), true, "1900"};
  return std::nullopt;
}

UnitGuess guessUnit(const RawTime& raw, double step) {
  constexpr std::array<UnitGuess, 4> some{
      UnitGuess{1.0, "s", true}, {1e-3, "ms", true}, {1e-6, "µs", true}, {1e-9, "ns", true}};
  const auto first = std::find_if(raw.values.begin(), raw.values.end(), [](double v) { return std::isfinite(v); });
  const double start = raw.origin + (first == raw.values.end() ? 0.0 : *first);
  for (const UnitGuess& one : some) {
    const double since1970_s = start * one.unit_s, step_s = step * one.unit_s;
    if (since1970_s > firstStamp_s && since1970_s < lastStamp_s && step_s > 1e-7 && step_s < 3600.0) return one;
  }
  if (const auto other = otherClock(start, step)) return *other;
  if (step < 0.5) return {};
  if (!isWhole(raw.values))
    return step < 10.0 ? UnitGuess{} : step < 250.0 ? UnitGuess{1e-3, "ms", false} : UnitGuess{1e-6, "µs", false};
  if (step >= 1e6) return {1e-9, "ns", false};
  return step >= 250.0 ? UnitGuess{1e-6, "µs", false} : UnitGuess{1e-3, "ms", false};
}

/// A log of a motor that would last less than 0.1 ms, with decimals: its clock is called µs and tells seconds; one
/// that lasts no microsecond does so however short it is in seconds.
void doubtUnit(const RawTime& raw, SettledTime& settled) {
  constexpr double shortest_s = 1e-4, none_s = 1e-6, asSeconds_s = 0.05;
  double low = INFINITY, high = -INFINITY;
  for (const double value : raw.values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  const double range = high - low;
  const double lasts_s = range * settled.unit_s;
  const bool tooShort = lasts_s < shortest_s && (range > asSeconds_s || lasts_s < none_s);
  if (raw.clock || !(range > 0.0) || !tooShort || isWhole(raw.values)) return;
  settled.remarks.push_back(message(
      "implausible: with the unit of its name the log would last {} s; its time was taken for s", shortText(lasts_s)));
  settled.unit_s = 1.0;
  settled.unitGuessed = true;
}

/// What a counter that falls like this has lost, or 0.
double wrapBetween(double last, double now, double step, const std::vector<double>& periods) {
  for (const double period : periods) {
    const double onward = now + period - last;
    if (last - now > 0.5 * period && onward > 0.0 && onward < std::max(50.0 * step, 1e-4 * period)) return period;
  }
  return 0.0;
}

/// Counters that start anew go on counting.
void unwrapCounter(RawTime& raw, double step, std::vector<Message>& remarks) {
  std::vector<double> periods;
  if (raw.clock) {
    periods = {86400.0, 43200.0};
  } else {
    const double unit = raw.unit_s.value_or(1.0);
    periods = {4294967296.0, 16777216.0, 65536.0, 86400.0 / unit, 4294.967296, 4294967.296};
  }
  double lost = 0.0, last = NAN;
  size_t wraps = 0;
  for (size_t k = 0; k < raw.values.size(); ++k) {
    double& value = raw.values[k];
    if (!std::isfinite(value)) continue;
    const double now = value + lost;
    const bool border = std::binary_search(raw.newFile.begin(), raw.newFile.end(), k);
    const double period = now < last && !border ? wrapBetween(last, now, step, periods) : 0.0;
    if (period > 0.0) ++wraps;
    lost += period;
    value += lost;
    last = value;
  }
  if (wraps > 0)
    remarks.push_back(message(
        "the clock starts anew in {}, as a counter that is full or at midnight; it goes on counting", placesIn(wraps)));
}

/// Rows that share a stamp are spread up to the next one.
void spreadRepeats(std::vector<double>& values, double step, std::vector<Message>& remarks) {
  size_t repeats = 0;
  double lastStep = step;
  for (size_t k = 0; k < values.size();) {
    size_t end = k + 1;
    while (end < values.size() && values[end] == values[k]) ++end;
    const size_t count = end - k;
    if (end < values.size() && values[end] > values[k]) lastStep = std::min(values[end] - values[k], 3.0 * step);
    const double first = values[k];
    for (size_t m = 1; m < count; ++m)
      values[k + m] = first + lastStep * static_cast<double>(m) / static_cast<double>(count);
    repeats += count - 1;
    k = end;
  }
  if (repeats > 0)
    remarks.push_back(
        repeats == 1
            ? message("1 row repeats the stamp before it and was spread evenly up to the next one")
            : message("{} rows repeat the stamp before them and were spread evenly up to the next one", repeats));
}

/// Whether the clock, having fallen at `k`, goes on from there instead of coming back.
bool beginsAnew(const std::vector<double>& values, size_t k, double highest, double step) {
  if (highest - values[k] < 5.0 * step) return false;
  size_t rising = 0;
  for (size_t m = k + 1; m < values.size() && m <= k + 5; ++m) {
    if (values[m] < values[m - 1] || values[m] > highest) return false;
    ++rising;
  }
  return rising >= 3;
}

/// Parts whose clocks begin anew follow one another.
void followOn(RawTime& raw, double step, double pause, std::vector<Message>& remarks) {
  double shift = 0.0, highest = NAN;
  size_t resets = 0, firstReset = 0;
  for (size_t k = 0; k < raw.values.size(); ++k) {
    const bool border = std::binary_search(raw.newFile.begin(), raw.newFile.end(), k);
    const double now = raw.values[k] + shift;
    if (std::isfinite(highest) && (now < highest || (border && now == highest))) {
      std::vector<double> next(raw.values.begin() + static_cast<std::ptrdiff_t>(k),
                               raw.values.begin() + static_cast<std::ptrdiff_t>(std::min(raw.values.size(), k + 7)));
      for (double& value : next) value += shift;
      if (border || beginsAnew(next, 0, highest, step)) {
        shift += highest + pause - now;
        if (!border && resets++ == 0) firstReset = k + 1;
      }
    }
    raw.values[k] += shift;
    if (!(raw.values[k] <= highest)) highest = raw.values[k];
  }
  if (resets > 0)
    remarks.push_back(
        message("the clock begins anew in {}, the first is row {}; what passed there is unknown, 1 s was taken",
                placesIn(resets), firstReset));
}

/// The rows whose time is there and increases.
Result<std::vector<size_t>> increasingRows(const std::vector<double>& values, double unit_s, double origin,
                                           const std::string& place, std::vector<Message>& remarks) {
  std::vector<size_t> rows;
  rows.reserve(values.size());
  size_t without = 0, falling = 0, firstFalling = 0;
  for (size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) {
      ++without;
    } else if (!rows.empty() && !(values[k] > values[rows.back()])) {
      if (falling++ == 0) firstFalling = k;
    } else {
      rows.push_back(k);
    }
  }
  if (rows.empty() || (rows.size() < 2 && values.size() > 1 && falling == 0))
    return Error{place, message("holds no times")};
  if (100 * falling > values.size()) {
    const double base = origin * unit_s;
    return Error{
        place + ", row " + std::to_string(firstFalling + 1) + ", column time_s",
        message("{} does not increase after {}, expected strictly increasing times",
                exactText(base + values[firstFalling] * unit_s), exactText(base + values[firstFalling - 1] * unit_s))};
  }
  if (without > 0)
    remarks.push_back(without == 1 ? message("1 row has no time and was left out")
                                   : message("{} rows have no time and were left out", without));
  if (falling > 0)
    remarks.push_back(
        falling == 1
            ? message("1 row's time falls back and was left out, the first is row {}", firstFalling + 1)
            : message("{} rows' times fall back and were left out, the first is row {}", falling, firstFalling + 1));
  return rows;
}

}  // namespace

std::vector<size_t> pausesIn(const std::vector<double>& time_s) {
  std::vector<size_t> pauses;
  const double step = usualStep(time_s);
  for (size_t k = 1; k < time_s.size(); ++k) {
    if (time_s[k] - time_s[k - 1] > 5.0 * step) pauses.push_back(k);
  }
  return pauses;
}

void sayPauses(const SettledTime& settled, std::vector<Message>& remarks) {
  if (settled.pauses.empty()) return;
  const size_t at = settled.pauses.front();
  const std::string length_s = shortText(settled.time_s[at] - settled.time_s[at - 1]);
  const size_t row = settled.rows[at - 1] + 1;
  remarks.push_back(settled.pauses.size() == 1
                        ? message("a pause of {} s after row {}", length_s, row)
                        : message("{} pauses, the first of {} s after row {}", settled.pauses.size(), length_s, row));
}

Result<SettledTime> settleTime(RawTime raw, const std::string& place) {
  SettledTime settled;
  const double step = usualStep(raw.values);
  unwrapCounter(raw, step, settled.remarks);
  if (!raw.unit_s && !raw.clock) {
    const UnitGuess guess = guessUnit(raw, step);
    settled.unit_s = guess.unit_s;
    settled.unitGuessed = !guess.sure;
    if (guess.unit_s != 1.0 || guess.sure)
      settled.remarks.push_back(
          guess.sure
              ? message("the time has no unit; its stamps are {} since {}", message(guess.name), message(guess.since))
              : message("the time has no unit; steps of {} were taken for {}", shortText(step), message(guess.name)));
  } else {
    settled.unit_s = raw.unit_s.value_or(1.0);
    doubtUnit(raw, settled);
  }
  followOn(raw, step, pauseWhenUnknown_s / settled.unit_s, settled.remarks);
  spreadRepeats(raw.values, step, settled.remarks);
  auto rows = increasingRows(raw.values, settled.unit_s, raw.origin, place, settled.remarks);
  if (!rows) return rows.error();
  settled.rows = std::move(*rows);
  settled.time_s.reserve(settled.rows.size());
  for (const size_t row : settled.rows) settled.time_s.push_back(raw.values[row] * settled.unit_s);
  constexpr double elevenDays_s = 1e6;
  const double start_s = raw.origin * settled.unit_s + settled.time_s.front();
  const bool fromFirst = raw.clock || std::abs(start_s) > elevenDays_s;
  const double shift = fromFirst ? -settled.time_s.front() : raw.origin * settled.unit_s;
  if (shift != 0.0) {
    for (double& value : settled.time_s) value += shift;
  }
  if (fromFirst && !raw.clock)
    settled.remarks.push_back(message("the time is counted from the first row, which was at {} s", shortText(start_s)));
  if (raw.clock) settled.remarks.push_back(message("times of day are counted from the first row"));
  for (size_t k = 1; k < settled.time_s.size(); ++k) {
    if (!(settled.time_s[k] > settled.time_s[k - 1]))
      return Error{place + ", row " + std::to_string(settled.rows[k] + 1) + ", column time_s",
                   message("differs from the row before by less than can be told")};
  }
  settled.pauses = pausesIn(settled.time_s);
  return settled;
}

}  // namespace breakaway
