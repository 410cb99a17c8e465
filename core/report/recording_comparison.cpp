#include "report/recording_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "draw/html_report.h"
#include "recording/columns.h"

namespace breakaway {

namespace {

constexpr size_t mostPoints = 4000;  // of a curve: no picture is wider

/// Mean and scatter of what has a value.
struct ChannelSpread {
  double sum = 0.0, squares = 0.0;
  size_t count = 0;

  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0.0; }
  double rms() const {
    return count > 0 ? std::sqrt(std::max(0.0, squares / static_cast<double>(count) - mean() * mean())) : 0.0;
  }
};

/// A channel over the time since the recording's beginning.
struct ChannelTrack {
  std::span<const double> time_s, values;
  double offset = 0.0;

  ChannelTrack(const Recording& recording, const Column& column)
      : time_s(recording.time()), values(recording.channel(column.name)) {
    const auto first = std::find_if(values.begin(), values.end(), [](double one) { return std::isfinite(one); });
    const bool place = column.quantity == Quantity::position || column.quantity == Quantity::positionReference;
    if (place && first != values.end()) offset = *first;
  }
  double since_s(size_t row) const { return time_s[row] - time_s[0]; }
  double at(size_t row) const { return values[row] - offset; }
  /// By a straight line between rows; NaN beside one without a value, and beyond the end.
  double atTime(double t_s) const {
    const auto next = std::lower_bound(time_s.begin(), time_s.end(), t_s + time_s[0]);
    if (next == time_s.end()) return std::numeric_limits<double>::quiet_NaN();
    const auto row = static_cast<size_t>(next - time_s.begin());
    if (row == 0) return at(0);
    const double part = (t_s + time_s[0] - time_s[row - 1]) / (time_s[row] - time_s[row - 1]);
    return at(row - 1) + part * (at(row) - at(row - 1));
  }
  ChannelSpread spread(double length_s) const {
    ChannelSpread all;
    for (size_t row = 0; row < values.size() && since_s(row) <= length_s; ++row) {
      if (std::isfinite(values[row])) all.add(at(row));
    }
    return all;
  }
};

/// The least and the greatest of each part, in the order in which they came.
Curve curveOf(const ChannelTrack& track, double length_s) {
  Curve curve;
  const auto last = std::upper_bound(track.time_s.begin(), track.time_s.end(), track.time_s[0] + length_s);
  const auto rows = static_cast<size_t>(last - track.time_s.begin());
  const size_t together = std::max<size_t>(1, 2 * rows / mostPoints);
  const auto take = [&](size_t row) {
    curve.x.push_back(track.since_s(row));
    curve.y.push_back(track.at(row));
  };
  for (size_t first = 0; first < rows; first += together) {
    const auto from = track.values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto to = from + static_cast<std::ptrdiff_t>(std::min(together, rows - first));
    const auto [least, greatest] = std::minmax_element(from, to);
    const auto one = static_cast<size_t>(least - track.values.begin());
    const auto other = static_cast<size_t>(greatest - track.values.begin());
    take(std::min(one, other));
    if (one != other) take(std::max(one, other));
  }
  return curve;
}

Figure figureOf(const Column& column, const ChannelTrack& before, const ChannelTrack& after, double length_s) {
  Figure figure{std::string(column.name), message("time since the beginning / s"), std::string(column.name)};
  Curve earlier = curveOf(before, length_s), later = curveOf(after, length_s);
  earlier.label = message("before");
  earlier.style = Curve::Style::dashed;
  later.label = message("after");
  figure.curves = {std::move(later), std::move(earlier)};
  return figure;
}

ChannelChange changeOf(const Column& column, const ChannelTrack& before, const ChannelTrack& after, double length_s) {
  const ChannelSpread one = before.spread(length_s), other = after.spread(length_s);
  ChannelSpread squares;
  for (size_t row = 0; row < after.values.size() && after.since_s(row) <= length_s; ++row) {
    const double difference = after.at(row) - before.atTime(after.since_s(row));
    if (std::isfinite(difference)) squares.add(difference * difference);
  }
  return {column.name, one.mean(), other.mean(), one.rms(), other.rms(), std::sqrt(squares.mean())};
}

}  // namespace

RecordingComparison compareRecordings(const Recording& before, const Recording& after) {
  RecordingComparison comparison;
  if (before.rows() < 2 || after.rows() < 2) return comparison;
  comparison.length_s =
      std::min(before.time().back() - before.time().front(), after.time().back() - after.time().front());
  for (const Column& column : columns()) {
    const bool compared = column.quantity != Quantity::time && column.cell != Cell::flag;
    if (!compared || !before.has(column.name) || !after.has(column.name)) continue;
    const ChannelTrack one(before, column), other(after, column);
    comparison.channels.push_back(changeOf(column, one, other, comparison.length_s));
    comparison.figures.push_back(figureOf(column, one, other, comparison.length_s));
  }
  return comparison;
}

Message sentenceOf(const ChannelChange& change) {
  const auto number = [](double value) { return numberText(value, 3); };
  return message("{}: mean {} → {}, scatter {} → {}; laid over each other they differ by {} (RMS).", change.channel,
                 number(change.meanBefore), number(change.meanAfter), number(change.rmsBefore), number(change.rmsAfter),
                 number(change.differenceRms));
}

}  // namespace breakaway
