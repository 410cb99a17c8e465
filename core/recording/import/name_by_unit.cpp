#include "recording/import/name_by_unit.h"

#include <algorithm>
#include <array>
#include <utility>

#include "recording/columns.h"
#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

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

}  // namespace

std::string contractName(UnitKind kind, bool reference) {
  const bool linear = kind == UnitKind::length || kind == UnitKind::linearVelocity || kind == UnitKind::force;
  const auto quantity = quantityOf(kind, reference);
  return quantity ? columnName(*quantity, linear ? Axis::linear : Axis::rotary) : std::string();
}

ColumnName nameAside(Message why, const NameParts& parts) {
  ColumnName name;
  name.aside = std::move(why);
  name.group = parts.group;
  return name;
}

ColumnName nameThatSaysNothing(const NameParts& parts) {
  ColumnName name = nameAside(message("its name says nothing that is known"), parts);
  name.saysNothing = true;
  return name;
}

ColumnName nameTaken(const NameParts& parts, std::string to, int rank) {
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
  const std::string* other = has("motor") || has("mot") ? nullptr : firstIn(words, otherSources);
  if (other != nullptr) return message("\"{}\" is not what the motor gives", *other);
  return {};
}

ColumnName supplyOf(const NameParts& parts) {
  // A battery's may be another one than the motor's.
  static constexpr auto batteries =
      std::to_array<std::string_view>({"battery", "batt", "bat", "vbat", "vbatt", "电池"});
  const bool battery = firstIn(parts.words, batteries) != nullptr;
  ColumnName name = nameTaken(parts, columnName(Quantity::supply, Axis::rotary), battery ? 2 : 1);
  name.qualified = std::any_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
    return !isIn(supplyWords, word) && !isIn(decorations, word) && quantityNamed(word) == nullptr && word != "v";
  });
  return name;
}

ColumnName nameByUnit(const NameParts& parts) {
  if (parts.unit == nullptr) return nameThatSaysNothing(parts);
  const UnitKind kind = parts.unit->kind;
  bool reference = false, plain = true, motors = false, loops = false, joint = false;
  if (std::string_view(parts.unit->name) == "hz") return nameAside(message("is a frequency"), parts);
  static constexpr auto durations = std::to_array<std::string_view>(
      {"wear", "life", "lifetime", "remaining", "rul", "age", "latency", "jitter", "hold", "dwell"});
  if (const std::string* word = kind == UnitKind::time ? firstIn(parts.words, durations) : nullptr)
    return nameAside(message("\"{}\" is how long something takes", *word), parts);
  const bool counts = parts.unit->needs == UnitNeeds::countsPerRev;
  for (const std::string& word : parts.words) {
    reference = reference || isIn(referenceWords, word);
    const Unit* turns = word.size() > 2 ? unitNamed(word) : nullptr;  // "Rotation" in degrees
    const bool turned = kind == UnitKind::angle && turns != nullptr && turns->kind == UnitKind::angle;
    const bool counted = counts && (word == "pulse" || word == "pulses" || word == "hall" || word == "edge");
    plain = plain && (counted || turned || isIn(decorations, word) || isIn(referenceWords, word) ||
                      isIn(loopWords, word) || isIn(jointWords, word));
    loops = loops || isIn(loopWords, word);
    joint = joint || isIn(jointWords, word);
    motors = motors || word == "q" || word == "iq" || word == "motor" || word == "mot" || word == "applied";
  }
  const bool output = reference && kind == UnitKind::current && parts.words.size() == 2 && parts.words.front() == "u";
  if (output) return nameTaken(parts, contractName(kind, true), 3);  // a controller's output: "u_cmd [A]"
  plain = plain && (!loops || reference);                            // "MCU target (deg)", but not "PID (deg)"
  const bool supply = firstIn(parts.words, supplyWords) != nullptr;
  if (kind == UnitKind::voltage && supply) return supplyOf(parts);
  if (kind == UnitKind::voltage && parts.words.size() == 2 && isSingleLetter(parts.words[0], "uv") &&
      parts.words[1] == "m")  // "V_m (V)"
    return nameTaken(parts, contractName(kind, reference), 2);
  if (kind == UnitKind::current || kind == UnitKind::voltage) {
    if (const auto why = notTheMotors(kind, parts.words, supply); !why.empty()) return nameAside(why, parts);
    const bool letter =
        parts.words.size() == 1 && (parts.words[0] == "i" || parts.words[0] == "m" || parts.words[0] == "im");
    if (motors || letter) return nameTaken(parts, contractName(kind, reference), 2);
    return nameThatSaysNothing(parts);
  }
  // "M [Nm]", "M_Mot [Nm]", "Te_Nm"
  static constexpr auto symbols = std::to_array<std::string_view>({"te", "tem", "tel", "tm", "tmot"});
  const bool symbol = parts.words.size() == 1 && isIn(symbols, parts.words[0]);
  const bool letter = symbol || (!parts.words.empty() && isSingleLetter(parts.words[0], "mt") &&
                                 std::all_of(parts.words.begin() + 1, parts.words.end(), [](const std::string& word) {
                                   return word.size() > 1 && (isIn(decorations, word) || isIn(jointWords, word) ||
                                                              isIn(referenceWords, word));
                                 }));
  const bool enough = kind == UnitKind::time || kind == UnitKind::angularVelocity ||
                      (kind == UnitKind::angle && plain) || (kind == UnitKind::torque && letter);
  if (letter && kind == UnitKind::torque && parts.group == "left")
    return nameAside(message("may be the load's"), parts);  // "M_L [Nm]"
  const std::string to = contractName(kind, reference);
  if (!enough || to.empty()) return nameThatSaysNothing(parts);
  ColumnName name = nameTaken(parts, to, plain && kind == UnitKind::angularVelocity ? 0 : 3);
  name.byUnit = (!plain || joint) && kind != UnitKind::time;  // "knee [deg]"
  return name;
}

std::optional<ColumnName> unitAsName(std::string_view name) {
  NameParts parts;
  parts.words = wordsOf(name, false);
  const bool marked = name.find_first_of("([*") != std::string_view::npos;  // "rotation (*/s)"
  if (!marked && parts.words.size() > 1 && unitNamed(name) != nullptr) {    // "deg/s"
    parts.unit = unitNamed(name);
    parts.unitText = std::string(name);
    return nameTaken(parts, contractName(parts.unit->kind, false), 2);
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
  static constexpr auto tooShort = std::to_array<std::string_view>(
      {"min", "pu", "mn", "kn", "gf", "um", "ua", "cm", "hz", "kv", "ka", "da", "dv", "mv"});
  if (isIn(tooShort, parts.words[0]) || quantityNamed(parts.words[0]) != nullptr) return std::nullopt;
  parts.unit = unitOfWords(parts.words, 0);
  if (parts.unit == nullptr) return std::nullopt;
  const std::string to = contractName(parts.unit->kind, false);
  parts.unitText = parts.words[0];
  static constexpr auto sent = std::to_array<std::string_view>({"pulse", "pulses", "steps", "microsteps"});
  // Steps are sent to a stepper; beside an encoder it is that which tells. "rpm" tells more than "speed" does.
  ColumnName taken = nameTaken(parts, to,
                               isIn(sent, parts.words[0])                      ? 4
                               : parts.unit->kind == UnitKind::angularVelocity ? 0
                                                                               : 2);
  taken.byUnit = parts.unit->kind == UnitKind::ratio;  // "pct" doesn't say of what
  return taken;
}

}  // namespace breakaway
