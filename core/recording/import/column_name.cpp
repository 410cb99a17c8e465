#include "recording/import/column_name.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/marked_text.h"
#include "recording/import/joined_words.h"
#include "recording/import/name_by_unit.h"
#include "recording/import/name_parts.h"
#include "recording/import/name_words.h"
#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

/// The last strong quantity word, else a weak one.
struct FoundName {
  const Word* word = nullptr;
  size_t at = 0;
};

/// A name on its way to what it means.
struct NameReading {
  NameParts parts;
  bool electrical = false;  ///< counted in electrical turns
  bool supplyWord = false;
  FoundName found = {};
  UnitKind kind = UnitKind::time;
  bool reference = false;
  int unknownBefore = 0;     ///< words that aren't known before the quantity's
  std::string strange = {};  ///< the last of them that is known in no sense

  const std::string& word() const { return parts.words[found.at]; }
  bool has(std::string_view one) const { return isIn(parts.words, one); }
  bool turns() const { return kind == UnitKind::angle || kind == UnitKind::angularVelocity; }
  bool inWinding() const { return kind == UnitKind::current || kind == UnitKind::voltage; }
};

FoundName quantityIn(const Words& words) {
  FoundName found;
  for (size_t k = 0; k < words.size(); ++k) {
    const Word* word = quantityNamed(words[k]);
    if (word == nullptr) continue;
    if (found.word == nullptr || !word->weak || found.word->weak) found = {word, k};
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

/// The word that names what the unit counts: "Current actual value torque-generating [Arms]".
FoundName quantityOfUnit(const Words& words, UnitKind unit, FoundName found) {
  for (size_t k = 0; k < words.size(); ++k) {
    const Word* word = quantityNamed(words[k]);
    if (word != nullptr && !word->weak && fits(unit, word->kind)) found = {word, k};
  }
  if (found.word != nullptr && found.word->weak && !fits(unit, found.word->kind)) {  // "V_m (V)"
    for (size_t k = 0; k < words.size(); ++k) {
      const Word* word = quantityNamed(words[k]);
      if (word != nullptr && word->weak && fits(unit, word->kind)) found = {word, k};
    }
  }
  return found;
}

bool isMotion(UnitKind kind) {
  return kind == UnitKind::angle || kind == UnitKind::angularVelocity || kind == UnitKind::length ||
         kind == UnitKind::linearVelocity;
}

/// "pos_current" is where something is now, where no unit says otherwise.
FoundName withoutPresent(const NameParts& parts, FoundName found) {
  const bool current = found.word != nullptr && found.at > 0 && parts.words[found.at] == "current";
  if (!current || (parts.unit != nullptr && !isMotion(parts.unit->kind)) || parts.unknownUnit) return found;
  const Word* before = quantityNamed(parts.words[found.at - 1]);
  return before != nullptr && !before->weak && isMotion(before->kind) ? FoundName{before, found.at - 1} : found;
}

Message nounOf(UnitKind kind) {
  constexpr auto nouns =
      std::to_array<MessageText<0>>({marked("a time"), marked("an angle"), marked("a length"), marked("a speed"),
                                     marked("a speed"), marked("a current"), marked("a voltage"), marked("a torque"),
                                     marked("a force"), marked("a temperature"), marked("a ratio")});
  return message(nouns[static_cast<size_t>(kind)]);
}

Words withoutWord(Words words, size_t at) {
  if (words[at].size() == 1)
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));  // "u" of "u_cmd" is no phase
  return words;
}

/// Words that make it something else wherever they stand; a joint's "roll" becomes its axis.
Message otherThing(NameParts& parts) {
  if (const std::string* other = otherThingIn(parts.words)) {
    const bool clock = isIn(parts.words, "time") || isIn(parts.words, "t");
    const bool sinceStart = parts.unit != nullptr && parts.unit->kind == UnitKind::time && *other == "offset";
    if ((!clock || (*other != "sim" && !sinceStart)) && (*other != "sum" || parts.words.size() > 1))
      return message("the word \"{}\" makes it something else", *other);
  }
  const std::string* heading = firstIn(parts.words, headings);
  if (heading == nullptr) return {};
  const bool electric = std::any_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
    const Word* quantity = quantityNamed(word);  // "pitch_current": no vehicle as a whole has one
    return quantity != nullptr && !quantity->weak &&
           (quantity->kind == UnitKind::current || quantity->kind == UnitKind::voltage);
  });
  if (firstIn(parts.words, jointWords) == nullptr && !electric)
    return message("the word \"{}\" makes it something else", *heading);
  parts.group += (parts.group.empty() ? "" : ".") + *heading;
  std::erase(parts.words, std::string(*heading));
  return {};
}

void findQuantity(NameReading& name) {
  NameParts& parts = name.parts;
  FoundName found = quantityIn(parts.words);
  if (found.word != nullptr && parts.unit != nullptr && !fits(parts.unit->kind, found.word->kind))
    found = quantityOfUnit(parts.words, parts.unit->kind, found);
  name.found = withoutPresent(parts, found);
  // What is put into a motor, or a DC motor's, is its own: "motor input voltage".
  static constexpr auto motors = std::to_array<std::string_view>({"motor", "mot", "armature"});
  for (size_t k = 0; k < parts.words.size(); ++k) {
    const bool before = k > 0 && isIn(motors, parts.words[k - 1]),
               behind = k + 1 < parts.words.size() && isIn(motors, parts.words[k + 1]);
    const bool motorsOwn = parts.words[k] == "input" ? before || behind : parts.words[k] == "dc" && behind;
    name.supplyWord = name.supplyWord || (isIn(supplyWords, parts.words[k]) && !motorsOwn);
  }
  if (found.word == nullptr) return;
  name.kind = name.found.word->kind;
  // Of all that is supplied together, a motor among them: "System_Current_A", "Main Voltage".
  static constexpr auto wholes = std::to_array<std::string_view>({"system", "sys", "main", "mains"});
  name.supplyWord =
      name.supplyWord || (name.inWinding() && name.found.at > 0 && isIn(wholes, parts.words[name.found.at - 1]));
  const bool degrees = parts.unit != nullptr && parts.unit->kind == UnitKind::temperature;
  if (degrees && name.kind == UnitKind::time && name.found.word->weak)
    name.kind = UnitKind::temperature;                                                             // "t_motor_C"
  if (name.kind == UnitKind::temperature && parts.unit == nullptr && parts.words.back() == "f") {  // "temp_F"
    parts.unit = unitNamed("degF");
    parts.unitText = parts.words.back();
    parts.words.pop_back();
  }
}

/// No word names a quantity: a supply's voltage, or what the unit says.
ColumnName withoutQuantity(const NameReading& name) {
  const NameParts& parts = name.parts;
  // "battery", "vbat raw"; a level, a state, an identity of a battery is no voltage.
  const bool told = std::all_of(parts.words.begin(), parts.words.end(), [](const std::string& word) {
    return isIn(supplyWords, word) || (isIn(decorations, word) && !word.starts_with("state"));
  });
  const bool bare = parts.unit == nullptr && !parts.unknownUnit && name.supplyWord && told && !name.has("input") &&
                    !name.has("bus") && !name.has("esc");
  const bool volts = (name.has("v") || name.has("u")) && name.supplyWord;  // "v_bus", "U_dc"
  if (bare || volts) return supplyOf(parts);
  if (parts.unknownUnit) return nameAside(message("its unit \"{}\" is unknown", parts.unitText), parts);
  return nameByUnit(parts);
}

/// Units that mean more behind some words than alone: an "omega" in 1/s is in rad/s, an "n" would be in turns.
void settleUnit(NameReading& name) {
  NameParts& parts = name.parts;
  const std::string& named = name.word();
  const bool perSecond = parts.unknownUnit && (parts.unitText == "1/s" || parts.unitText == "s^-1") &&
                         (named == "omega" || named == "w" || named == "ω" || named == "winkelgeschwindigkeit");
  if (perSecond) {
    parts.unit = unitNamed("rad/s");
    parts.unknownUnit = false;
  }
  if (parts.unknownUnit || name.kind != UnitKind::angularVelocity) return;
  if (parts.unitText == "rads") parts.unit = unitNamed("rad/s");  // "vel_rads"
  if (parts.unitText == "degs") parts.unit = unitNamed("deg/s");
}

/// What the name is if its unit is none of its quantity.
std::optional<ColumnName> unfitUnit(NameReading& name) {
  const NameParts& parts = name.parts;
  if (parts.unknownUnit) return nameAside(message("its unit \"{}\" is unknown", parts.unitText), parts);
  // Drives tell the current that makes torque by the torque's name: "Actual torque [mA]".
  const bool torqueMaking = name.kind == UnitKind::torque && parts.unit != nullptr &&
                            parts.unit->kind == UnitKind::current && !isSingleLetter(parts.unitText, "abcuvw");
  if (torqueMaking) name.kind = UnitKind::current;
  if (parts.unit == nullptr) return std::nullopt;
  if (!fits(parts.unit->kind, name.kind)) {
    const bool inWinding = parts.unit->kind == UnitKind::current || parts.unit->kind == UnitKind::voltage;
    const bool adjective = name.word() == "current" || name.word() == "curr";  // "current_rpm"
    if (name.found.word->weak || adjective || (inWinding && !name.inWinding() && name.supplyWord))
      return nameByUnit(parts);
    if (isSingleLetter(parts.unitText, "abcuvw") && name.inWinding())
      return nameAside(message("is one phase's"), parts);
    return nameAside(message("its unit \"{}\" is none of {}", parts.unitText, nounOf(name.kind)), parts);
  }
  name.kind = parts.unit->kind;
  return std::nullopt;
}

/// "Te" of "Electromagnetic torque Te", "Ia" of "Armature current Ia": the symbol of what the words name; that of a
/// load or of the d axis is none of the motor's.
bool isSymbol(std::string_view word, UnitKind kind) {
  constexpr size_t longest = 2;
  if (word.size() < 2 || word.size() > longest || word[1] == 'l' || word[1] == 'd' || isNumber(word.substr(1)))
    return false;
  const std::string_view letters = kind == UnitKind::torque            ? "tm"
                                   : kind == UnitKind::current         ? "i"
                                   : kind == UnitKind::voltage         ? "uv"
                                   : kind == UnitKind::angularVelocity ? "nw"
                                                                       : "";
  return letters.find(word[0]) != std::string_view::npos;
}

/// Behind the quantity's word its symbol says nothing new, nor do the letters of "V_m" and "i_q".
void dropSymbols(NameReading& name) {
  const std::string_view letters = name.kind == UnitKind::voltage ? "uv" : name.kind == UnitKind::current ? "i" : "";
  for (size_t k = name.found.at + 1; k + 1 < name.parts.words.size(); ++k) {
    const std::string &word = name.parts.words[k], &index = name.parts.words[k + 1];
    if (!isSingleLetter(word, letters) || !isSingleLetter(index, "mq")) continue;
    name.parts.words.erase(name.parts.words.begin() + static_cast<std::ptrdiff_t>(k));
  }
  static constexpr auto windings = std::to_array<std::string_view>({"motor", "armature", "rotor", "anker"});
  const bool armature = firstIn(name.parts.words, windings) != nullptr;
  for (size_t k = name.parts.words.size(); k-- > name.found.at + 1;) {
    const std::string& word = name.parts.words[k];
    const bool phase = (word[1] == 'a' || word[1] == 'b' || word[1] == 'c') && !armature;
    if (isSymbol(word, name.kind) && quantityNamed(word) == nullptr && !isIn(decorations, word) && !phase)
      name.parts.words.erase(name.parts.words.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

/// What the words around the quantity make of it.
std::optional<ColumnName> readAround(NameReading& name) {
  NameParts& parts = name.parts;
  const FoundName found = name.found;
  // "Zeit 1 - Standardmessrate" in s: which clock it is matters only beside another one.
  const bool clock = name.kind == UnitKind::time && parts.unit != nullptr && found.at == 0;
  for (size_t k = 0; k < parts.words.size(); ++k) {
    const std::string& word = parts.words[k];
    const bool desired = word == "d" && k == found.at + 1 && k + 1 == parts.words.size() &&
                         (name.turns() || name.kind == UnitKind::torque);  // "theta_d"
    if (isIn(referenceWords, word) || desired) {
      name.reference = true;
    } else if (k > found.at && !isIn(decorations, word) && quantityNamed(word) == nullptr && !isIn(supplyWords, word) &&
               !isSingleLetter(word, "abcduvwxyz")) {
      if (clock) {
        ++name.unknownBefore;
        continue;
      }
      ColumnName unknown = nameAside(message("what \"{}\" makes of it is unknown", word), parts);
      unknown.unknownWord = word;
      return unknown;
    } else if (k < found.at && !isIn(decorations, word)) {
      ++name.unknownBefore;
      if (word.size() > 2 && !isKnownWord(word)) name.strange = word;
    }
    if (name.turns() && k == found.at + 1 && isSingleLetter(word, "abxyz")) {  // "encoderA"
      parts.group += (parts.group.empty() ? "" : ".") + word;
      continue;
    }
    const bool supplies = name.kind == UnitKind::voltage && isIn(supplyWords, word);  // "U_dc"
    if (found.word->weak && k != found.at && !desired && !supplies && !isIn(decorations, word) &&
        !isIn(referenceWords, word) && quantityNamed(word) == nullptr && name.kind != UnitKind::time)
      return nameThatSaysNothing(parts);
  }
  return std::nullopt;
}

/// Why such a quantity isn't the motor's own; empty when it may be.
Message notMeant(const NameReading& name) {
  const NameParts& parts = name.parts;
  if (name.inWinding()) {
    const bool incoming = name.kind == UnitKind::current && name.has("in") && !name.has("motor");
    const bool supply = name.supplyWord || incoming;
    if (auto why = notTheMotors(name.kind, withoutWord(parts.words, name.found.at), supply); !why.empty()) return why;
    const bool amount = name.kind == UnitKind::voltage && name.has("phase") && !name.has("q") && !name.has("uq");
    if (amount) return message("is one phase's");
  }
  static constexpr auto durations = std::to_array<std::string_view>(
      {"pwm", "duty", "pulse", "rise", "settling", "response", "reaction", "execution", "charge", "charging"});
  if (name.kind == UnitKind::time) {
    if (const std::string* word = firstIn(parts.words, durations))
      return message("\"{}\" is how long something takes", *word);
  }
  if (name.kind == UnitKind::torque || name.kind == UnitKind::force) {
    if (const std::string* word = firstIn(parts.words, loadWords))
      return message("\"{}\" is not what the motor gives", *word);
    const bool output =
        name.word() == "effort" && parts.unit == nullptr && (name.has("control") || name.has("controller"));
    if (output) return message("is a controller's output");
    const bool part = name.found.at + 1 < parts.words.size() && isSingleLetter(parts.words[name.found.at + 1], "fg");
    if (part && name.kind == UnitKind::torque)
      return message("is friction's or gravity's part of a torque");  // "tau_f"
  }
  if (name.kind == UnitKind::temperature) {
    static constexpr std::string_view german = "temperatur";
    static constexpr auto windings =
        std::to_array<std::string_view>({"wicklungs", "anker", "spulen", "stator", "rotor"});
    const std::string_view word = name.word();
    const std::string_view whose = word.ends_with(german) ? word.substr(0, word.size() - german.size()) : "";
    if (!whose.empty() && !isIn(windings, whose))  // "Oeltemperatur"; "Motortemperatur" is two words by now
      return message("is the temperature of the {}, not of the winding", whose);
    const auto motor = std::find_if(parts.words.rbegin(), parts.words.rend(),
                                    [](const std::string& one) { return one == "motor" || one == "mot"; });
    const auto driver = std::find_if(parts.words.rbegin(), parts.words.rend(),
                                     [](const std::string& one) { return isIn(driverWords, one); });
    if (driver != parts.words.rend() && driver <= motor)  // "inv_motor_temp" is the motor's
      return message("is the temperature of the {}, not of the winding", *driver);
  }
  return {};
}

/// Taken, with its place among others for the same thing.
ColumnName taken(NameReading& name) {
  const NameParts& parts = name.parts;
  const bool moves = name.turns() || name.kind == UnitKind::torque || name.kind == UnitKind::length ||
                     name.kind == UnitKind::linearVelocity;
  if (moves && name.has("input")) name.reference = true;  // what a controller is given
  const std::string to = contractName(name.kind, name.reference);
  if (to.empty()) return nameAside(message("is a reference, not what was measured"), parts);
  const bool q = name.has("q") || name.has("iq");
  const bool command = name.reference && to.find("reference") == std::string::npos;
  int rank = (parts.unit == nullptr ? 1 : 0) + (name.found.word->weak ? 2 : 0) + (command ? 4 : 0);
  if (name.kind == UnitKind::current && !q) ++rank;
  if (name.kind == UnitKind::temperature && !name.has("motor") && !name.has("mot") && !name.has("winding")) ++rank;
  if (name.kind == UnitKind::time && name.unknownBefore > 0) rank += 2;  // "loop_time" after "time"
  if ((name.turns() && name.electrical) || (moves && firstIn(parts.words, drivenWords) != nullptr)) ++rank;
  if (name.turns() && firstIn(parts.words, estimateWords) != nullptr) ++rank;  // "omega_hat" after "omega"
  if (name.turns() && name.has("raw")) ++rank;                                 // "vel_raw" after "vel_meas"
  ColumnName understood = nameTaken(parts, to, rank);
  understood.qualified = name.unknownBefore > 0 && name.kind != UnitKind::time;
  if (parts.unit == nullptr) understood.usual = name.found.word->usual;
  const bool drives = name.inWinding() || name.kind == UnitKind::torque || name.kind == UnitKind::force ||
                      name.kind == UnitKind::temperature;
  if (drives && !name.strange.empty()) understood.guess = message("what \"{}\" says of it is unknown", name.strange);
  const bool letter = name.found.word->weak && name.word().size() == 1 && parts.unit == nullptr;
  if (letter && (name.inWinding() || name.kind == UnitKind::force))
    understood.guess = message("a letter alone says little");
  if (parts.unit != nullptr && std::string_view(parts.unit->name) == "hz")
    understood.guess = message("a motor's turns per second, not those of its field");
  const bool controls = name.has("control") || name.has("controller");
  if ((command || controls) && name.kind == UnitKind::torque)
    understood.guess = message("it is what was commanded, not measured");
  if (name.electrical && name.turns()) {
    if (understood.needs != UnitNeeds::nothing && understood.needs != UnitNeeds::polePairs)
      return nameAside(message("is in counts of electrical turns"), parts);
    understood.needs = UnitNeeds::polePairs;
  }
  return understood;
}

}  // namespace

bool knowsQuantity(std::string_view name) {
  if (name.empty() || name.size() > 200) return false;
  return understandName(name).understood() || quantityIn(partsOfName(name, {}).words).word != nullptr;
}

ColumnName understandName(std::string_view text, std::string_view unit) {
  constexpr size_t longestName = 200;
  if (text.size() > longestName) return nameAside(message("its name is too long to be one"), NameParts{});
  if (unit.empty()) {
    text = withoutSource(text);
    if (const auto only = unitAsName(text)) return *only;
  }
  NameReading name{partsOfName(text, unit)};
  NameParts& parts = name.parts;
  name.electrical = std::erase_if(parts.words, [](const std::string& word) { return isIn(electricalWords, word); }) > 0;
  if (isMultiplied(text)) return nameAside(message("a factor stands in its name"), parts);
  const bool sideAndUnit = parts.unit != nullptr && unit.empty() && parts.unitText.size() > 2;  // "left_ticks"
  if (parts.words.empty() && (parts.unitFirst || (sideAndUnit && !parts.group.empty())))        // "left_rpm" as "rpm"
    return nameTaken(parts, contractName(parts.unit->kind, false),
                     parts.unit->kind == UnitKind::angularVelocity ? 0 : 2);
  if (parts.words.empty()) {
    ColumnName nameless = nameAside(message("it has no name"), parts);
    nameless.nameless = true;
    return nameless;
  }
  if (auto why = otherThing(parts); !why.empty()) {
    ColumnName other = nameAside(std::move(why), parts);
    for (const char* driven : {"pump", "fan"}) {  // what a motor turns
      if (name.has(driven)) other.unknownWord = driven;
    }
    return other;
  }
  findQuantity(name);
  if (name.found.word == nullptr) return withoutQuantity(name);
  if (name.kind == UnitKind::temperature && parts.unit == nullptr && parts.words.back() == "dc")
    return nameAside(message("what \"{}\" makes of it is unknown", "dc"),
                     parts);  // tenths of a degree, or a DC motor's
  const bool present =
      name.kind == UnitKind::current && parts.unit == nullptr && name.found.at + 1 < parts.words.size();
  if (present && (parts.words[name.found.at + 1] == "state" || parts.words[name.found.at + 1] == "status"))
    return nameAside(message("is a state"), parts);
  settleUnit(name);
  if (const auto other = unfitUnit(name)) return *other;
  dropSymbols(name);
  if (const auto other = readAround(name)) return *other;
  if (name.kind == UnitKind::voltage && name.supplyWord && !name.reference) return supplyOf(parts);
  if (auto why = notMeant(name); !why.empty()) return nameAside(std::move(why), parts);
  return taken(name);
}

}  // namespace breakaway
