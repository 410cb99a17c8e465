#include "recording/import/whose.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

constexpr auto motorSide = std::to_array<std::string_view>({"motor", "mot", "rotor", "motors"});
constexpr auto drivenSide =
    std::to_array<std::string_view>({"joint", "link", "output", "load", "driven", "joints", "links"});
/// Where one measures, not what.
constexpr auto benches = std::to_array<std::string_view>(
    {"dyno", "dynamometer", "bench", "rig", "test", "cell", "transducer", "meter", "drive", "inverter", "controller"});
/// Of the words for joints those that tell none.
constexpr auto anyMachine =
    std::to_array<std::string_view>({"joint", "joints", "motor", "mot", "servo", "actuator", "encoder", "stepper"});

bool hasOneOfItsOwn(const Words& one, const Words& other) {
  return std::any_of(one.begin(), one.end(), [&](const std::string& word) { return !isIn(other, word); });
}

bool haveWordInCommon(const Words& one, const Words& other) {
  return firstIn(one, other) != nullptr;
}

const std::string* jointIn(const Words& words) {
  const auto it = std::find_if(words.begin(), words.end(),
                               [](const auto& word) { return isIn(jointWords, word) && !isIn(anyMachine, word); });
  return it == words.end() ? nullptr : &*it;
}

}  // namespace

Whose whoseIs(const RawColumn& column, const Choice& choice) {
  const NameParts parts = partsOfName(column.channel.name, column.unit);
  Whose whose;
  whose.axis = choice.name.understood() ? choice.name.group : parts.group;
  const bool electric = std::any_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
    const Word* quantity = quantityNamed(word);
    return quantity != nullptr && (quantity->kind == UnitKind::current || quantity->kind == UnitKind::voltage);
  });
  for (const std::string& word : parts.words) {
    const bool motors = isIn(motorSide, word);
    const bool drivens = isIn(drivenSide, word) && !(electric && word == "output");  // an inverter's
    if (whose.side == Whose::Side::untold && motors) whose.side = Whose::Side::motor;
    if (whose.side == Whose::Side::untold && drivens) whose.side = Whose::Side::driven;
    const bool tells = !motors && !drivens && !isIn(referenceWords, word) && !isIn(decorations, word) &&
                       !isIn(measuredWords, word) && !isIn(estimateWords, word) && !isIn(electricalWords, word) &&
                       !isIn(benches, word) && !isNumber(word) && quantityNamed(word) == nullptr &&
                       unitNamed(word) == nullptr;
    if (tells) whose.owner.push_back(word);
  }
  return whose;
}

Kinship kinshipOf(const Whose& one, const Whose& other) {
  const bool sides = one.side != Whose::Side::untold && other.side != Whose::Side::untold;
  const bool axes = !one.axis.empty() && !other.axis.empty();
  if ((sides && one.side != other.side) || (axes && one.axis != other.axis)) return Kinship::apart;
  if (hasOneOfItsOwn(one.owner, other.owner) && hasOneOfItsOwn(other.owner, one.owner)) return Kinship::apart;
  return sides || axes || haveWordInCommon(one.owner, other.owner) ? Kinship::own : Kinship::untold;
}

bool areDifferentJoints(const Whose& one, const Whose& other) {
  const std::string *joint = jointIn(one.owner), *another = jointIn(other.owner);
  return joint != nullptr && another != nullptr && *joint != *another;
}

}  // namespace breakaway
