#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/numbers.h"
#include "recording/import/axes_in_turn.h"
#include "recording/import/choose_columns.h"
#include "recording/import/import.h"
#include "recording/import/known_tools.h"
#include "recording/import/number_text.h"
#include "recording/import/plausible.h"
#include "recording/import/settle_motion.h"
#include "recording/import/settle_time.h"

namespace breakaway {

namespace {

bool isAngle(const std::string& to) {
  return to == "angle_rad" || to == "angle_reference_rad";
}

bool isSpeed(const std::string& to) {
  return to == "velocity_rad_per_s" || to == "velocity_reference_rad_per_s";
}

/// A name that a header line can hold.
std::string plainName(std::string name, size_t column) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c == ',' || c == '"' || c == '#' || c < 0x20; }, '_');
  const size_t start = name.find_first_not_of(' ');
  if (start == std::string::npos) return "column_" + std::to_string(column + 1);
  return name.substr(start, name.find_last_not_of(' ') - start + 1);
}

void convert(std::vector<double>& values, double scale, double offset) {
  if (scale == 1.0 && offset == 0.0) return;
  for (double& value : values) value = scale * value + offset;
}

std::vector<double> rowsOf(const std::vector<double>& values, const std::vector<size_t>& rows) {
  std::vector<double> kept;
  kept.reserve(rows.size());
  for (const size_t row : rows) kept.push_back(values[row]);
  return kept;
}

/// A log on its way to a recording.
class Settling {
 public:
  Settling(RawTable table, const ImportMap& map, std::string path, std::vector<size_t> newFile)
      : table_(std::move(table)), map_(map), path_(std::move(path)), newFile_(std::move(newFile)) {}

  Result<Imported> run() {
    const ToolColumns tool = recogniseTool(table_, map_.counts_per_rev.value_or(0.0));
    remarks_ = table_.remarks;
    auto choices = chooseColumns(table_, map_, tool, path_);
    if (!choices) return choices.error();
    choices_ = std::move(*choices);
    for (size_t c = 0; c < choices_.size(); ++c) fates_.push_back(fateOf(c));
    if (const auto one = needOneAxis(); !one) return one.error();
    if (const auto done = takeTime(); !done) return done.error();
    if (const auto done = sparseRows(); !done) return done.error();
    if (const auto done = takeIntegral(); !done) return done.error();
    if (const auto done = takeAngle(); !done) return done.error();
    if (const auto done = takeSpeed(); !done) return done.error();
    settleTimeByMotion();
    if (const auto done = takeDuty(); !done) return done.error();
    settleVoltage();
    for (size_t c = 0; c < choices_.size(); ++c) {
      if (isOpen(c)) {
        if (const auto done = takeOther(c); !done) return done.error();
      }
    }
    if (const auto done = turnSigns(); !done) return done.error();
    differentiate();
    if (const auto done = needMotion(); !done) return done.error();
    checkMotion();
    return seal();
  }

 private:
  ColumnFate fateOf(size_t c) const {
    const Choice& choice = choices_[c];
    ColumnFate fate;
    fate.from = table_.columns[c].channel.name;
    fate.kind = choice.dropped             ? ColumnFate::Kind::leftOut
                : choice.name.understood() ? ColumnFate::Kind::used
                                           : ColumnFate::Kind::kept;
    fate.to = choice.name.understood() ? choice.name.to : plainName(fate.from, c);
    fate.scale = choice.name.scale;
    fate.offset = choice.name.offset;
    fate.unit = choice.name.unit;
    fate.why = choice.name.understood() ? (choice.byMap         ? "the map says so"
                                           : choice.byTool      ? "as that tool has it"
                                           : choice.name.byUnit ? "by its unit alone"
                                                                : "by its name")
                                        : choice.name.aside;
    fate.guessed = choice.name.understood() && (choice.name.unit.empty() || choice.name.byUnit);
    return fate;
  }

  bool is(size_t c, const std::string& to) const {
    return fates_[c].kind == ColumnFate::Kind::used && fates_[c].to == to;
  }
  std::optional<size_t> columnOf(const std::string& to) const {
    for (size_t c = 0; c < fates_.size(); ++c) {
      if (is(c, to)) return c;
    }
    return std::nullopt;
  }
  std::vector<double>& values(size_t c) { return table_.columns[c].channel.values; }
  bool isOpen(size_t c) const { return fates_[c].kind == ColumnFate::Kind::used && !settled_.contains(c); }
  void keep(size_t c, const std::string& why) {
    fates_[c].kind = ColumnFate::Kind::kept;
    fates_[c].to = plainName(fates_[c].from, c);
    fates_[c].why = why;
    fates_[c].guessed = false;
  }
  std::string names() const {
    std::string text;
    for (const ColumnFate& fate : fates_) {
      if (fate.kind == ColumnFate::Kind::leftOut) continue;
      text += (text.empty() ? "" : ", ") + fate.to;
      if (text.size() > 300) return text + ", …";
    }
    return text;
  }

  /// Rows of several motors in turn are no motion of one.
  Result<void> needOneAxis() {
    if (!map_.split.empty()) return {};
    std::optional<size_t> motion;
    for (const char* name : {"angle_rad", "position_m", "velocity_rad_per_s", "velocity_m_per_s"}) {
      if (!motion) motion = columnOf(name);
    }
    if (!motion) return {};
    std::vector<bool> free;
    free.reserve(choices_.size());
    for (const Choice& choice : choices_) free.push_back(!choice.name.understood() && !choice.byMap && !choice.byTool);
    const auto turn = axesInTurn(table_, free, *motion, columnOf("time_s"));
    if (!turn) return {};
    std::string list;
    for (size_t k = 0; k < turn->names.size() && k < 4; ++k) list += (k == 0 ? "" : ", ") + turn->names[k];
    const std::string& column = table_.columns[turn->column].channel.name;
    return Error{path_ + ", column " + column,
                 "rows of " + std::to_string(turn->names.size()) + " axes stand in one table (" + list +
                     (turn->names.size() > 4 ? ", …" : "") + "); part them with --map {\"split\": \"" + column + "\"}"};
  }

  Result<void> takeTime() {
    const auto c = columnOf("time_s");
    RawTime raw;
    if (map_.sample_time_s) {
      for (size_t k = 0; k < table_.rows(); ++k) raw.values.push_back(static_cast<double>(k) * *map_.sample_time_s);
      raw.unit_s = 1.0;
    } else if (!c) {
      return Error{path_, "no column could be taken for the time; there are: " + names() +
                              "; say which with --map, or how far the rows are apart: {\"sample_time_s\": 0.01}"};
    } else {
      raw.values = std::move(values(*c));
      raw.origin = table_.columns[*c].origin;
      raw.clock = table_.columns[*c].clock;
      if (!fates_[*c].unit.empty() && !raw.clock) raw.unit_s = fates_[*c].scale;
      convert(raw.values, 1.0, fates_[*c].offset / (fates_[*c].scale == 0.0 ? 1.0 : fates_[*c].scale));
      settled_.insert(*c);
      raw.newFile = newFile_;
    }
    auto time = settleTime(std::move(raw), path_);
    if (!time) return time.error();
    time_ = std::move(*time);
    remarks_.insert(remarks_.end(), time_.remarks.begin(), time_.remarks.end());
    if (c && !map_.sample_time_s) {
      fates_[*c].scale = time_.unit_s;
      fates_[*c].guessed = time_.unitGuessed;
      if (time_.unitGuessed) fates_[*c].why = "judged by its steps";
      if (fates_[*c].unit.empty()) fates_[*c].unit = table_.columns[*c].clock ? "clock" : unitNameOf(time_.unit_s);
    }
    takeRows(c.value_or(choices_.size()));
    return {};
  }

  static std::string unitNameOf(double unit_s) {
    if (unit_s > 1e4) return "days";
    return unit_s > 0.5 ? "s" : unit_s > 0.5e-3 ? "ms" : unit_s > 0.5e-6 ? "µs" : unit_s > 0.5e-7 ? "100 ns" : "ns";
  }

  /// Keeps the rows that have a time, in all columns but `time`.
  void takeRows(size_t time) {
    for (size_t c = 0; c < choices_.size(); ++c) {
      if (c == time && !map_.sample_time_s) continue;
      RawColumn& column = table_.columns[c];
      if (time_.rows.size() != column.channel.values.size())
        column.channel.values = rowsOf(column.channel.values, time_.rows);
      if (column.origin != 0.0) convert(column.channel.values, 1.0, column.origin);
    }
  }

  /// Logs that put each topic in rows of its own: the rows with an angle stay, the others' values are held.
  Result<void> sparseRows() {
    auto motion = columnOf("angle_rad");
    if (!motion) motion = columnOf("position_m");
    if (!motion) motion = columnOf("velocity_rad_per_s");
    if (!motion) return {};
    std::vector<size_t> rows;
    for (size_t k = 0; k < time_.time_s.size(); ++k) {
      if (std::isfinite(values(*motion)[k])) rows.push_back(k);
    }
    const size_t all = time_.time_s.size();
    if (rows.empty()) return Error{path_ + ", column " + fates_[*motion].from, "holds no number"};
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
    remarks_.push_back(std::to_string(rows.size()) + " of " + std::to_string(all) + " rows have " +
                       fates_[*motion].from + " and stay; the other columns hold their last value there");
    return {};
  }

  /// What the factor still lacks: from the map, or an error that asks for it when `needed`.
  Result<bool> fillNeed(size_t c, bool needed) {
    ColumnFate& fate = fates_[c];
    const UnitNeeds needs = choices_[c].name.needs;
    if (needs == UnitNeeds::nothing) return true;
    const bool counts = needs == UnitNeeds::countsPerRev;
    const auto& given = counts ? map_.counts_per_rev : map_.pole_pairs;
    if (given) {
      fate.scale /= *given;
      return true;
    }
    const std::string ask =
        counts ? "counts, and no file says how many are one turn; say it with --map {\"counts_per_rev\": 4096}"
               : "speaks of electrical turns, and no file says the motor's pole pairs; say them with "
                 "--map {\"pole_pairs\": 7}";
    if (needed) return Error{path_ + ", column " + fate.from, ask};
    keep(c, ask);
    return false;
  }

  double gear(const std::string& to) const {
    return isAngle(to) || isSpeed(to) ? map_.gear_ratio.value_or(1.0)
           : to == "torque_Nm"        ? 1.0 / map_.gear_ratio.value_or(1.0)
                                      : 1.0;
  }

  void apply(size_t c) {
    const double gear_ratio = gear(fates_[c].to);
    convert(values(c), fates_[c].scale * gear_ratio, fates_[c].offset * gear_ratio);
    fates_[c].scale *= gear_ratio;
    fates_[c].offset *= gear_ratio;
    settled_.insert(c);
  }

  bool hasMeasuredSpeed() const { return columnOf("velocity_rad_per_s").has_value(); }

  Result<void> takeAngle() {
    const auto c = columnOf("angle_rad");
    if (!c || settled_.contains(*c)) return {};
    ColumnFate& fate = fates_[*c];
    auto& angle = values(*c);
    if (const auto filled = fillNeed(*c, true); !filled) return filled.error();
    const bool counted = choices_[*c].name.needs == UnitNeeds::countsPerRev;
    const double perTurn = choices_[*c].name.needs == UnitNeeds::polePairs ? map_.pole_pairs.value_or(1.0) : 1.0;
    std::optional<double> expected;
    if (!fate.unit.empty()) expected = turn_rad / (fate.scale * perTurn);
    const auto period = periodOf(angle, time_.pauses, expected);
    if (fate.unit.empty()) {
      if (const auto known = nameUnit(*c, period); !known) return known.error();
      if (fate.scale != 1.0 / perTurn) fate.scale /= perTurn;
    }
    const double turns = period ? *period * fate.scale * perTurn / turn_rad : 0.0;
    const bool whole = std::abs(turns - 1.0) < 1e-3;
    const bool overflow = period && areWhole(angle) && (*period == 65536.0 || counted) && turns > 1.5;
    if (period && (whole || overflow)) unwindBy(angle, *period, whole);
    apply(*c);
    return {};
  }

  void unwindBy(std::vector<double>& angle, double period, bool whole) {
    const Unwound unwound = unwind(angle, period, time_.pauses);
    remarks_.push_back(std::string("the angle ") + (whole ? "starts anew with each turn" : "overflows its register") +
                       ", in " + std::to_string(unwound.places) + (unwound.places == 1 ? " place" : " places") +
                       "; it goes on counting now");
    if (!time_.pauses.empty())
      remarks_.emplace_back("turns made during a pause are unknown: over it the angle may be wrong by whole turns");
    if (unwound.largestStep > 0.4)
      remarks_.push_back("it moves up to " + shortText(unwound.largestStep) +
                         " turns from row to row; from half a turn on nobody can tell which way, so check the result");
  }

  /// A unit for an angle whose name tells none.
  Result<void> nameUnit(size_t c, const std::optional<double>& period) {
    ColumnFate& fate = fates_[c];
    const auto& angle = values(c);
    const auto set = [&fate](double scale, const char* unit, const std::string& why) {
      fate.scale = scale;
      fate.unit = unit;
      fate.why = why;
      fate.guessed = true;
    };
    if (map_.counts_per_rev && areWhole(angle)) {
      set(turn_rad / *map_.counts_per_rev, "counts", "whole numbers, with the map's counts per turn");
      return {};
    }
    if (period && *period == 360.0) return set(turn_rad / 360.0, "deg", "it starts anew after 360"), Result<void>{};
    if (period && *period == 1.0) return set(turn_rad, "turns", "it starts anew after 1"), Result<void>{};
    if (isCountedAsSpeed(c)) {
      choices_[c].name.needs = UnitNeeds::countsPerRev;
      set(turn_rad, "counts", "so it agrees with the speed, which is in counts");
      const auto filled = fillNeed(c, true);
      return filled ? Result<void>{} : filled.error();
    }
    if (unitsByEachOther(c)) return {};
    if (const auto scale = scaleBySpeed(c)) {
      set(*scale, *scale == 1.0 ? "rad" : *scale == turn_rad ? "turns" : "deg", "so it agrees with the speed");
      return {};
    }
    constexpr double manyTurns = 30.0;
    if (areWhole(angle) && rangeOf(angle) >= manyTurns) {
      const std::string hint = period ? ", perhaps " + shortText(*period) + ", after which it starts anew" : "";
      return Error{path_ + ", column " + fate.from, "holds whole numbers and no unit; say how many are one turn" +
                                                        hint + ", with --map {\"counts_per_rev\": " +
                                                        (period ? shortText(*period) : "4096") + "}, or name its unit"};
    }
    fate.why = "by its name, which tells no unit";
    return {};
  }

  /// By the speed, if that tells its unit: an angle in rad, deg or turns.
  std::optional<double> scaleBySpeed(size_t c) {
    const auto v = columnOf("velocity_rad_per_s");
    if (!v || fates_[*v].unit.empty() || choices_[*v].name.needs != UnitNeeds::nothing) return std::nullopt;
    std::vector<double> speed = values(*v);
    convert(speed, fates_[*v].scale, fates_[*v].offset);
    const auto motion = compareMotion(time_.time_s, values(c), speed, time_.pauses);
    if (!motion || motion->correlation < 0.9) return std::nullopt;
    for (const double scale : {1.0, turn_rad / 360.0, turn_rad}) {
      if (std::abs(std::log(motion->factor * scale)) < std::log(1.15)) return scale;
    }
    return std::nullopt;
  }

  std::optional<MotionFactor> motionOf(size_t angle, size_t speed) {
    return compareMotion(time_.time_s, values(angle), values(speed), time_.pauses);
  }

  /// Beside a speed in counts per second an angle that goes on as fast is in counts.
  bool isCountedAsSpeed(size_t c) {
    const auto v = columnOf("velocity_rad_per_s");
    if (!v || choices_[*v].name.needs != UnitNeeds::countsPerRev) return false;
    const auto motion = motionOf(c, *v);
    return motion && motion->correlation > 0.9 && std::abs(std::log(motion->factor)) < std::log(1.15);
  }

  /// Where neither angle nor speed tells a unit, the factor between them may: 6 is that of degrees and rpm.
  bool unitsByEachOther(size_t c) {
    const auto v = columnOf("velocity_rad_per_s");
    if (!v || !fates_[*v].unit.empty() || choices_[*v].name.needs != UnitNeeds::nothing) return false;
    const auto motion = motionOf(c, *v);
    if (!motion || motion->correlation < 0.95) return false;
    const auto pair = unitsByFactor(motion->factor);
    if (!pair) return false;
    const auto set = [this](size_t column, const char* unit, double scale, const std::string& why) {
      fates_[column].unit = unit;
      fates_[column].scale = scale;
      fates_[column].why = why;
      fates_[column].guessed = true;
    };
    const std::string only = "only so it agrees with ";
    set(c, pair->angle, pair->angle_rad, only + fates_[*v].from + " in " + pair->speed);
    set(*v, pair->speed, pair->speed_rad_per_s, only + fates_[c].from + " in " + pair->angle);
    return true;
  }

  Result<void> takeSpeed() {
    const auto c = columnOf("velocity_rad_per_s");
    if (!c || settled_.contains(*c)) return {};
    const auto angle = columnOf("angle_rad");
    const bool alone = !angle && !columnOf("position_m");
    const auto filled = fillNeed(*c, alone);
    if (!filled) return filled.error();
    if (!*filled) return {};
    if (fates_[*c].unit.empty() && angle && !fates_[*angle].unit.empty()) speedByAngle(*c, *angle);
    if (fates_[*c].unit.empty() && is(*c, "velocity_rad_per_s")) {
      if (const auto known = nameSpeedUnit(*c, alone); !known) return known.error();
    }
    if (is(*c, "velocity_rad_per_s")) apply(*c);
    return {};
  }

  /// A unit for a speed that nothing else tells.
  Result<void> nameSpeedUnit(size_t c, bool alone) {
    ColumnFate& fate = fates_[c];
    if (const Unit* usual = unitNamed(choices_[c].name.usual); usual != nullptr) {
      fate.scale = usual->scale;
      fate.unit = choices_[c].name.usual;
      fate.why = "such a speed is counted so";
      fate.guessed = true;
      return {};
    }
    constexpr double manyRadians_per_s = 30.0;
    if (!alone || choices_[c].byMap || !areWhole(values(c)) || largest(values(c)) < manyRadians_per_s) return {};
    return Error{path_ + ", column " + fate.from,
                 "holds whole numbers and no unit; say it with --map {\"columns\": {\"" + fate.from +
                     "\": {\"to\": \"velocity_rad_per_s\", \"unit\": \"rpm\"}}}"};
  }

  void speedByAngle(size_t c, size_t angle) {
    const auto motion = compareMotion(time_.time_s, values(angle), values(c), time_.pauses);
    if (!motion || std::abs(motion->correlation) < 0.9) return;
    struct Candidate {
      double scale;
      std::string unit;
    };
    const Candidate sameUnit{fates_[angle].scale / gear(fates_[angle].to), fates_[angle].unit + "/s"};
    for (const Candidate& one : {Candidate{1.0, "rad/s"},
                                 {turn_rad / 360.0, "deg/s"},
                                 {turn_rad / 60.0, "rpm"},
                                 {turn_rad, "turns/s"},
                                 sameUnit}) {
      if (std::abs(std::log(std::abs(motion->factor) / one.scale)) > std::log(1.15)) continue;
      fates_[c].scale = one.scale;
      fates_[c].unit = one.unit;
      fates_[c].why = "so it agrees with the angle";
      fates_[c].guessed = true;
      return;
    }
    keep(c, "its name tells no unit, and in none that is usual it agrees with the angle (factor " +
                shortText(motion->factor) + ")");
  }

  /// Angle and speed tell the unit of the time where nothing else does.
  void settleTimeByMotion() {
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
      fates_[*time].why = "so the speed agrees with the angle";
      std::erase_if(remarks_, [](const std::string& one) { return one.starts_with("the time has no unit"); });
      remarks_.push_back("the time has no unit; it was taken for " + fates_[*time].unit +
                         ", with which the speed agrees with the angle");
      return;
    }
  }

  Result<void> takeDuty() {
    const auto c = columnOf("duty");
    if (!c || settled_.contains(*c)) return {};
    ColumnFate& fate = fates_[*c];
    auto& duty = values(*c);
    if (fate.unit.empty() && arePulseWidths(duty)) {
      keep(*c, "holds the pulse widths of a servo or a speed controller in µs, whose stop no file says");
      return {};
    }
    if (fate.unit.empty() || fate.unit == "1") {
      const auto words = wordsOf(fate.from, true);
      const bool pwm = std::find(words.begin(), words.end(), "pwm") != words.end();
      const auto full = fullDutyOf(duty, pwm);
      if (!full)
        return dutyBeyond(*c, "can be the whole of it; say it with --map, e.g. {\"columns\": {\"" + fate.from +
                                  "\": {\"to\": \"duty\", \"scale\": 0.001}}}");
      if (*full != 1.0) {
        fate.scale = 1.0 / *full;
        fate.unit = *full == 100.0 ? "%" : "1/" + shortText(*full);
        fate.why =
            "its values go up to " + shortText(largest(duty)) + ", so " + shortText(*full) + " was taken for full";
        fate.guessed = true;
      }
    }
    apply(*c);
    if (largest(duty) > 1.0 + 1e-6 && largest(duty) < 1.02) {
      for (double& value : duty) value = std::clamp(value, -1.0, 1.0);
      remarks_.emplace_back("the duty exceeds 1 by less than 2 % and was limited");
    }
    if (largest(duty) > 1.0 + 1e-6) return dutyBeyond(*c, "is a duty, which ends at 1");
    return {};
  }

  Result<void> dutyBeyond(size_t c, const std::string& what) {
    const auto& duty = values(c);
    const auto at = std::max_element(duty.begin(), duty.end(), [](double a, double b) {
      return (std::isfinite(a) ? std::abs(a) : -1.0) < (std::isfinite(b) ? std::abs(b) : -1.0);
    });
    return Error{path_ + ", row " + std::to_string(time_.rows[static_cast<size_t>(at - duty.begin())] + 1) +
                     ", column " + fates_[c].from,
                 shortText(*at) + ", the largest value: nothing tells which one " + what};
  }

  Result<void> takeOther(size_t c) {
    const auto filled = fillNeed(c, false);
    if (!filled) return filled.error();
    if (!*filled) return {};
    std::string& to = fates_[c].to;
    if (setCountsAside(c)) return {};
    const bool torque = to == "force_N" && fates_[c].unit.empty() && columnOf("angle_rad") && !columnOf("torque_Nm");
    if (torque) {
      to = "torque_Nm";
      fates_[c].unit = "Nm";
      fates_[c].why = "what turns is driven by a torque";
    }
    // References are counted as what was measured is.
    const auto measured = columnOf(to == "angle_reference_rad" ? "angle_rad" : "velocity_rad_per_s");
    if ((to == "angle_reference_rad" || to == "velocity_reference_rad_per_s") && fates_[c].unit.empty() && measured) {
      fates_[c].scale = fates_[*measured].scale / gear(to);
      fates_[c].unit = fates_[*measured].unit;
      fates_[c].why = "in the unit of " + fates_[*measured].from;
    }
    apply(c);
    return {};
  }

  /// Electrical values without a unit that look like a converter's counts or like mA.
  bool setCountsAside(size_t c) {
    const std::string& to = fates_[c].to;
    const bool drive = to == "current_A" || to == "torque_Nm" || to == "force_N" || to == "current_reference_A";
    const double most = drive ? 60.0 : to == "voltage_V" || to == "supply_V" ? 120.0 : 0.0;
    const bool guessed = fates_[c].guessed && fates_[c].unit.empty() && !choices_[c].byMap;
    if (most == 0.0 || !guessed || !areWhole(values(c)) || largest(values(c)) <= most) return false;
    const std::string what = "whole numbers up to " + shortText(largest(values(c))) +
                             " and no unit; they may be thousandths or a converter's counts";
    remarks_.push_back("implausible: " + fates_[c].from + " holds " + what);
    keep(c, "holds " + what + ": say which with --map");
    return true;
  }

  /// A voltage that hardly changes while the axis turns both ways, or while a duty drives it, is the supply's.
  void settleVoltage() {
    const auto c = columnOf("voltage_V");
    if (!c || choices_[*c].byMap || choices_[*c].byTool) return;
    for (const std::string& word : wordsOf(fates_[*c].from, true)) {
      if (word == "motor" || word == "mot" || word == "q" || word == "uq" || word == "vq" || word == "vm") return;
    }
    if (!hardlyChanges(values(*c))) return;
    const auto duty = columnOf("duty");
    const bool driven = duty && rangeOf(values(*duty)) > 0.2 * largest(values(*duty));
    if (!driven && !turnsBothWays()) return;
    const std::string why = driven ? "it hardly changes while the duty does"
                                   : "it hardly changes while the axis turns "
                                     "both ways";
    if (columnOf("supply_V")) return keep(*c, why + ", so it is no motor's voltage");
    fates_[*c].to = "supply_V";
    fates_[*c].why = why;
    fates_[*c].guessed = true;
    if (fates_[*c].unit.empty()) fates_[*c].unit = "V";
  }

  bool turnsBothWays() {
    const auto speed = columnOf("velocity_rad_per_s"), angle = columnOf("angle_rad");
    return speed ? goesBothWays(values(*speed)) : angle && goesBothWays(changesOf(values(*angle)));
  }

  Result<void> takeIntegral() {
    if (map_.integrate.empty()) return {};
    if (columnOf("angle_rad") || columnOf("position_m"))
      return Error{path_, "has an angle already, so nothing is to be integrated"};
    for (size_t c = 0; c < fates_.size(); ++c) {
      if (fates_[c].from != map_.integrate || fates_[c].kind == ColumnFate::Kind::leftOut) continue;
      const bool linear = fates_[c].to == "velocity_m_per_s";
      if (is(c, "velocity_rad_per_s")) {
        if (const auto filled = fillNeed(c, true); !filled) return filled.error();
        apply(c);
      } else if (is(c, "velocity_m_per_s")) {
        apply(c);
      }
      const auto& speed = values(c);
      Channel made{linear ? "position_m" : "angle_rad", {0.0}};
      for (size_t k = 1; k < speed.size(); ++k) {
        const double way = 0.5 * (speed[k] + speed[k - 1]) * (time_.time_s[k] - time_.time_s[k - 1]);
        made.values.push_back(made.values.back() + (std::isfinite(way) ? way : 0.0));
      }
      made_.push_back(std::move(made));
      remarks_.push_back(made_.back().name + " is " + map_.integrate + ", integrated by trapezoids from 0");
    }
    return {};
  }

  void differentiate() {
    if (map_.differentiate.empty()) return;
    for (size_t c = 0; c < fates_.size(); ++c) {
      if (fates_[c].from != map_.differentiate || fates_[c].kind == ColumnFate::Kind::leftOut) continue;
      const auto& angle = values(c);
      Channel made{fates_[c].to == "position_m" ? "velocity_m_per_s" : "velocity_rad_per_s", {}};
      const size_t last = angle.size() - 1;
      for (size_t k = 0; k <= last; ++k) {
        const size_t a = k == 0 ? 0 : k - 1, b = std::min(k + 1, last);
        made.values.push_back(a == b ? 0.0 : (angle[b] - angle[a]) / (time_.time_s[b] - time_.time_s[a]));
      }
      if (const auto measured = columnOf(made.name)) keep(*measured, "the map's derivative takes its place");
      made_.push_back(std::move(made));
      remarks_.push_back(made_.back().name + " is " + map_.differentiate + ", differentiated over two rows");
    }
  }

  Result<void> turnSigns() {
    for (const auto& [name, sign] : map_.sign) {
      bool found = false;
      for (size_t c = 0; c < fates_.size(); ++c) {
        if ((fates_[c].from != name && fates_[c].to != name) || fates_[c].kind == ColumnFate::Kind::leftOut) continue;
        found = true;
        if (is(c, "time_s") || sign > 0.0) continue;
        convert(values(c), -1.0, 0.0);
        fates_[c].scale = -fates_[c].scale;
        fates_[c].offset = -fates_[c].offset;
      }
      for (Channel& channel : made_) {
        if (channel.name != name) continue;
        found = true;
        if (sign < 0.0) convert(channel.values, -1.0, 0.0);
      }
      if (!found)
        return Error{path_, "has no column \"" + name + "\", whose sign the map turns; there are: " + names()};
    }
    return {};
  }

  Result<void> needMotion() {
    const auto made = [this](const char* name) {
      return std::any_of(made_.begin(), made_.end(), [name](const Channel& one) { return one.name == name; });
    };
    for (const char* name : {"angle_rad", "position_m", "velocity_rad_per_s", "velocity_m_per_s"}) {
      if (columnOf(name) || made(name)) return {};
    }
    return Error{path_,
                 "no column could be taken for the angle, position or speed; there are: " + names() +
                     "; say which with --map {\"columns\": {\"NAME\": {\"to\": \"angle_rad\", \"unit\": \"deg\"}}}"};
  }

  /// Says what can't be: an angle that leaps, a speed that contradicts it.
  void checkMotion() {
    const auto angle = columnOf("angle_rad"), speed = columnOf("velocity_rad_per_s");
    if (angle) {
      const Leaps leaps = leapsIn(time_.time_s, values(*angle), time_.pauses);
      if (leaps.count > 0)
        remarks_.push_back("implausible: the angle leaps in " + std::to_string(leaps.count) +
                           (leaps.count == 1 ? " place" : " places") + ", first by " + shortText(leaps.size) +
                           " rad at row " + std::to_string(time_.rows[leaps.first] + 1));
    }
    if (!angle || !speed) return;
    const auto motion = compareMotion(time_.time_s, values(*angle), values(*speed), time_.pauses);
    if (!motion) return;
    const double factor = motion->factor;
    const bool unsignedSpeed =
        std::all_of(values(*speed).begin(), values(*speed).end(), [](double v) { return !(v < 0.0); });
    if (unsignedSpeed && std::abs(motion->correlation) < 0.9) {
      remarks_.emplace_back(
          "implausible: the speed is never negative although the angle falls, too; it seems to have lost its sign");
    } else if (std::abs(motion->correlation) < 0.6) {
      remarks_.emplace_back("implausible: the speed and the angle's changes have little in common");
    } else if (factor < 0.0) {
      remarks_.emplace_back("implausible: the speed has the other sign than the angle's changes");
    } else if (std::abs(std::log(factor)) > std::log(1.2)) {
      remarks_.push_back("implausible: the angle changes " + shortText(factor) +
                         " times as much as the speed says; a unit of theirs or the time's is wrong");
    }
  }

  Result<Imported> seal() {
    std::vector<Channel> channels{{"time_s", std::move(time_.time_s)}};
    std::set<std::string> taken{"time_s"};
    for (size_t c = 0; c < fates_.size(); ++c) {
      if (fates_[c].kind == ColumnFate::Kind::leftOut || is(c, "time_s")) continue;
      ColumnFate& fate = fates_[c];
      if (!taken.insert(fate.to).second) {
        fate.kind = ColumnFate::Kind::leftOut;
        fate.why = "stands there twice";
        continue;
      }
      channels.push_back({fate.to, std::move(values(c))});
    }
    for (Channel& channel : made_) {
      if (taken.insert(channel.name).second) channels.push_back(std::move(channel));
    }
    table_.notes.emplace_back("imported from", std::filesystem::path(path_).filename().string());
    auto recording = Recording::seal(path_, std::move(channels), std::move(table_.notes));
    if (!recording) return recording.error();
    for (std::string& one : contradictionsIn(*recording)) remarks_.push_back(std::move(one));
    return Imported{std::move(*recording), std::move(fates_), std::move(remarks_)};
  }

  RawTable table_;
  const ImportMap& map_;
  std::string path_;
  std::vector<size_t> newFile_;
  std::vector<Choice> choices_;
  std::vector<ColumnFate> fates_;
  std::vector<std::string> remarks_;
  std::set<size_t> settled_;
  std::vector<Channel> made_;
  SettledTime time_;
};

}  // namespace

std::string ColumnFate::inWords() const {
  if (kind == Kind::leftOut) return from + ": left out, " + why;
  if (kind == Kind::kept) return from + ": kept unused, " + why;
  std::string text = from == to ? from : from + " → " + to;
  if (from != to || scale != 1.0) {
    text += unit.empty() ? ", taken as SI, a guess: the name tells no unit" : ", from " + unit;
    if (scale != 1.0) text += " (× " + shortText(scale) + ")";
    if (offset != 0.0) text += (offset > 0.0 ? ", + " : ", − ") + shortText(std::abs(offset));
    if (guessed && !unit.empty()) text += ", a guess: " + why;
  }
  return text;
}

Result<Imported> settleTable(RawTable table, const ImportMap& map, const std::string& path,
                             const std::vector<size_t>& newFile) {
  return Settling(std::move(table), map, path, newFile).run();
}

}  // namespace breakaway
