#include "recording/import/column_name.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/marked_text.h"
#include "recording/columns.h"
#include "recording/import/name_parts.h"
#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

/// The last strong quantity word, else a weak one.
struct Found {
  const Word* word = nullptr;
  size_t at = 0;
};

Found quantityIn(const Words& words) {
  Found found;
  for (size_t k = 0; k < words.size(); ++k) {
    const Word* word = quantityNamed(words[k]);
    if (word == nullptr) continue;
    if (found.word == nullptr || !word->weak || found.word->weak) found = {word, k};
  }
  return found;
}

bool fits(UnitKind unit, UnitKind quantity);

/// The word that names what the unit counts: "Current actual value torque-generating [Arms]".
Found quantityOfUnit(const Words& words, UnitKind unit, Found found) {
  for (size_t k = 0; k < words.size(); ++k) {
    const Word* word = quantityNamed(words[k]);
    if (word != nullptr && !word->weak && fits(unit, word->kind)) found = {word, k};
  }
  return found;
}

bool fits(UnitKind unit, UnitKind quantity) {
  if (unit == quantity) return true;
  if (quantity == UnitKind::angle) return unit == UnitKind::length;
  if (quantity == UnitKind::torque) return unit == UnitKind::force;
  if (quantity == UnitKind::force) return unit == UnitKind::torque;
  return quantity == UnitKind::angularVelocity && unit == UnitKind::linearVelocity;
}

bool isMotion(UnitKind kind) {
  return kind == UnitKind::angle || kind == UnitKind::angularVelocity || kind == UnitKind::length ||
         kind == UnitKind::linearVelocity;
}

/// "pos_current" is where something is now, where no unit says otherwise.
Found withoutPresent(const NameParts& parts, Found found) {
  const bool current = found.word != nullptr && found.at > 0 && parts.words[found.at] == "current";
  if (!current || (parts.unit != nullptr && !isMotion(parts.unit->kind)) || parts.unknownUnit) return found;
  const Word* before = quantityNamed(parts.words[found.at - 1]);
  return before != nullptr && !before->weak && isMotion(before->kind) ? Found{before, found.at - 1} : found;
}

std::optional<Quantity> quantityOf(UnitKind kind, bool reference) {
  switch (kind) {
    case UnitKind::time:
      return reference ? std::nullopt : std::optional(Quantity::time);
    case UnitKind::angle:
    case UnitKind::length:
      return reference ? Quantity::positionReference : Quantity::position;
    case UnitKind::angularVelocity:
    case UnitKind::linearVelocity:
      return reference ? Quantity::velocityReference : Quantity::velocity;
    case UnitKind::current:
      return reference ? Quantity::currentReference : Quantity::current;
    case UnitKind::voltage:
      return Quantity::voltage;  // a commanded one drives as well
    case UnitKind::torque:
    case UnitKind::force:
      return Quantity::torque;
    case UnitKind::temperature:
      return reference ? std::nullopt : std::optional(Quantity::temperature);
    case UnitKind::ratio:
      return Quantity::duty;
  }
  return std::nullopt;
}

/// The contract's name of what is counted in such a unit; empty where there is none.
std::string contractName(UnitKind kind, bool reference) {
  const bool linear = kind == UnitKind::length || kind == UnitKind::linearVelocity || kind == UnitKind::force;
  const auto quantity = quantityOf(kind, reference);
  return quantity ? columnName(*quantity, linear ? Axis::linear : Axis::rotary) : std::string();
}

Message nounOf(UnitKind kind) {
  constexpr auto nouns =
      std::to_array<MessageText<0>>({marked("a time"), marked("an angle"), marked("a length"), marked("a speed"),
                                     marked("a speed"), marked("a current"), marked("a voltage"), marked("a torque"),
                                     marked("a force"), marked("a temperature"), marked("a ratio")});
  return message(nouns[static_cast<size_t>(kind)]);
}

ColumnName aside(Message why, const NameParts& parts) {
  ColumnName name;
  name.aside = std::move(why);
  name.group = parts.group;
  return name;
}

ColumnName taken(const NameParts& parts, std::string to, int rank) {
  ColumnName name;
  name.to = std::move(to);
  name.group = parts.group;
  name.rank = rank;
  name.unit = parts.unitText;
  if (parts.unit != nullptr) {
    name.scale = parts.unit->scale * parts.factor;
    name.offset = parts.unit->offset;
    name.needs = parts.unit->needs;
  }
  return name;
}

bool isSingleLetter(const std::string& word, std::string_view letters) {
  return word.size() == 1 && letters.find(word[0]) != std::string_view::npos;
}

/// A column of the electrical side that isn't the motor's own; empty when it may be.
Message notTheMotors(UnitKind kind, const Words& words, bool supply) {
  const auto has = [&words](std::string_view word) { return isIn(words, word); };
  if (kind == UnitKind::current && supply) return message("is the supply's current, not the motor's");
  if (has("d") || has("id") || has("ud") || has("vd") || has("daxis") || has("reactive") || has("magnetizing"))
    return message("is the d axis, which makes no torque");
  const bool q = has("q") || has("iq") || has("uq") || has("vq");
  const bool letter =
      std::any_of(words.begin(), words.end(), [](const std::string& word) { return isSingleLetter(word, "abcuvw"); });
  const bool phase = letter || has("pha") || has("phb") || has("phc") || has("ia") || has("ib") || has("ic");
  if (!q && phase && words.size() > 1) return message("is one phase's");
  return {};
}

Words withoutWord(Words words, size_t at) {
  if (words[at].size() == 1)
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));  // "u" of "u_cmd" is no phase
  return words;
}

/// "logic_supply_v" comes after "dc_bus_v".
ColumnName supplyOf(const NameParts& parts) {
  ColumnName name = taken(parts, columnName(Quantity::supply, Axis::rotary), 1);
  name.qualified = std::any_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
    return !isIn(supplyWords, word) && !isIn(decorations, word) && quantityNamed(word) == nullptr && word != "v";
  });
  return name;
}

/// Where no word names a quantity the unit may.
ColumnName byUnitAlone(const NameParts& parts) {
  if (parts.unit == nullptr) return aside(message("its name says nothing that is known"), parts);
  const UnitKind kind = parts.unit->kind;
  bool reference = false, plain = true, motors = false, loops = false, joint = false;
  if (std::string_view(parts.unit->name) == "hz") return aside(message("is a frequency"), parts);
  const bool counts = parts.unit->needs == UnitNeeds::countsPerRev;
  for (const std::string& word : parts.words) {
    reference = reference || isIn(referenceWords, word);
    const bool counted = counts && (word == "pulse" || word == "pulses" || word == "hall" || word == "edge");
    plain = plain && (counted || isIn(decorations, word) || isIn(referenceWords, word) || isIn(loopWords, word) ||
                      isIn(jointWords, word));
    loops = loops || isIn(loopWords, word);
    joint = joint || isIn(jointWords, word);
    motors = motors || word == "q" || word == "iq" || word == "motor" || word == "mot" || word == "applied";
  }
  const bool output = reference && kind == UnitKind::current && parts.words.size() == 2 && parts.words.front() == "u";
  if (output) return taken(parts, contractName(kind, true), 3);  // a controller's output: "u_cmd [A]"
  plain = plain && (!loops || reference);                        // "MCU target (deg)", but not "PID (deg)"
  const bool supply = firstIn(parts.words, supplyWords) != nullptr;
  if (kind == UnitKind::voltage && supply) return supplyOf(parts);
  if (kind == UnitKind::current || kind == UnitKind::voltage) {
    if (const auto why = notTheMotors(kind, parts.words, supply); !why.empty()) return aside(why, parts);
    const bool letter =
        parts.words.size() == 1 && (parts.words[0] == "i" || parts.words[0] == "m" || parts.words[0] == "im");
    if (motors || letter) return taken(parts, contractName(kind, reference), 2);
    return aside(message("its name says nothing that is known"), parts);
  }
  const bool letter = parts.words.size() == 1 && isSingleLetter(parts.words[0], "mt");  // "M [Nm]"
  const bool enough = kind == UnitKind::time || kind == UnitKind::angularVelocity ||
                      (kind == UnitKind::angle && plain) || (kind == UnitKind::torque && letter);
  if (letter && kind == UnitKind::torque && parts.group == "left")
    return aside(message("may be the load's"), parts);  // "M_L [Nm]"
  const std::string to = contractName(kind, reference);
  if (!enough || to.empty()) return aside(message("its name says nothing that is known"), parts);
  ColumnName name = taken(parts, to, plain && kind == UnitKind::angularVelocity ? 0 : 3);
  name.byUnit = (!plain || joint) && kind != UnitKind::time;  // "knee [deg]"
  return name;
}

/// A name that is nothing but a unit: "rpm", "millis".
std::optional<ColumnName> unitAsName(std::string_view name) {
  NameParts parts;
  parts.words = wordsOf(name, false);
  if (parts.words.size() > 1 && unitNamed(name) != nullptr) {  // "deg/s"
    parts.unit = unitNamed(name);
    parts.unitText = std::string(name);
    return taken(parts, contractName(parts.unit->kind, false), 2);
  }
  while (!parts.words.empty() && isNumber(parts.words.back())) {
    parts.group = parts.words.back();
    parts.words.pop_back();
  }
  if (parts.words.size() == 1) {  // "rpm0"
    std::string& word = parts.words[0];
    const size_t letters = word.find_last_not_of("0123456789") + 1;
    if (letters > 2 && letters < word.size() && unitNamed(word.substr(0, letters)) != nullptr) {
      parts.group = word.substr(letters);
      word.resize(letters);
    }
  }
  if (parts.words.size() != 1 || parts.words[0].size() < 2) return std::nullopt;
  static constexpr auto tooShort =
      std::to_array<std::string_view>({"min", "pu", "mn", "kn", "gf", "um", "ua", "cm", "hz", "kv", "ka", "da", "dv"});
  if (isIn(tooShort, parts.words[0]) || quantityNamed(parts.words[0]) != nullptr) return std::nullopt;
  parts.unit = unitOfWords(parts.words, 0);
  if (parts.unit == nullptr) return std::nullopt;
  const std::string to = contractName(parts.unit->kind, false);
  parts.unitText = parts.words[0];
  static constexpr auto sent = std::to_array<std::string_view>({"pulse", "pulses", "steps", "microsteps"});
  // Steps are sent to a stepper; beside an encoder it is that which tells. "rpm" tells more than "speed" does.
  return taken(parts, to, isIn(sent, parts.words[0]) ? 4 : parts.unit->kind == UnitKind::angularVelocity ? 0 : 2);
}

}  // namespace

bool knowsQuantity(std::string_view name) {
  if (name.empty() || name.size() > 200) return false;
  return understandName(name).understood() || quantityIn(partsOfName(name, {}).words).word != nullptr;
}

ColumnName understandName(std::string_view name, std::string_view unit) {
  constexpr size_t longestName = 200;
  if (name.size() > longestName) return aside(message("its name is too long to be one"), NameParts{});
  if (unit.empty()) {
    if (const auto only = unitAsName(name)) return *only;
  }
  NameParts parts = partsOfName(name, unit);
  const bool electrical =
      std::erase_if(parts.words, [](const std::string& word) { return isIn(electricalWords, word); }) > 0;
  const bool sideAndUnit = parts.unit != nullptr && unit.empty() && parts.unitText.size() > 2;  // "left_ticks"
  if (parts.words.empty() && (parts.unitFirst || (sideAndUnit && !parts.group.empty())))        // "left_rpm" as "rpm"
    return taken(parts, contractName(parts.unit->kind, false), parts.unit->kind == UnitKind::angularVelocity ? 0 : 2);
  if (parts.words.empty()) return aside(message("it has no name"), parts);
  if (isMultiplied(name)) return aside(message("a factor stands in its name"), parts);
  if (const std::string* other = firstIn(parts.words, otherThings)) {
    const bool clock = *other == "sim" && isIn(parts.words, "time");
    if (!clock && (*other != "sum" || parts.words.size() > 1))
      return aside(message("the word \"{}\" makes it something else", *other), parts);
  }
  if (const std::string* heading = firstIn(parts.words, headings)) {
    if (firstIn(parts.words, jointWords) == nullptr)
      return aside(message("the word \"{}\" makes it something else", *heading), parts);
    parts.group += (parts.group.empty() ? "" : ".") + *heading;
    std::erase(parts.words, std::string(*heading));
  }
  Found found = quantityIn(parts.words);
  if (found.word != nullptr && parts.unit != nullptr && !fits(parts.unit->kind, found.word->kind))
    found = quantityOfUnit(parts.words, parts.unit->kind, found);
  found = withoutPresent(parts, found);
  if (found.word != nullptr && found.word->kind == UnitKind::temperature && parts.unit == nullptr &&
      parts.words.back() == "dc")
    return aside(message("what \"{}\" makes of it is unknown", "dc"), parts);  // tenths of a degree, or a DC motor's
  const bool supplyWord = firstIn(parts.words, supplyWords) != nullptr;
  if (parts.unit == nullptr && found.word != nullptr && found.word->kind == UnitKind::temperature &&
      parts.words.back() == "f") {  // "temp_F"
    parts.unit = unitNamed("degF");
    parts.unitText = parts.words.back();
    parts.words.pop_back();
  }
  if (found.word == nullptr) {
    // "battery", "vbat raw"; a level, a state, an identity of a battery is no voltage.
    const bool told = std::all_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
      return isIn(supplyWords, word) || (isIn(decorations, word) && !word.starts_with("state"));
    });
    const bool bare = parts.unit == nullptr && !parts.unknownUnit && supplyWord && told &&
                      !isIn(parts.words, "input") && !isIn(parts.words, "bus") && !isIn(parts.words, "esc");
    const bool volts = isIn(parts.words, "v") && supplyWord;  // "v_bus"
    if (bare || volts) return supplyOf(parts);
    if (parts.unknownUnit) return aside(message("its unit \"{}\" is unknown", parts.unitText), parts);
    return byUnitAlone(parts);
  }
  UnitKind kind = found.word->kind;
  const bool present = kind == UnitKind::current && parts.unit == nullptr && found.at + 1 < parts.words.size();
  if (present && (parts.words[found.at + 1] == "state" || parts.words[found.at + 1] == "status"))
    return aside(message("is a state"), parts);
  const std::string& named = parts.words[found.at];
  const bool perSecond = parts.unknownUnit && (parts.unitText == "1/s" || parts.unitText == "s^-1") &&
                         (named == "omega" || named == "w" || named == "ω" || named == "winkelgeschwindigkeit");
  if (perSecond) {  // an "omega" in 1/s is in rad/s; an "n" would be in turns
    parts.unit = unitNamed("rad/s");
    parts.unknownUnit = false;
  }
  if (parts.unknownUnit) return aside(message("its unit \"{}\" is unknown", parts.unitText), parts);
  if (kind == UnitKind::angularVelocity && parts.unitText == "rads") parts.unit = unitNamed("rad/s");  // "vel_rads"
  if (kind == UnitKind::angularVelocity && parts.unitText == "degs") parts.unit = unitNamed("deg/s");
  // Drives tell the current that makes torque by the torque's name: "Actual torque [mA]".
  const bool torqueMaking = kind == UnitKind::torque && parts.unit != nullptr &&
                            parts.unit->kind == UnitKind::current && !isSingleLetter(parts.unitText, "abcuvw");
  if (torqueMaking) kind = UnitKind::current;
  if (parts.unit != nullptr && !fits(parts.unit->kind, kind)) {
    const bool inWinding = parts.unit->kind == UnitKind::current || parts.unit->kind == UnitKind::voltage;
    const bool strongElectrical = kind == UnitKind::current || kind == UnitKind::voltage;
    const bool adjective = parts.words[found.at] == "current" || parts.words[found.at] == "curr";  // "current_rpm"
    if (found.word->weak || adjective || (inWinding && !strongElectrical && supplyWord)) return byUnitAlone(parts);
    if (isSingleLetter(parts.unitText, "abcuvw") && strongElectrical) return aside(message("is one phase's"), parts);
    return aside(message("its unit \"{}\" is none of {}", parts.unitText, nounOf(kind)), parts);
  }
  if (parts.unit != nullptr) kind = parts.unit->kind;
  bool reference = false;
  // "Zeit 1 - Standardmessrate" in s: which clock it is matters only beside another one.
  const bool clock = kind == UnitKind::time && parts.unit != nullptr && found.at == 0;
  int unknownBefore = 0;
  const bool turns = kind == UnitKind::angle || kind == UnitKind::angularVelocity;
  for (size_t k = 0; k < parts.words.size(); ++k) {
    const std::string& word = parts.words[k];
    const bool desired = word == "d" && k == found.at + 1 && k + 1 == parts.words.size() &&
                         (turns || kind == UnitKind::torque);  // "theta_d"
    if (isIn(referenceWords, word) || desired) {
      reference = true;
    } else if (k > found.at && !isIn(decorations, word) && quantityNamed(word) == nullptr && !isIn(supplyWords, word) &&
               !isSingleLetter(word, "abcduvwxyz")) {
      if (clock) {
        ++unknownBefore;
        continue;
      }
      ColumnName unknown = aside(message("what \"{}\" makes of it is unknown", word), parts);
      unknown.unknownWord = word;
      return unknown;
    } else if (k < found.at && !isIn(decorations, word)) {
      ++unknownBefore;
    }
    if (turns && k == found.at + 1 && isSingleLetter(word, "abxyz")) {  // "encoderA"
      parts.group += (parts.group.empty() ? "" : ".") + word;
      continue;
    }
    if (found.word->weak && k != found.at && !desired && !isIn(decorations, word) && !isIn(referenceWords, word) &&
        quantityNamed(word) == nullptr && kind != UnitKind::time)
      return aside(message("its name says nothing that is known"), parts);
  }
  const bool inWinding = kind == UnitKind::current || kind == UnitKind::voltage;
  const bool supply = supplyWord && inWinding;
  if (kind == UnitKind::voltage && supply && !reference) return supplyOf(parts);
  if (inWinding) {
    if (const auto why = notTheMotors(kind, withoutWord(parts.words, found.at),
                                      supply || (kind == UnitKind::current && isIn(parts.words, "in")));
        !why.empty())
      return aside(why, parts);
  }
  static constexpr auto durations = std::to_array<std::string_view>(
      {"pwm", "duty", "pulse", "rise", "settling", "response", "reaction", "execution", "charge", "charging"});
  if (kind == UnitKind::time) {
    if (const std::string* word = firstIn(parts.words, durations))
      return aside(message("\"{}\" is how long something takes", *word), parts);
  }
  if (kind == UnitKind::torque || kind == UnitKind::force) {
    if (const std::string* word = firstIn(parts.words, loadWords))
      return aside(message("\"{}\" is not what the motor gives", *word), parts);
    const bool part = found.at + 1 < parts.words.size() && isSingleLetter(parts.words[found.at + 1], "fg");
    if (part && kind == UnitKind::torque)
      return aside(message("is friction's or gravity's part of a torque"), parts);  // "tau_f"
  }
  if (kind == UnitKind::temperature) {
    if (const std::string* word = firstIn(parts.words, driverWords))
      return aside(message("is the temperature of the {}, not of the winding", *word), parts);
  }
  const bool moves = kind == UnitKind::angle || kind == UnitKind::angularVelocity || kind == UnitKind::torque ||
                     kind == UnitKind::length || kind == UnitKind::linearVelocity;
  if (moves && isIn(parts.words, "input")) reference = true;  // what a controller is given
  const std::string to = contractName(kind, reference);
  if (to.empty()) return aside(message("is a reference, not what was measured"), parts);
  const bool q = isIn(parts.words, "q") || isIn(parts.words, "iq");
  const bool command = reference && to.find("reference") == std::string::npos;
  int rank = (parts.unit == nullptr ? 1 : 0) + (found.word->weak ? 2 : 0) + (command ? 4 : 0);
  if (kind == UnitKind::current && !q) ++rank;
  if (kind == UnitKind::time && unknownBefore > 0) rank += 2;  // "loop_time" after "time"
  if (moves && (electrical || firstIn(parts.words, drivenWords) != nullptr)) ++rank;
  ColumnName understood = taken(parts, to, rank);
  understood.qualified = unknownBefore > 0 && kind != UnitKind::time;
  if (parts.unit == nullptr) understood.usual = found.word->usual;
  if (parts.unit != nullptr && std::string_view(parts.unit->name) == "hz")
    understood.guess = message("a motor's turns per second, not those of its field");
  const bool controls = isIn(parts.words, "control") || isIn(parts.words, "controller");
  if ((command || controls) && kind == UnitKind::torque)
    understood.guess = message("it is what was commanded, not measured");
  if (electrical && turns) {
    if (understood.needs != UnitNeeds::nothing && understood.needs != UnitNeeds::polePairs)
      return aside(message("is in counts of electrical turns"), parts);
    understood.needs = UnitNeeds::polePairs;
  }
  return understood;
}

}  // namespace breakaway
