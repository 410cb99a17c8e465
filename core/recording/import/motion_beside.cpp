#include "recording/import/motion_beside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "recording/import/columns_beside.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"
#include "recording/import/settle_motion.h"

namespace breakaway {

namespace {

/// How much the angle's changes and the speed have in common, whatever their units, with rows evenly apart; 0 when
/// nobody can tell.
double commonOf(const RawTable& table, size_t angle, size_t speed) {
  std::vector<double> turned = table.columns[angle].channel.values;
  std::vector<double> rows(turned.size());
  std::iota(rows.begin(), rows.end(), 0.0);
  if (const auto period = periodOf(turned, {}, std::nullopt)) unwind(turned, *period, {});
  const auto motion = compareMotion(rows, turned, table.columns[speed].channel.values, {});
  return motion ? std::abs(motion->correlation) : 0.0;
}

/// The same of how both vary about their means, in as many rows as tell it.
double columnsVaryAlike(const RawTable& table, size_t angle, size_t speed) {
  static constexpr size_t mostRows = 20000;
  const auto begin = [&table](size_t c) {
    const auto& values = table.columns[c].channel.values;
    const auto count = static_cast<std::ptrdiff_t>(std::min(mostRows, values.size()));
    return std::vector<double>(values.begin(), values.begin() + count);
  };
  std::vector<double> turned = begin(angle);
  if (const auto period = periodOf(turned, {}, std::nullopt)) unwind(turned, *period, {});
  return variesAlike(turned, begin(speed));
}

}  // namespace

Words wordsBesideQuantity(const RawTable& table, size_t c) {
  Words words = partsOfName(table.columns[c].channel.name, table.columns[c].unit).words;
  std::erase_if(words, [](const std::string& word) {
    const Word* quantity = quantityNamed(word);
    return quantity != nullptr && !quantity->weak;
  });
  return words;
}

namespace {

/// Numbers that change, of which the name says nothing that is known and the unit nothing else than `kind`.
bool isOpenFor(const RawTable& table, const Choice& choice, size_t c, UnitKind kind) {
  const RawColumn& column = table.columns[c];
  if (choice.name.understood() || choice.byMap || choice.byTool || column.fault || column.clock) return false;
  const bool nameless = column.channel.name.starts_with("column_");
  if (nameless || !(rangeOf(column.channel.values) > 0.0) || isMultiplied(column.channel.name)) return false;
  const NameParts parts = partsOfName(column.channel.name, column.unit);
  const bool other = otherThingIn(parts.words) != nullptr || firstIn(parts.words, referenceWords) != nullptr ||
                     firstIn(parts.words, headings) != nullptr;
  const bool fits = parts.unit == nullptr ? !parts.unknownUnit : parts.unit->kind == kind;
  const bool quantity = std::any_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
    const Word* known = quantityNamed(word);
    return known != nullptr && !known->weak;
  });
  return fits && !other && !quantity;
}

}  // namespace

void takeAnglesByValues(const RawTable& table, std::vector<Choice>& choices) {
  constexpr double agrees = 0.95;
  const auto isOf = [&choices](size_t c, const char* to) { return choices[c].name.to == to; };
  size_t speed = choices.size();
  for (size_t c = choices.size(); c-- > 0;) {
    if (isOf(c, "angle_rad") || isOf(c, "position_m")) return;
    if (isOf(c, "velocity_rad_per_s")) speed = c;
  }
  if (speed == choices.size()) return;
  const auto open = [&](size_t c) {
    return !choices[c].name.understood() && !choices[c].byMap && !choices[c].byTool && !table.columns[c].fault &&
           choices[c].name.unit.empty() &&
           partsOfName(table.columns[c].channel.name, table.columns[c].unit).unit == nullptr;
  };
  for (size_t c = 0; c < choices.size(); ++c) {  // "cumulative feedback [pulse]"
    if (choices[c].name.understood() || choices[c].byMap || choices[c].byTool || table.columns[c].fault) continue;
    if (isMultiplied(table.columns[c].channel.name)) continue;
    const NameParts parts = partsOfName(table.columns[c].channel.name, table.columns[c].unit);
    const bool turns = parts.unit != nullptr && parts.unit->kind == UnitKind::angle && !parts.words.empty();
    const bool other = otherThingIn(parts.words) != nullptr || firstIn(parts.words, referenceWords) != nullptr ||
                       firstIn(parts.words, headings) != nullptr;
    if (!turns || other || commonOf(table, c, speed) < agrees) continue;
    choices[c].name = understandName("angle", parts.unitText);
    choices[c].name.guess = message("moves as {} says", table.columns[speed].channel.name);
    return;
  }
  const auto take = [&](size_t c, ColumnName name) {
    choices[c].name = std::move(name);
    choices[c].name.guess = message("moves as {} says", table.columns[speed].channel.name);
  };
  for (size_t c = 0; c < choices.size(); ++c) {  // a name in another language
    const std::string& name = table.columns[c].channel.name;
    const bool foreign =
        std::any_of(name.begin(), name.end(), [](char one) { return static_cast<unsigned char>(one) >= 0x80U; });
    if (!foreign || !isOpenFor(table, choices[c], c, UnitKind::angle) || columnsVaryAlike(table, c, speed) < agrees)
      continue;
    return take(c, understandName("angle", partsOfName(name, table.columns[c].unit).unitText));
  }
  const Words called = wordsBesideQuantity(table, speed);
  if (called.empty()) return;  // any word would do
  const std::string group = partsOfName(table.columns[speed].channel.name, table.columns[speed].unit).group;
  for (size_t c = 0; c < choices.size(); ++c) {  // "gimbal_yaw" beside "gimbal_yaw_vel"
    const NameParts parts = partsOfName(table.columns[c].channel.name, table.columns[c].unit);
    const bool fits = parts.unit == nullptr ? !parts.unknownUnit : parts.unit->kind == UnitKind::angle;
    const bool free =
        !choices[c].name.understood() && !choices[c].byMap && !choices[c].byTool && !table.columns[c].fault;
    if (!free || !fits || parts.words != called || parts.group != group || commonOf(table, c, speed) < agrees) continue;
    ColumnName own = understandName("angle", parts.unitText);
    own.group = choices[speed].name.group;
    return take(c, std::move(own));
  }
  std::string unknown;
  for (size_t c = 0; c < choices.size() && unknown.empty(); ++c) {
    const Words words = wordsOf(table.columns[c].channel.name, true);
    if (!open(c) || words.size() != called.size() + 1 || otherThingIn(words) != nullptr) continue;
    for (const std::string& word : words) {
      Words rest = words;
      std::erase(rest, word);
      const bool place = rest == called && word.size() > 1 && quantityNamed(word) == nullptr &&
                         !isIn(decorations, word) && !isIn(referenceWords, word);
      if (place && commonOf(table, c, speed) > agrees) unknown = word;
    }
  }
  if (unknown.empty()) return;
  for (size_t c = 0; c < choices.size(); ++c) {
    std::string name;
    Words words = wordsOf(table.columns[c].channel.name, true);
    if (!open(c) || !isIn(words, unknown)) continue;
    for (const std::string& word : words) name += (name.empty() ? "" : "_") + (word == unknown ? "position" : word);
    const ColumnName own = understandName(name, table.columns[c].unit);
    if (!own.understood()) continue;
    take(c, own);
  }
}

void takeMotionByValues(const RawTable& table, std::vector<Choice>& choices) {
  constexpr double agrees = 0.98;
  constexpr size_t fewestRows = 50, mostColumns = 40;
  if (table.rows() < fewestRows || choices.size() > mostColumns) return;
  const bool known = std::any_of(choices.begin(), choices.end(), [](const Choice& one) {
    return one.name.to.starts_with("angle") || one.name.to.starts_with("position") ||
           one.name.to.starts_with("velocity");
  });
  if (known) return;
  const auto isDerivative = [&](size_t of, size_t c) {
    return of != c && isOpenFor(table, choices[of], of, UnitKind::angle) &&
           isOpenFor(table, choices[c], c, UnitKind::angularVelocity) && columnsVaryAlike(table, of, c) > agrees;
  };
  for (size_t angle = 0; angle < choices.size(); ++angle) {
    for (size_t speed = 0; speed < choices.size(); ++speed) {
      if (!isDerivative(angle, speed)) continue;
      bool first = true;
      for (size_t before = 0; before < choices.size() && first; ++before) first = !isDerivative(before, angle);
      if (!first) break;
      const auto take = [&](size_t c, const char* as, size_t beside) {
        const NameParts parts = partsOfName(table.columns[c].channel.name, table.columns[c].unit);
        choices[c].name = understandName(as, parts.unitText);
        choices[c].name.guess =
            message("nothing but its values tells it, beside {}", table.columns[beside].channel.name);
      };
      take(angle, "angle", speed);
      take(speed, "speed", angle);
      return;
    }
  }
}

void takeJointsAlone(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto joints = std::to_array<std::string_view>(
      {"joint", "joints", "wrist", "forearm", "elbow", "shoulder", "hip", "knee", "ankle", "waist"});
  static constexpr auto sides = std::to_array<std::string_view>({"l", "r", "left", "right"});
  static constexpr auto learners = std::to_array<std::string_view>({"observation", "action"});
  constexpr double farthest_rad = 4.0 * std::numbers::pi;  // no joint turns further
  for (const Choice& one : choices) {
    const std::string& to = one.name.to;
    if (to.starts_with("angle") || to.starts_with("position") || to.starts_with("velocity")) return;
  }
  for (size_t c = 0; c < choices.size(); ++c) {
    const RawColumn& column = table.columns[c];
    const NameParts parts = partsOfName(column.channel.name, column.unit);
    const std::string* joint = firstIn(parts.words, joints);
    const bool alone = std::all_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
      return isIn(joints, word) || isIn(decorations, word) || isIn(referenceWords, word) || isIn(learners, word) ||
             isIn(headings, word) || isIn(sides, word);  // "LHipPitch"
    });
    const std::string* side = firstIn(parts.words, sides);
    const std::string* heading = firstIn(parts.words, headings);
    const bool angle = parts.unit == nullptr ? !parts.unknownUnit : parts.unit->kind == UnitKind::angle;
    const bool open = !choices[c].name.understood() && !choices[c].byMap && !choices[c].byTool && !column.fault;
    if (joint == nullptr || !alone || !angle || !open || !(rangeOf(column.channel.values) > 0.0)) continue;
    const bool reference = firstIn(parts.words, referenceWords) != nullptr || isIn(parts.words, "action");
    const bool degrees = parts.unit == nullptr && rangeOf(column.channel.values) > farthest_rad;
    choices[c].name = understandName(reference ? "angle_cmd" : "angle", degrees ? "deg" : parts.unitText);
    choices[c].name.group =
        (side == nullptr ? "" : *side) + *joint + parts.group + (heading == nullptr ? "" : *heading);
    choices[c].name.guess = message("it is called by a joint alone, and nothing else tells a motion");
  }
}

void takeOnlyAngle(const RawTable& table, std::vector<Choice>& choices) {
  static constexpr auto directions = std::to_array<std::string_view>(
      {"lat",    "latitude", "lon",     "lng",   "long",  "longitude", "heading",  "azimuth", "az",  "elevation", "el",
       "course", "bearing",  "compass", "phase", "slope", "hue",       "steering", "steer",   "sun", "shift"});
  for (const Choice& one : choices) {
    const std::string& to = one.name.to;
    if (to.starts_with("angle") || to.starts_with("position") || to.starts_with("velocity")) return;
  }
  size_t only = choices.size(), count = 0;
  for (size_t c = 0; c < choices.size(); ++c) {
    const RawColumn& column = table.columns[c];
    const NameParts parts = partsOfName(column.channel.name, column.unit);
    const bool angle =
        parts.unit != nullptr && parts.unit->kind == UnitKind::angle && parts.unit->needs == UnitNeeds::nothing;
    if (!angle || !(rangeOf(column.channel.values) > 0.0)) continue;
    ++count;
    const bool open = choices[c].name.saysNothing && !choices[c].byMap && !choices[c].byTool && !column.fault;
    if (open && firstIn(parts.words, directions) == nullptr && firstIn(parts.words, referenceWords) == nullptr)
      only = c;
  }
  if (count != 1 || only == choices.size()) return;
  const NameParts parts = partsOfName(table.columns[only].channel.name, table.columns[only].unit);
  choices[only].name = understandName("angle", parts.unitText);
  choices[only].name.group = parts.group;
  choices[only].name.byUnit = true;
}

bool setStrangePlaceAside(const RawTable& table, size_t position, size_t speed, std::vector<Choice>& choices) {
  constexpr double little = 0.6;
  const ColumnName& turns = choices[speed].name;
  if (choices[position].byMap || choices[position].byTool || choices[speed].byMap || turns.unit.empty()) return false;
  if (commonOf(table, position, speed) > little) return false;  // a screw, a belt
  setAside(choices[position],
           message("moves otherwise than {}, which is the motor's", table.columns[speed].channel.name));
  return true;
}

}  // namespace breakaway
