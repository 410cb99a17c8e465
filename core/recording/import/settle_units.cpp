// Units that neither a name nor the motion tells: by what stands beside a column, what it follows, how far it goes.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "base/numbers.h"
#include "recording/import/name_parts.h"
#include "recording/import/number_text.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settling.h"

namespace breakaway {

namespace {

constexpr double fewestCounts = 8.0;  // a turn

/// "deg" of an angle in degrees and of a rate in degrees per second; empty for rpm, counts and what has another kind.
std::string familyOf(const Unit* unit) {
  if (unit == nullptr || unit->needs != UnitNeeds::nothing) return {};
  if (unit->kind != UnitKind::angle && unit->kind != UnitKind::angularVelocity) return {};
  for (const auto& [name, scale] : {std::pair{"rad", 1.0}, {"deg", turn_rad / 360.0}}) {
    if (std::abs(unit->scale / scale - 1.0) < 1e-6) return name;
  }
  return {};
}

/// What a joint or a hobby servo is called: it doesn't turn further than twice around.
bool isBounded(const Words& words) {
  static constexpr auto bounded =
      std::to_array<std::string_view>({"joint", "servo", "wrist", "forearm", "elbow", "shoulder", "gripper", "hip",
                                       "knee", "ankle", "waist", "head", "neck", "tilt", "jaw", "finger", "thumb"});
  static constexpr auto endless = std::to_array<std::string_view>({"motor", "mot", "rotor", "wheel"});
  return firstIn(words, bounded) != nullptr && firstIn(words, endless) == nullptr;
}

/// ROS' messages of joints: their unit is the radian by convention.
bool tellsRos(const RawTable& table) {
  return std::any_of(table.columns.begin(), table.columns.end(), [](const RawColumn& column) {
    return isIn(wordsOf(column.channel.name, true), "effort") ||
           lowered(column.channel.name).find("joint_state") != std::string::npos ||
           column.channel.name.find("header.stamp") != std::string::npos;
  });
}

/// "MC_Axis000.Act.Pos", "FPOS(0)": an axis of a PLC or a motion controller is in the units that its user chose.
bool isPlcAxis(const Words& words) {
  static constexpr auto controllers = std::to_array<std::string_view>({"fpos", "rpos"});
  if (firstIn(words, controllers) != nullptr) return true;
  const bool axis = std::any_of(words.begin(), words.end(), [](const auto& word) { return word.starts_with("axis"); });
  return axis && (isIn(words, "act") || isIn(words, "nctoplc") || isIn(words, "mc"));
}

}  // namespace

bool Settling::mayBeDegrees(size_t c) const {
  constexpr double fewTurns_rad = 2.0 * turn_rad;
  return !choices_[c].byMap && rangeOf(table_.columns[c].channel.values) > fewTurns_rad &&
         (!columnOf("velocity_rad_per_s") || isPlcAxis(wordsOf(fates_[c].from, true)));
}

bool Settling::isOfArm(size_t c) const {
  constexpr size_t fewestJoints = 5;
  const std::string number = partsOfName(fates_[c].from, table_.columns[c].unit).group;
  const Words called = partsOfName(fates_[c].from, table_.columns[c].unit).words;
  size_t joints = 0;
  for (size_t k = 0; k < fates_.size(); ++k) {
    const NameParts parts = partsOfName(fates_[k].from, table_.columns[k].unit);
    joints += isNumber(parts.group) && parts.words == called ? 1 : 0;
  }
  return isNumber(number) && joints >= fewestJoints;
}

std::string Settling::familyBeside(size_t c) const {
  const bool rate = isSpeed(fates_[c].to);
  std::string family;
  for (size_t k = 0; k < fates_.size(); ++k) {
    if (k == c || table_.columns[k].fault) continue;
    const NameParts parts = partsOfName(fates_[k].from, table_.columns[k].unit);
    const bool another = otherThingIn(parts.words) != nullptr ||
                         (firstIn(parts.words, headings) != nullptr && firstIn(parts.words, jointWords) == nullptr);
    const bool inSpace = parts.words.size() > 1 && parts.words.back().size() == 1 &&
                         std::string_view("xyz").find(parts.words.back()) != std::string_view::npos;
    const std::string own = another || inSpace || parts.factor != 1.0 ? std::string() : familyOf(parts.unit);
    if (own.empty() || (rate && parts.unit->kind == UnitKind::angle)) continue;
    if (!family.empty() && family != own) return {};
    family = own;
  }
  return family;
}

bool Settling::followsRoundNumbers(size_t c, const std::string& reference, double step, double least) {
  const auto shall = std::find_if(fates_.begin(), fates_.end(), [&](const ColumnFate& one) {
    return one.kind == ColumnFate::Kind::used && one.to == reference && one.unit.empty();
  });
  if (shall == fates_.end()) return false;
  const auto& wanted = values(static_cast<size_t>(shall - fates_.begin()));
  constexpr double near = 2.0;
  const double far = largest(wanted), goes = largest(values(c));
  const bool round = std::all_of(wanted.begin(), wanted.end(), [step](double v) {
    return !std::isfinite(v) || std::abs(v / step - std::round(v / step)) < 1e-9;
  });
  return round && far >= least && goes > far / near && goes < far * near;
}

bool Settling::unitAsRos(size_t c) {
  ColumnFate& fate = fates_[c];
  if (choices_[c].byMap || choices_[c].byTool || !tellsRos(table_)) return false;
  fate.unit = isAngle(fate.to) ? "rad" : "rad/s";
  fate.scale = 1.0;
  fate.why = message("as ROS counts");
  fate.doubt = fate.why;
  fate.guessed = true;
  return true;
}

bool Settling::unitBeside(size_t c) {
  ColumnFate& fate = fates_[c];
  const bool angle = isAngle(fate.to);
  if (choices_[c].byMap || (angle && areWhole(values(c)))) return false;
  const auto take = [&fate](const char* unit, Message why) {
    fate.unit = unit;
    fate.scale = unitNamed(unit)->scale;
    fate.why = std::move(why);
    fate.doubt = fate.why;
    fate.guessed = true;
    return true;
  };
  if (unitAsRos(c)) return true;
  const std::string reference = angle ? "angle_reference_rad" : "velocity_reference_rad_per_s";
  const auto shall = columnOf(reference);
  constexpr double near = 2.0;
  if (shall && !fates_[*shall].unit.empty() && choices_[*shall].name.needs == UnitNeeds::nothing) {
    const double far = largest(values(*shall)), goes = largest(values(c));
    const Unit* unit = unitNamed(fates_[*shall].unit);
    if (unit != nullptr && unit->scale == fates_[*shall].scale && goes > far / near && goes < far * near)
      return take(fates_[*shall].unit.c_str(),
                  message("{} follows {}, which tells it", fate.from, fates_[*shall].from));
  }
  constexpr double roundDegrees = 5.0, fewDegrees = 20.0, roundTurns_rpm = 50.0, fewTurns_rpm = 200.0;
  if (angle && followsRoundNumbers(c, reference, roundDegrees, fewDegrees))
    return take("deg", message("what it follows stays at round numbers of degrees"));
  if (!angle && followsRoundNumbers(c, reference, roundTurns_rpm, fewTurns_rpm))
    return take("rpm", message("what it follows stays at round numbers of turns per minute"));
  const std::string family = familyBeside(c);
  if (!family.empty()) {
    const bool degrees = family == "deg";
    return take(angle ? (degrees ? "deg" : "rad") : (degrees ? "deg/s" : "rad/s"),
                message("as other angles and rates beside it"));
  }
  constexpr double farthest_rad = 4.0 * std::numbers::pi, farthest_deg = 725.0;
  const double range = rangeOf(values(c));
  if (angle && range > farthest_rad && range < farthest_deg && (isOfArm(c) || isBounded(wordsOf(fate.from, true))))
    return take("deg", message("no joint turns so many radians"));
  return false;
}

Result<void> Settling::needLinearUnit(size_t c) const {
  constexpr double longest_m = 10.0, fastest_m_per_s = 50.0;
  const ColumnFate& fate = fates_[c];
  const bool position = fate.to == "position_m";
  if ((!position && fate.to != "velocity_m_per_s") || !fate.unit.empty() || choices_[c].byMap) return {};
  const auto& values = table_.columns[c].channel.values;
  const double most = position ? rangeOf(values) : largest(values);
  if (most <= (position ? longest_m : fastest_m_per_s)) return {};
  return Error{path_ + ", column " + fate.from,
               message("goes {} far and tells no unit; say what it is with --map {}", shortText(most),
                       "{\"columns\": {\"" + fate.from + "\": {\"to\": \"" + fate.to + "\", \"unit\": \"" +
                           (position ? "mm" : "mm/s") + "\"}}}")};
}

bool Settling::countsBySpeed(size_t c) {
  const auto v = columnOf("velocity_rad_per_s");
  if (!v || fates_[*v].unit.empty() || choices_[*v].name.needs != UnitNeeds::nothing) return false;
  constexpr double alike = 0.95, oneTurn = 1.05, severalTurns = 1.5;
  std::vector<double> angle = values(c);
  auto motion = compareMotion(time_.time_s, angle, values(*v), time_.pauses);
  std::optional<double> period;  // after which they start anew
  if (!motion || motion->correlation < alike) {
    period = periodOf(angle, time_.pauses);
    if (!period) return false;
    unwind(angle, *period, time_.pauses);
    motion = compareMotion(time_.time_s, angle, values(*v), time_.pauses);
  }
  if (!motion || motion->correlation < alike) return false;
  const double measured = motion->factor / fates_[*v].scale * turn_rad;
  if (measured < fewestCounts || rangeOf(angle) < measured) return false;
  const double turns = period.value_or(measured) / measured;
  const bool whole = std::abs(std::log(turns)) < std::log(oneTurn);
  if (!whole && turns < severalTurns) return false;
  counts_per_rev_ = period && whole ? *period : usualCounts(measured);
  sayCounts(c, *v, measured);
  return true;
}

bool Settling::countsByAngle(size_t c, size_t angle) {
  if (fates_[angle].unit.empty() || choices_[angle].name.needs != UnitNeeds::nothing) return false;
  const auto motion = motionOf(angle, c);
  constexpr double alike = 0.95;
  if (!motion || motion->correlation < alike) return false;
  const double measured = turn_rad * gear("angle_rad") / motion->factor;
  if (measured < fewestCounts) return false;
  counts_per_rev_ = usualCounts(measured);
  sayCounts(c, angle, measured);
  return true;
}

void Settling::sayCounts(size_t c, size_t beside, double measured) {
  remarks_.push_back(message(
      "{} is in counts, of which {} were taken for one turn, a guess: beside {} it makes {} a turn; say it with --map "
      "{}",
      fates_[c].from, shortText(*counts_per_rev_), fates_[beside].from, shortText(std::round(measured * 10.0) / 10.0),
      "{\"counts_per_rev\": " + shortText(*counts_per_rev_) + "}"));
}

}  // namespace breakaway
