// Which rows a log has, and when they were.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include "recording/import/name_parts.h"
#include "recording/import/settling.h"
#include "recording/import/trials.h"

namespace breakaway {

namespace {

/// Nine of ten are within a fifth of the middle one: a loop's, rather than how long a turn took.
bool areAlike(const std::vector<double>& steps, double middle) {
  constexpr double within = 0.2, most = 0.9;
  const auto alike =
      std::count_if(steps.begin(), steps.end(), [&](double step) { return std::abs(step - middle) < within * middle; });
  return static_cast<double>(alike) > most * static_cast<double>(steps.size());
}

}  // namespace

std::optional<size_t> Settling::sumSteps() {
  static constexpr auto periods =
      std::to_array<std::string_view>({"period", "loop_period", "cycle_period", "control_period", "sample_period",
                                       "sampling_period", "sample_time", "sampling_time"});
  static constexpr auto names = std::to_array<std::string_view>(
      {"dt", "delta_t", "deltat", "delta_time", "deltatime", "time_delta", "time_diff", "time_difference", "t_diff"});
  for (size_t c = 0; c < fates_.size(); ++c) {
    if (fates_[c].kind != ColumnFate::Kind::kept || table_.columns[c].clock) continue;
    const NameParts parts = partsOfName(fates_[c].from, table_.columns[c].unit);
    std::string name;
    for (const std::string& word : parts.words) name += (name.empty() ? "" : "_") + word;
    std::vector<double>& steps = values(c);
    const bool period = isIn(periods, name) && parts.unit != nullptr;
    const bool known = (period || isIn(names, name)) && (parts.unit == nullptr || parts.unit->kind == UnitKind::time);
    const bool goOn = std::all_of(steps.begin(), steps.end(), [](double step) { return step >= 0.0; });
    if (!known || parts.unknownUnit || !goOn || steps.size() < 2) continue;
    std::vector<double> sorted(steps.begin() + 1, steps.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    if (period && !areAlike(steps, *middle)) continue;
    constexpr double fewestMicroseconds = 250.0;
    const bool micros = *middle >= fewestMicroseconds;
    const char* unit = micros ? "us" : *middle >= 1.0 ? "ms" : "s";
    fates_[c].unit = parts.unit != nullptr ? parts.unitText : unit;
    fates_[c].scale = parts.unit != nullptr ? parts.unit->scale * parts.factor : unitNamed(unit)->scale;
    fates_[c].kind = ColumnFate::Kind::used;
    fates_[c].to = "time_s";
    steps.front() = 0.0;
    std::partial_sum(steps.begin(), steps.end(), steps.begin());
    return c;
  }
  return std::nullopt;
}

Result<void> Settling::takeTime() {
  auto c = columnOf("time_s");
  const bool steps = !c && !map_.sample_time_s && (c = sumSteps());
  RawTime raw;
  if (map_.sample_time_s) {
    for (size_t k = 0; k < table_.rows(); ++k) raw.values.push_back(static_cast<double>(k) * *map_.sample_time_s);
    raw.unit_s = 1.0;
  } else if (!c) {
    return Error{path_, message("no column could be taken for the time; there are: {}; say which with --map, or how "
                                "far the rows are apart: {}",
                                names(), "{\"sample_time_s\": 0.01}")};
  } else {
    raw.values = std::move(values(*c));
    raw.origin = table_.columns[*c].origin;
    raw.clock = table_.columns[*c].clock;
    if (!fates_[*c].unit.empty() && !raw.clock) raw.unit_s = fates_[*c].scale;
    convert(raw.values, 1.0, fates_[*c].offset / (fates_[*c].scale == 0.0 ? 1.0 : fates_[*c].scale));
    settled_.insert(*c);
    raw.newFile = newFile_;
    followTrials(raw);
  }
  auto time = settleTime(std::move(raw), path_);
  if (!time) return time.error();
  time_ = std::move(*time);
  remarks_.insert(remarks_.end(), time_.remarks.begin(), time_.remarks.end());
  if (c && !map_.sample_time_s) {
    fates_[*c].scale = time_.unit_s;
    fates_[*c].guessed = time_.unitGuessed || !fates_[*c].doubt.empty();
    if (time_.unitGuessed) {
      fates_[*c].unit.clear();
      fates_[*c].why = message("judged by its steps");
    }
    if (steps) {
      fates_[*c].guessed = true;
      fates_[*c].why = message("each row's time since the row before, summed");
    }
    if (fates_[*c].unit.empty()) fates_[*c].unit = table_.columns[*c].clock ? "clock" : unitNameOf(time_.unit_s);
  }
  takeRows(c.value_or(choices_.size()));
  return {};
}

void Settling::followTrials(RawTime& raw) {
  const auto trials = trialsIn(table_);
  if (!trials || raw.clock) return;
  std::vector<size_t> falls;
  for (const size_t border : trials->borders) {
    if (raw.values[border] <= raw.values[border - 1]) falls.push_back(border);
  }
  if (falls.empty()) return;
  const std::string& column = table_.columns[trials->column].channel.name;
  remarks_.push_back(
      message("{} parts the rows into {}, and the clock begins anew in {} of them, 1 s later here; --map {} parts them",
              column, trials->borders.size() + 1, falls.size(), "{\"split\": \"" + column + "\"}"));
  std::vector<size_t> all;
  std::set_union(falls.begin(), falls.end(), raw.newFile.begin(), raw.newFile.end(), std::back_inserter(all));
  raw.newFile = std::move(all);
}

std::string Settling::unitNameOf(double unit_s) {
  if (unit_s > 1e4) return "days";
  return unit_s > 0.5 ? "s" : unit_s > 0.5e-3 ? "ms" : unit_s > 0.5e-6 ? "µs" : unit_s > 0.5e-7 ? "100 ns" : "ns";
}

void Settling::takeRows(size_t time) {
  for (size_t c = 0; c < choices_.size(); ++c) {
    if (c == time && !map_.sample_time_s) continue;
    RawColumn& column = table_.columns[c];
    if (time_.rows.size() != column.channel.values.size())
      column.channel.values = rowsOf(column.channel.values, time_.rows);
    if (column.origin != 0.0) convert(column.channel.values, 1.0, column.origin);
  }
}

Result<void> Settling::sparseRows() {
  auto motion = columnOf("angle_rad");
  if (!motion) motion = columnOf("position_m");
  if (!motion) motion = columnOf("velocity_rad_per_s");
  if (!motion) return {};
  std::vector<size_t> rows;
  for (size_t k = 0; k < time_.time_s.size(); ++k) {
    if (std::isfinite(values(*motion)[k])) rows.push_back(k);
  }
  const size_t all = time_.time_s.size();
  if (rows.empty()) return Error{path_ + ", column " + fates_[*motion].from, message("holds no number")};
  if (5 * rows.size() > 4 * all) return {};
  const auto time = columnOf("time_s");
  for (size_t c = 0; c < choices_.size(); ++c) {
    if (fates_[c].kind == ColumnFate::Kind::leftOut || (time && c == *time && !map_.sample_time_s)) continue;
    double held = NAN;
    if (c != *motion) {
      for (double& value : values(c)) held = value = std::isfinite(value) ? value : held;
    }
    values(c) = rowsOf(values(c), rows);
  }
  time_.time_s = rowsOf(time_.time_s, rows);
  std::vector<size_t> before = std::move(time_.rows);
  time_.rows.clear();
  for (const size_t row : rows) time_.rows.push_back(before[row]);
  time_.pauses = pausesIn(time_.time_s);
  remarks_.push_back(message("{} of {} rows have {} and stay; the other columns hold their last value there",
                             rows.size(), all, fates_[*motion].from));
  return {};
}

void Settling::settleTimeByMotion() {
  const auto time = columnOf("time_s"), angle = columnOf("angle_rad"), speed = columnOf("velocity_rad_per_s");
  if (!time || !time_.unitGuessed || !angle || !speed || fates_[*angle].unit.empty() || fates_[*speed].unit.empty())
    return;
  const auto motion = compareMotion(time_.time_s, values(*angle), values(*speed), time_.pauses);
  if (!motion || motion->correlation < 0.9) return;
  for (const double factor : {1e-6, 1e-3, 1e3, 1e6}) {
    const double unit_s = time_.unit_s * factor;
    if (std::abs(std::log(motion->factor / factor)) > std::log(1.15) || unit_s < 0.5e-9 || unit_s > 1.5) continue;
    convert(time_.time_s, factor, 0.0);
    time_.unit_s = unit_s;
    fates_[*time].scale = unit_s;
    fates_[*time].unit = unitNameOf(unit_s);
    fates_[*time].why = message("so the speed agrees with the angle");
    std::erase_if(remarks_, [](const std::string& one) { return one.starts_with("the time has no unit"); });
    remarks_.push_back(message("the time has no unit; it was taken for {}, with which the speed agrees with the angle",
                               fates_[*time].unit));
    return;
  }
}

}  // namespace breakaway
