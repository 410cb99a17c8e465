// A log's motion: angle, speed, what follows from one for the other, and whether it can be.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/numbers.h"
#include "recording/import/name_parts.h"
#include "recording/import/number_text.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settling.h"
#include "recording/import/told_unit.h"
#include "recording/import/vehicles_beside.h"

namespace breakaway {

Result<void> Settling::takeAngle() {
  const auto c = columnOf("angle_rad");
  if (!c || settled_.contains(*c)) return {};
  ColumnFate& fate = fates_[*c];
  auto& angle = values(*c);
  const auto speed = columnOf("velocity_rad_per_s");
  const bool counts = choices_[*c].name.needs == UnitNeeds::countsPerRev && !choices_[*c].byMap;
  if (!choices_[*c].byMap && rangeOf(angle) == 0.0 && speed && rangeOf(values(*speed)) > 0.0) {
    keep(*c, message("never changes although the speed does"));
    return {};
  }
  if (!choices_[*c].byMap && !choices_[*c].byTool && speed && isWayPerRow(*c, *speed)) return {};
  if (counts && !map_.counts_per_rev) countsBySpeed(*c);
  // An electrical angle tells nothing that a speed beside it needs.
  const bool electrical = choices_[*c].name.needs == UnitNeeds::polePairs && !choices_[*c].byMap;
  const bool spare = electrical && speed && choices_[*speed].name.needs == UnitNeeds::nothing;
  const auto filled = fillNeed(*c, !spare);
  if (!filled) return filled.error();
  if (!*filled) return {};
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
  if (whole && speed && !electrical && !choices_[*c].byMap && !choices_[*c].byTool && isElectrical(*c, *period, *speed))
    return {};
  if (period && (whole || overflow)) {
    unwindBy(angle, *period, whole);
  } else if (fate.scale != 0.0) {
    sayIfAmbiguous(angle, turn_rad / (fate.scale * perTurn));
  }
  apply(*c);
  return {};
}

bool Settling::isWayPerRow(size_t c, size_t speed) {
  constexpr double alike = 0.95, little = 0.6;
  const auto motion = compareMotion(time_.time_s, values(c), values(speed), time_.pauses);
  if (!motion || std::abs(motion->correlation) > little || !goesBothWays(values(speed))) return false;
  if (std::abs(likenessOf(values(c), values(speed)).correlation) < alike) return false;
  keep(c, message("goes as {} itself does: it is the way from row to row", fates_[speed].from));
  return true;
}

bool Settling::isElectrical(size_t c, double period, size_t speed) {
  constexpr double mostPolePairs = 40.0, within = 0.03, alike = 0.95, little = 0.6, halfTurn = 0.4;
  std::vector<double> angle = values(c);
  const Unwound unwound = unwind(angle, period, time_.pauses);
  convert(angle, turn_rad / period, 0.0);
  const auto motion = compareMotion(time_.time_s, angle, values(speed), time_.pauses);
  const std::string& beside = fates_[speed].from;
  if (!motion) return false;
  if (unwound.largestStep > halfTurn && std::abs(motion->correlation) < little) {
    keep(c, message("starts anew too often for its rows to tell the way, and doesn't go with {}", beside));
    return true;
  }
  if (fates_[speed].unit.empty() || choices_[speed].name.needs != UnitNeeds::nothing) return false;
  const double times = std::abs(motion->factor / (fates_[speed].scale * gear(fates_[speed].to)));
  const double pairs = std::round(times);
  if (std::abs(motion->correlation) < alike || pairs < 2.0 || pairs > mostPolePairs ||
      std::abs(times / pairs - 1.0) > within)
    return false;
  const std::string count = std::to_string(static_cast<int>(pairs));
  fates_[speed].guessed = true;
  fates_[speed].why = message("{} turns {} times as fast, in electrical turns or before a gear", fates_[c].from, count);
  fates_[speed].doubt = fates_[speed].why;
  keep(c, message("turns {} times as fast as {}, as in electrical turns", count, beside));
  return true;
}

void Settling::sayIfAmbiguous(const std::vector<double>& angle, double turn) {
  const double range = rangeOf(angle);
  if (!(range > 0.75 * turn) || range > 1.001 * turn) return;
  size_t places = 0;
  double most = 0.0;
  for (const double change : changesOf(angle)) {
    if (!(std::abs(change) > 0.4 * turn)) continue;
    ++places;
    most = std::max(most, std::abs(change) / turn);
  }
  if (places < 2) return;
  remarks_.push_back(
      message("implausible: the angle stays within one turn and moves up to {} turns from row to row, in {} places; if "
              "it starts anew with each turn, nobody can tell which way it went",
              shortText(most), places));
}

void Settling::unwindBy(std::vector<double>& angle, double period, bool whole) {
  const Unwound unwound = unwind(angle, period, time_.pauses);
  remarks_.push_back(
      whole ? message("the angle starts anew with each turn, in {}; it goes on counting now", placesIn(unwound.places))
            : message("the angle overflows its register, in {}; it goes on counting now", placesIn(unwound.places)));
  if (!time_.pauses.empty())
    remarks_.push_back(message("turns made during a pause are unknown: over it the angle may be wrong by whole turns"));
  if (unwound.largestStep > 0.4)
    remarks_.push_back(message(
        "it moves up to {} turns from row to row; from half a turn on nobody can tell which way, so check the result",
        shortText(unwound.largestStep)));
}

Result<void> Settling::nameUnit(size_t c, const std::optional<double>& period) {
  ColumnFate& fate = fates_[c];
  const auto& angle = values(c);
  const auto set = [&fate](double scale, const char* unit, Message why) {
    fate.scale = scale;
    fate.unit = unit;
    fate.why = std::move(why);
    fate.guessed = true;
  };
  const Words named = wordsOf(fate.from, true);
  const bool encoder =
      std::any_of(named.begin(), named.end(), [](const std::string& word) { return word.starts_with("enc"); });
  if (map_.counts_per_rev && (areWhole(angle) || encoder)) {
    set(turn_rad / *map_.counts_per_rev, "counts",
        areWhole(angle) ? message("whole numbers, with the map's counts per turn")
                        : message("an encoder's, with the map's counts per turn"));
    return {};
  }
  if (const auto told = toldAngleUnit(table_)) {
    set(unitNamed(*told)->scale, told->c_str(), message("a line above the table says so"));
    fate.guessed = false;
    return {};
  }
  if (period && *period == 360.0)
    return set(turn_rad / 360.0, "deg", message("it starts anew after 360")), Result<void>{};
  if (period && *period == 1.0) return set(turn_rad, "turns", message("it starts anew after 1")), Result<void>{};
  if (period && *period == turn_rad) return set(1.0, "rad", message("it starts anew after 2 π")), Result<void>{};
  if (isCountedAsSpeed(c)) {
    choices_[c].name.needs = UnitNeeds::countsPerRev;
    set(turn_rad, "counts", message("so it agrees with the speed, which is in counts"));
    const auto filled = fillNeed(c, true);
    return filled ? Result<void>{} : filled.error();
  }
  if (unitsByEachOther(c)) return {};
  if (const auto scale = scaleBySpeed(c)) {
    set(*scale, *scale == 1.0 ? "rad" : *scale == turn_rad ? "turns" : "deg", message("so it agrees with the speed"));
    return {};
  }
  constexpr double manyTurns = 30.0;
  if (areWhole(angle) && rangeOf(angle) >= manyTurns) {
    if (countsBySpeed(c)) {
      choices_[c].name.needs = UnitNeeds::countsPerRev;
      set(turn_rad / *counts_per_rev_, "counts",
          message("whole numbers, of which the speed tells how many are one turn"));
      return {};
    }
    const std::string told = "{\"counts_per_rev\": " + (period ? shortText(*period) : "4096") + "}";
    return Error{
        path_ + ", column " + fate.from,
        period ? message("holds whole numbers and no unit; say how many are one turn, perhaps {}, after which it "
                         "starts anew, with --map {}, or name its unit",
                         shortText(*period), told)
               : message("holds whole numbers and no unit; say how many are one turn, with --map {}, or name its unit",
                         told)};
  }
  if (unitBeside(c)) return {};
  if (mayBeDegrees(c))
    return Error{path_ + ", column " + fate.from,
                 message("nothing tells whether it is in degrees, radians or turns; say it with --map {}",
                         "{\"columns\": {\"" + fate.from + "\": {\"to\": \"angle_rad\", \"unit\": \"deg\"}}}")};
  fate.why = message("by its name, which tells no unit");
  constexpr double fewTurns_rad = 2.0 * turn_rad;
  if (rangeOf(angle) > fewTurns_rad && fate.doubt.empty())
    fate.doubt = message("it goes further than two turns of radians, and may be in degrees or turns as well");
  return {};
}

std::optional<double> Settling::scaleBySpeed(size_t c) {
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

std::optional<MotionFactor> Settling::motionOf(size_t angle, size_t speed) {
  return compareMotion(time_.time_s, values(angle), values(speed), time_.pauses);
}

bool Settling::isCountedAsSpeed(size_t c) {
  const auto v = columnOf("velocity_rad_per_s");
  if (!v || choices_[*v].name.needs != UnitNeeds::countsPerRev) return false;
  const auto motion = motionOf(c, *v);
  return motion && motion->correlation > 0.9 && std::abs(std::log(motion->factor)) < std::log(1.15);
}

bool Settling::unitsByEachOther(size_t c) {
  const auto v = columnOf("velocity_rad_per_s");
  if (!v || !fates_[*v].unit.empty() || choices_[*v].name.needs != UnitNeeds::nothing) return false;
  const auto motion = motionOf(c, *v);
  if (!motion || motion->correlation < 0.95) return false;
  const auto pair = unitsByFactor(motion->factor);
  if (!pair) return false;
  const auto set = [this](size_t column, const char* unit, double scale, Message why) {
    fates_[column].unit = unit;
    fates_[column].scale = scale;
    fates_[column].why = std::move(why);
    fates_[column].guessed = true;
  };
  const auto only = [this](size_t column, const char* unit) {
    return message("only so it agrees with {} in {}", fates_[column].from, unit);
  };
  set(c, pair->angle, pair->angle_rad, only(*v, pair->speed));
  set(*v, pair->speed, pair->speed_rad_per_s, only(c, pair->angle));
  return true;
}

Result<void> Settling::takeSpeed() {
  const auto c = columnOf("velocity_rad_per_s");
  if (!c || settled_.contains(*c)) return {};
  const auto angle = columnOf("angle_rad");
  const bool alone = !angle && !columnOf("position_m");
  const bool counts = choices_[*c].name.needs == UnitNeeds::countsPerRev && !choices_[*c].byMap;
  if (counts && angle && !map_.counts_per_rev && !counts_per_rev_) countsByAngle(*c, *angle);
  const auto filled = fillNeed(*c, alone);
  if (!filled) return filled.error();
  if (!*filled) return {};
  if (fates_[*c].unit.empty()) unitAsRos(*c);
  if (fates_[*c].unit.empty() && angle && !fates_[*angle].unit.empty()) speedByAngle(*c, *angle);
  if (fates_[*c].unit.empty() && is(*c, "velocity_rad_per_s")) {
    if (const auto known = nameSpeedUnit(*c, alone); !known) return known.error();
  }
  if (fates_[*c].unit == "rps" && is(*c, "velocity_rad_per_s")) turnsOrRadians(*c);
  if (is(*c, "velocity_rad_per_s")) apply(*c);
  return {};
}

void Settling::setGearedAside() {
  const auto angle = columnOf("angle_rad"), speed = columnOf("velocity_rad_per_s");
  if (!angle || !speed || map_.gear_ratio) return;
  const auto isTold = [this](size_t c) {
    return !choices_[c].byMap && !choices_[c].byTool && !fates_[c].unit.empty() && !fates_[c].guessed &&
           choices_[c].name.needs == UnitNeeds::nothing;
  };
  static constexpr auto motors = std::to_array<std::string_view>({"motor", "mot", "rotor"});
  const auto isMotors = [this](size_t c) { return firstIn(wordsOf(fates_[c].from, true), motors) != nullptr; };
  if (!isTold(*angle) || choices_[*speed].byMap || fates_[*speed].unit.empty()) return;
  const auto motion = motionOf(*angle, *speed);
  constexpr double alike = 0.95, agrees = 1.2, unitsDiffer = 1.03;
  if (!motion || motion->correlation < alike) return;
  if (isMotors(*angle) == isMotors(*speed)) return setElectricalSpeedAside(*angle, *speed, 1.0 / motion->factor);
  const double ratio = isMotors(*speed) ? 1.0 / motion->factor : motion->factor;
  if (ratio < agrees) return;
  for (const double units : {turn_rad, 360.0 / turn_rad, 360.0, 60.0, 60.0 / turn_rad, 6.0, 1000.0}) {
    if (std::abs(std::log(ratio / units)) < std::log(unitsDiffer)) return;
  }
  const size_t motorsOwn = isMotors(*speed) ? *speed : *angle, other = isMotors(*speed) ? *angle : *speed;
  const std::string times = shortText(std::round(10.0 * ratio) / 10.0);
  ColumnFate& own = fates_[motorsOwn];
  own.guessed = true;
  own.why = message("{} turns {} times as slowly, as behind a gear; without one, a unit or the pole pairs are wrong",
                    fates_[other].from, times);
  own.doubt = own.why;
  keep(other, message("turns {} times as slowly as {}, as behind a gear", times, own.from));
}

void Settling::setElectricalSpeedAside(size_t angle, size_t speed, double times) {
  constexpr double mostPolePairs = 40.0, within = 0.03;
  const double pairs = std::round(times);
  if (choices_[speed].byTool || pairs < 2.0 || pairs > mostPolePairs || pairs == 6.0 ||  // degrees and rpm
      std::abs(times / pairs - 1.0) > within)
    return;
  const std::string count = std::to_string(static_cast<int>(pairs));
  ColumnFate& own = fates_[angle];
  own.guessed = true;
  own.why = message("{} turns {} times as fast, in electrical turns or before a gear", fates_[speed].from, count);
  own.doubt = own.why;
  keep(speed, message("turns {} times as fast as {}, as in electrical turns", count, own.from));
}

void Settling::turnsOrRadians(size_t c) {
  const auto angle = columnOf("angle_rad");
  if (choices_[c].byMap || choices_[c].byTool) return;
  const auto motion = angle ? motionOf(*angle, c) : std::nullopt;
  const MotionFactor moves = motion.value_or(MotionFactor{0.0, 0.0});
  const auto agrees = [&moves](double scale) {
    return moves.correlation > 0.9 && std::abs(std::log(moves.factor / scale)) < std::log(1.15);
  };
  if (agrees(fates_[c].scale * gear(fates_[c].to))) return;
  fates_[c].guessed = true;
  fates_[c].why = message("\"rps\" are turns or radians per second; turns were taken");
  if (agrees(gear(fates_[c].to))) {
    fates_[c].scale = 1.0;
    fates_[c].unit = "rad/s";
    fates_[c].why = message("so it agrees with the angle");
  }
  fates_[c].doubt = fates_[c].why;
}

Result<void> Settling::nameSpeedUnit(size_t c, bool alone) {
  ColumnFate& fate = fates_[c];
  if (const Unit* usual = unitNamed(choices_[c].name.usual); usual != nullptr) {
    fate.scale = usual->scale;
    fate.unit = choices_[c].name.usual;
    fate.why = message("such a speed is counted so");
    fate.guessed = true;
    return {};
  }
  if (alone && unitBeside(c)) return {};
  if (alone && !choices_[c].byMap && tellsVehiclesWay(table_) &&
      firstIn(wordsOf(fate.from, true), jointWords) == nullptr)
    return Error{
        path_ + ", column " + fate.from,
        message("may be a vehicle's speed, and nothing tells its unit; say it with --map {}",
                "{\"columns\": {\"" + fate.from + "\": {\"to\": \"velocity_m_per_s\", \"scale\": 0.277778}}}")};
  constexpr double manyRadians_per_s = 30.0, fastRadians_per_s = 1000.0;
  const bool whole = areWhole(values(c));
  if (!alone || choices_[c].byMap || largest(values(c)) < (whole ? manyRadians_per_s : fastRadians_per_s)) return {};
  const std::string told =
      "{\"columns\": {\"" + fate.from + "\": {\"to\": \"velocity_rad_per_s\", \"unit\": \"rpm\"}}}";
  if (!whole)
    return Error{path_ + ", column " + fate.from,
                 message("goes up to {} and tells no unit; say it with --map {}", shortText(largest(values(c))), told)};
  return Error{path_ + ", column " + fate.from,
               message("holds whole numbers and no unit; say it with --map {}",
                       "{\"columns\": {\"" + fate.from + "\": {\"to\": \"velocity_rad_per_s\", \"unit\": \"rpm\"}}}")};
}

void Settling::speedByAngle(size_t c, size_t angle) {
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
    constexpr double within = 1.3;  // rows may be far apart
    if (std::abs(std::log(std::abs(motion->factor) / one.scale)) > std::log(within)) continue;
    fates_[c].scale = one.scale;
    fates_[c].unit = one.unit;
    fates_[c].why = message("so it agrees with the angle");
    fates_[c].guessed = true;
    return;
  }
  keep(c, message("its name tells no unit, and in none that is usual it agrees with the angle (factor {})",
                  shortText(motion->factor)));
}

Result<void> Settling::takeIntegral() {
  if (map_.integrate.empty()) return {};
  if (columnOf("angle_rad") || columnOf("position_m"))
    return Error{path_, message("has an angle already, so nothing is to be integrated")};
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
    remarks_.push_back(message("{} is {}, integrated by trapezoids from 0", made_.back().name, map_.integrate));
  }
  return {};
}

void Settling::differentiate() {
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
    if (const auto measured = columnOf(made.name)) keep(*measured, message("the map's derivative takes its place"));
    made_.push_back(std::move(made));
    remarks_.push_back(message("{} is {}, differentiated over two rows", made_.back().name, map_.differentiate));
  }
}

Result<void> Settling::needMotion() {
  const auto made = [this](const char* name) {
    return std::any_of(made_.begin(), made_.end(), [name](const Channel& one) { return one.name == name; });
  };
  for (const char* name : {"angle_rad", "position_m", "velocity_rad_per_s", "velocity_m_per_s"}) {
    if (columnOf(name) || made(name)) return {};
  }
  return Error{
      path_,
      message("no column could be taken for the angle, position or speed; there are: {}; say which with --map {}",
              names(), "{\"columns\": {\"NAME\": {\"to\": \"angle_rad\", \"unit\": \"deg\"}}}")};
}

void Settling::checkMotion() {
  const auto angle = columnOf("angle_rad"), speed = columnOf("velocity_rad_per_s");
  if (angle) {
    const Leaps leaps = leapsIn(time_.time_s, values(*angle), time_.pauses);
    if (leaps.count > 0)
      remarks_.push_back(message("implausible: the angle leaps in {}, first by {} rad at row {}", placesIn(leaps.count),
                                 shortText(leaps.size), time_.rows[leaps.first] + 1));
  }
  if (!angle || !speed) return;
  const auto motion = compareMotion(time_.time_s, values(*angle), values(*speed), time_.pauses);
  if (!motion) return;
  const double factor = motion->factor;
  const size_t said = remarks_.size();
  const bool unsignedSpeed =
      std::all_of(values(*speed).begin(), values(*speed).end(), [](double v) { return !(v < 0.0); });
  if (unsignedSpeed && std::abs(motion->correlation) < 0.9) {
    remarks_.push_back(message(
        "implausible: the speed is never negative although the angle falls, too; it seems to have lost its sign"));
  } else if (std::abs(motion->correlation) < 0.6) {
    remarks_.push_back(message("implausible: the speed and the angle's changes have little in common"));
  } else if (factor < 0.0) {
    remarks_.push_back(message("implausible: the speed has the other sign than the angle's changes"));
  } else if (std::abs(std::log(factor)) > std::log(1.2)) {
    remarks_.push_back(message(
        "implausible: the angle changes {} times as much as the speed says; a unit of theirs or the time's is wrong",
        shortText(factor)));
  }
  if (remarks_.size() == said || choices_[*speed].byMap || fates_[*speed].guessed) return;
  fates_[*speed].guessed = true;
  fates_[*speed].why = message("it and {} contradict each other", fates_[*angle].from);
  fates_[*speed].doubt = fates_[*speed].why;
}

}  // namespace breakaway
