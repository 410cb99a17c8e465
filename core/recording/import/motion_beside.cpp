#include "recording/import/motion_beside.h"

#include <cmath>
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

bool namesMotor(const RawTable& table, const Choice& choice, size_t c) {
  const Words words = wordsOf(table.columns[c].channel.name, true);
  return firstIn(words, jointWords) != nullptr || isIn(words, "wheel") || isIn(words, "rotor") ||
         isIn(words, "shaft") || isIn(words, "rpm") || choice.name.unit == "rpm";
}

}  // namespace

bool setStrangersAside(const RawTable& table, size_t angle, size_t speed, std::vector<Choice>& choices) {
  constexpr double little = 0.6, most = 0.9;
  const auto isFixed = [&choices](size_t c) { return choices[c].byMap || choices[c].byTool; };
  if (isFixed(angle) || isFixed(speed)) return false;
  std::optional<double> taken;
  const auto differ = [&] {
    if (!taken) taken = commonOf(table, angle, speed);
    return *taken < little;
  };
  const auto nameOf = [&table](size_t c) { return table.columns[c].channel.name; };
  for (size_t c = 0; c < choices.size(); ++c) {
    const std::string& to = choices[c].name.to;
    const bool otherAngle = c != angle && to == choices[angle].name.to,
               otherSpeed = c != speed && to == choices[speed].name.to;
    if ((!otherAngle && !otherSpeed) || isFixed(c) || !differ()) continue;
    if (otherAngle && commonOf(table, c, speed) > most) {
      setAside(choices[angle], message("moves otherwise than {}, with which {} agrees", nameOf(speed), nameOf(c)));
      return true;
    }
    if (!otherSpeed || commonOf(table, angle, c) <= most) continue;
    if (!namesMotor(table, choices[speed], speed) || namesMotor(table, choices[angle], angle)) {
      setAside(choices[speed], message("moves otherwise than {}, with which {} agrees", nameOf(angle), nameOf(c)));
      return true;
    }
    const Message why = message("moves otherwise than {}, which is the motor's", nameOf(speed));
    setAside(choices[angle], why);
    setAside(choices[c], why);
    return true;
  }
  constexpr double nextToNone = 0.3;
  const ColumnName& named = choices[angle].name;
  const bool another = named.qualified && named.unit.empty() && !choices[speed].name.unit.empty() &&
                       namesMotor(table, choices[speed], speed) && !namesMotor(table, choices[angle], angle);
  if (!another || !differ() || *taken > nextToNone) return false;
  setAside(choices[angle], message("moves otherwise than {}, which is the motor's", nameOf(speed)));
  return true;
}

}  // namespace breakaway
