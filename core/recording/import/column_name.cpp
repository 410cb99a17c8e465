#include "recording/import/column_name.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "recording/columns.h"

namespace breakaway {

namespace {

using Words = std::vector<std::string>;
using List = std::vector<std::string_view>;

/// What a word names. `weak` words count only where no other does: single letters, and what often stands before others.
struct Word {
  std::string_view text;
  UnitKind kind;
  bool weak = false;
};

constexpr auto quantities = std::to_array<Word>({
    {"time", UnitKind::time},
    {"timestamp", UnitKind::time},
    {"datetime", UnitKind::time},
    {"zeit", UnitKind::time},
    {"zeitstempel", UnitKind::time},
    {"elapsed", UnitKind::time},
    {"uptime", UnitKind::time},
    {"stamp", UnitKind::time, true},
    {"clock", UnitKind::time, true},
    {"date", UnitKind::time, true},
    {"uhrzeit", UnitKind::time},
    {"t", UnitKind::time, true},
    {"velocity", UnitKind::angularVelocity},
    {"velocities", UnitKind::angularVelocity},
    {"vel", UnitKind::angularVelocity},
    {"velo", UnitKind::angularVelocity},
    {"speed", UnitKind::angularVelocity},
    {"spd", UnitKind::angularVelocity},
    {"omega", UnitKind::angularVelocity},
    {"drehzahl", UnitKind::angularVelocity},
    {"geschwindigkeit", UnitKind::angularVelocity},
    {"winkelgeschwindigkeit", UnitKind::angularVelocity},
    {"thetadot", UnitKind::angularVelocity},
    {"phidot", UnitKind::angularVelocity},
    {"qdot", UnitKind::angularVelocity},
    {"qd", UnitKind::angularVelocity, true},
    {"dq", UnitKind::angularVelocity, true},
    {"w", UnitKind::angularVelocity, true},
    {"position", UnitKind::angle},
    {"positions", UnitKind::angle},
    {"pos", UnitKind::angle},
    {"angle", UnitKind::angle},
    {"theta", UnitKind::angle},
    {"phi", UnitKind::angle},
    {"winkel", UnitKind::angle},
    {"lage", UnitKind::angle},
    {"weg", UnitKind::angle},
    {"displacement", UnitKind::angle},
    {"drehwinkel", UnitKind::angle},
    {"th", UnitKind::angle, true},
    {"ang", UnitKind::angle, true},
    {"q", UnitKind::angle, true},
    {"encoder", UnitKind::angle, true},
    {"enc", UnitKind::angle, true},
    {"torque", UnitKind::torque},
    {"trq", UnitKind::torque},
    {"tau", UnitKind::torque},
    {"effort", UnitKind::torque},
    {"drehmoment", UnitKind::torque},
    {"moment", UnitKind::torque},
    {"force", UnitKind::force},
    {"kraft", UnitKind::force},
    {"f", UnitKind::force, true},
    {"temperature", UnitKind::temperature},
    {"temp", UnitKind::temperature},
    {"temperatur", UnitKind::temperature},
    {"duty", UnitKind::ratio},
    {"dutycycle", UnitKind::ratio},
    {"pwm", UnitKind::ratio},
    {"voltage", UnitKind::voltage},
    {"spannung", UnitKind::voltage},
    {"uq", UnitKind::voltage},
    {"vq", UnitKind::voltage},
    {"vm", UnitKind::voltage},
    {"u", UnitKind::voltage, true},
    {"volts", UnitKind::voltage},
    {"volt", UnitKind::voltage},
    {"current", UnitKind::current},
    {"currents", UnitKind::current},
    {"curr", UnitKind::current},
    {"cur", UnitKind::current},
    {"strom", UnitKind::current},
    {"iq", UnitKind::current},
    {"amps", UnitKind::current},
    {"i", UnitKind::current, true},
});

constexpr auto referenceWords = std::to_array<std::string_view>(
    {"ref", "reference", "target", "goal", "setpoint", "sp", "cmd", "command", "commanded", "desired", "des", "demand",
     "demanded", "soll", "set", "sollwert", "request", "requested"});
constexpr auto supplyWords = std::to_array<std::string_view>(
    {"supply", "bus", "vbus", "vdc", "dc", "battery", "batt", "bat", "vbat", "vbatt", "vin", "dclink", "input"});
/// May stand behind the quantity and change nothing.
constexpr auto decorations = std::to_array<std::string_view>(
    {"actual",   "act",      "measured", "meas",    "measurement", "present",    "motor", "mot",       "shaft",
     "rotor",    "encoder",  "enc",      "joint",   "axis",        "value",      "val",   "values",    "ist",
     "istwert",  "feedback", "fb",       "stamp",   "cycle",       "estimate",   "est",   "estimated", "estimator",
     "filtered", "filt",     "lpf",      "now",     "data",        "output",     "out",   "raw",       "state",
     "states",   "q",        "mech",     "m",       "r",           "mechanical", "today", "shadow",    "total",
     "latest",   "per",      "of",       "the",     "link",        "angular",    "in",    "since",     "start",
     "voltage",  "current",  "sensor",   "reading", "channel",     "ch",         "sec"});
/// Wherever they stand, the column is something else.
constexpr auto otherThings =
    std::to_array<std::string_view>({"error",        "err",        "limit",     "lim",          "max",
                                     "min",          "peak",       "integral",  "integrator",   "std",
                                     "rms",          "gain",       "offset",    "threshold",    "mode",
                                     "fault",        "derivative", "ripple",    "tolerance",    "delta",
                                     "diff",         "difference", "deviation", "fehler",       "gyro",
                                     "gyroadc",      "imu",        "accel",     "acceleration", "acc",
                                     "mag",          "gps",        "wheel",     "vehicle",      "roll",
                                     "pitch",        "yaw",        "variance",  "covariance",   "correction",
                                     "compensation", "power",      "energy",    "ratio",        "sum",
                                     "abs",          "dt",         "delay",     "duration",     "regelabweichung",
                                     "bandwidth"});
constexpr auto loadWords = std::to_array<std::string_view>(
    {"load", "external", "friction", "disturbance", "gravity", "cogging", "brake", "feedforward", "ff"});
constexpr auto driverWords =
    std::to_array<std::string_view>({"fet", "mos", "mosfet", "driver", "controller", "mcu", "board", "ambient", "esc",
                                     "inverter", "cpu", "bridge", "encoder", "pcb", "baro", "imu"});

template <typename Some>
bool isIn(const Some& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

template <typename Some>
const std::string* firstIn(const Words& words, const Some& list) {
  const auto it = std::find_if(words.begin(), words.end(), [&list](const auto& word) { return isIn(list, word); });
  return it == words.end() ? nullptr : &*it;
}

bool isNumber(std::string_view word) {
  return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

const Word* quantityNamed(std::string_view word) {
  const auto it =
      std::find_if(quantities.begin(), quantities.end(), [word](const Word& one) { return one.text == word; });
  if (it != quantities.end()) return &*it;
  // German compounds: "Motorstrom", "Solldrehzahl".
  static constexpr auto germanEnds = std::to_array<std::string_view>(
      {"strom", "spannung", "drehzahl", "drehmoment", "winkel", "temperatur", "kraft", "geschwindigkeit", "zeit"});
  for (const std::string_view end : germanEnds) {
    if (word.size() > end.size() + 2 && word.ends_with(end)) return quantityNamed(end);
  }
  return nullptr;
}

/// A name taken apart.
struct Parts {
  Words words;  ///< without the unit and the numbers
  Words plain;  ///< with the unit's words
  std::string group;
  const Unit* unit = nullptr;
  std::string unitText;
  bool unknownUnit = false;  ///< a unit stands there, but none that is understood
};

/// Takes bracketed units and indices off the name.
std::string takeBrackets(std::string_view name, Parts& parts) {
  std::string rest;
  while (!name.empty()) {
    const size_t open = name.find_first_of("[(");
    const size_t close = open == std::string_view::npos ? open : name.find_first_of("])", open);
    if (close == std::string_view::npos || (open == 0 && close + 1 == name.size() && rest.empty())) break;
    rest += name.substr(0, open);
    const std::string_view inner = name.substr(open + 1, close - open - 1);
    name.remove_prefix(close + 1);
    const Words words = wordsOf(inner, true);
    const bool plainWords = std::all_of(words.begin(), words.end(), [](const std::string& word) {
      return isIn(decorations, word) || isIn(referenceWords, word) || quantityNamed(word) != nullptr;
    });
    if (const Unit* unit = unitNamed(inner); unit != nullptr && !isNumber(inner)) {
      parts.unit = unit;
      parts.unitText = std::string(inner);
    } else if (isNumber(inner) || (plainWords && !words.empty())) {
      rest += " " + std::string(inner) + " ";
    } else if (!words.empty()) {
      parts.unknownUnit = true;
      parts.unitText = std::string(inner);
    }
  }
  return rest + std::string(name);
}

void takeGroup(Words& words, std::string& group) {
  Words kept;
  for (std::string& word : words) {
    const size_t digit = word.find_first_of("0123456789");
    const bool axis = digit == 1 && isNumber(word.substr(1));  // "m0"
    const bool side = word == "left" || word == "right";
    if (isNumber(word) || axis || side) group += (group.empty() ? "" : ".") + word;
    if (!isNumber(word) && !axis && !side) kept.push_back(std::move(word));
  }
  words = std::move(kept);
}

/// A letter behind a name may be an index ("theta_m", "current_c") where such a unit makes no sense.
bool isIndexLetter(const Words& words, const Unit& unit) {
  const std::string& last = words.back();
  if (last.size() != 1) return false;
  for (size_t k = words.size() - 1; k-- > 0;) {
    const Word* word = quantityNamed(words[k]);
    if (word == nullptr) continue;
    const bool length = unit.kind == UnitKind::length && word->kind == UnitKind::angle && words[k].starts_with("pos");
    return unit.kind != word->kind && !length && (last == "m" || last == "c");
  }
  return false;
}

/// The text up to where its word `count` begins.
std::string_view firstWords(std::string_view text, size_t count) {
  size_t end = text.size();
  while (end > 0 && wordsOf(text.substr(0, end), false).size() > count) --end;
  return text.substr(0, end);
}

/// A unit as the last words; the longest that is one.
void takeUnitWords(const std::string& text, Parts& parts) {
  Words plain = wordsOf(text, false);
  while (!plain.empty() && isNumber(plain.back()) && plain.size() > 1) {
    if (plain.size() > 2 && unitOfWords(plain, plain.size() - 2) != nullptr) break;  // "min 1"
    plain.pop_back();
  }
  for (const bool camel : {false, true}) {
    if (camel) plain = wordsOf(text, true);
    for (size_t from = 1; from < plain.size(); ++from) {
      const Unit* unit = unitOfWords(plain, from);
      if (unit != nullptr && from + 1 == plain.size() && isIndexLetter(plain, *unit)) unit = nullptr;
      if (unit == nullptr || (plain[from] == "1" && plain.size() == from + 1)) continue;
      parts.unit = unit;
      for (size_t k = from; k < plain.size(); ++k) parts.unitText += (k == from ? "" : "_") + plain[k];
      parts.words = camel ? Words(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(from))
                          : wordsOf(firstWords(text, from), true);
      while (parts.words.size() > 1 && parts.words.back() == "per") parts.words.pop_back();  // "t / ms"
      return;
    }
  }
  parts.words = wordsOf(text, true);
}

/// "theta dot" is a speed, "i q" the current of the q axis.
void joinWords(Words& words) {
  for (size_t k = 0; k + 1 < words.size(); ++k) {
    const bool axis = words[k + 1] == "q" || words[k + 1] == "d";
    if (axis && (words[k] == "i" || words[k] == "u" || words[k] == "v")) {
      words[k] += words[k + 1];
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      continue;
    }
    const Word* word = quantityNamed(words[k]);
    if (words[k + 1] != "dot" || word == nullptr || word->kind != UnitKind::angle) continue;
    words[k] = "omega";
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  }
}

Parts partsOf(std::string_view name, std::string_view unit) {
  Parts parts;
  std::string text = takeBrackets(name, parts);
  if (!unit.empty()) {
    parts.unitText = std::string(unit);
    parts.unit = unitNamed(unit);
    parts.unknownUnit = parts.unit == nullptr;
  }
  const size_t in = text.find(" in ");
  if (parts.unit == nullptr && !parts.unknownUnit && in != std::string::npos) {
    if (const Unit* named = unitNamed(std::string_view(text).substr(in + 4))) {
      parts.unit = named;
      parts.unitText = text.substr(in + 4);
    } else {
      parts.unknownUnit = true;
      parts.unitText = text.substr(in + 4);
    }
    text = text.substr(0, in);
  }
  if (parts.unit == nullptr && !parts.unknownUnit) {
    takeUnitWords(text, parts);
  } else {
    parts.words = wordsOf(text, true);
  }
  parts.plain = wordsOf(text, false);
  takeGroup(parts.words, parts.group);
  std::erase_if(parts.words, [](const std::string& word) { return word == "per"; });
  joinWords(parts.words);
  return parts;
}

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

bool fits(UnitKind unit, UnitKind quantity) {
  if (unit == quantity) return true;
  if (quantity == UnitKind::angle) return unit == UnitKind::length;
  if (quantity == UnitKind::torque) return unit == UnitKind::force;
  if (quantity == UnitKind::force) return unit == UnitKind::torque;
  return quantity == UnitKind::angularVelocity && unit == UnitKind::linearVelocity;
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

const char* nounOf(UnitKind kind) {
  constexpr auto nouns =
      std::to_array<const char*>({"a time", "an angle", "a length", "a speed", "a speed", "a current", "a voltage",
                                  "a torque", "a force", "a temperature", "a ratio"});
  return nouns[static_cast<size_t>(kind)];
}

ColumnName aside(std::string why, const Parts& parts) {
  ColumnName name;
  name.aside = std::move(why);
  name.group = parts.group;
  return name;
}

ColumnName taken(const Parts& parts, std::string to, int rank) {
  ColumnName name;
  name.to = std::move(to);
  name.group = parts.group;
  name.rank = rank;
  name.unit = parts.unitText;
  if (parts.unit != nullptr) {
    name.scale = parts.unit->scale;
    name.offset = parts.unit->offset;
    name.needs = parts.unit->needs;
  }
  return name;
}

bool isSingleLetter(const std::string& word, std::string_view letters) {
  return word.size() == 1 && letters.find(word[0]) != std::string_view::npos;
}

/// A column of the electrical side that isn't the motor's own; empty when it may be.
std::string notTheMotors(UnitKind kind, const Words& words, bool supply) {
  const auto has = [&words](std::string_view word) { return isIn(words, word); };
  if (kind == UnitKind::current && supply) return "is the supply's current, not the motor's";
  if (has("d") || has("id") || has("ud") || has("vd") || has("daxis")) return "is the d axis, which makes no torque";
  const bool q = has("q") || has("iq") || has("uq") || has("vq");
  const bool letter =
      std::any_of(words.begin(), words.end(), [](const std::string& word) { return isSingleLetter(word, "abcuvw"); });
  const bool phase = letter || has("pha") || has("phb") || has("phc") || has("ia") || has("ib") || has("ic");
  if (!q && phase && words.size() > 1) return "is one phase's";
  return {};
}

/// Where no word names a quantity the unit may.
ColumnName byUnitAlone(const Parts& parts) {
  if (parts.unit == nullptr) return aside("its name says nothing that is known", parts);
  const UnitKind kind = parts.unit->kind;
  bool reference = false, plain = true, motors = false;
  for (const std::string& word : parts.words) {
    reference = reference || isIn(referenceWords, word);
    plain = plain && (isIn(decorations, word) || isIn(referenceWords, word));
    motors = motors || word == "q" || word == "iq" || word == "motor";
  }
  const bool supply = firstIn(parts.words, supplyWords) != nullptr;
  if (kind == UnitKind::voltage && supply) return taken(parts, columnName(Quantity::supply, Axis::rotary), 1);
  if (kind == UnitKind::current || kind == UnitKind::voltage) {
    if (const auto why = notTheMotors(kind, parts.words, supply); !why.empty()) return aside(why, parts);
    const bool letter = parts.words.size() == 1 && (parts.words[0] == "i" || parts.words[0] == "m");
    if (motors || letter) return taken(parts, contractName(kind, reference), 2);
    return aside("its name says nothing that is known", parts);
  }
  const bool enough = kind == UnitKind::time || kind == UnitKind::angularVelocity || (kind == UnitKind::angle && plain);
  const std::string to = contractName(kind, reference);
  if (!enough || to.empty()) return aside("its name says nothing that is known", parts);
  return taken(parts, to, 3);
}

/// A name that is nothing but a unit: "rpm", "millis".
std::optional<ColumnName> unitAsName(std::string_view name) {
  Parts parts;
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
  if (parts.words.size() != 1 || parts.words[0].size() < 2) return std::nullopt;
  static constexpr auto tooShort = std::to_array<std::string_view>({"min", "pu", "mn", "kn", "gf", "um", "ua", "cm"});
  if (isIn(tooShort, parts.words[0]) || quantityNamed(parts.words[0]) != nullptr) return std::nullopt;
  parts.unit = unitOfWords(parts.words, 0);
  if (parts.unit == nullptr) return std::nullopt;
  const std::string to = contractName(parts.unit->kind, false);
  parts.unitText = parts.words[0];
  return taken(parts, to, 2);
}

}  // namespace

bool knowsQuantity(std::string_view name) {
  if (name.empty() || name.size() > 200) return false;
  return understandName(name).understood() || quantityIn(partsOf(name, {}).words).word != nullptr;
}

ColumnName understandName(std::string_view name, std::string_view unit) {
  constexpr size_t longestName = 200;
  if (name.size() > longestName) return aside("its name is too long to be one", Parts{});
  if (unit.empty()) {
    if (const auto only = unitAsName(name)) return *only;
  }
  const Parts parts = partsOf(name, unit);
  if (parts.words.empty()) return aside("it has no name", parts);
  if (const std::string* other = firstIn(parts.words, otherThings)) {
    if (*other != "sum" || parts.words.size() > 1)
      return aside("the word \"" + *other + "\" makes it something else", parts);
  }
  const Found found = quantityIn(parts.words);
  const bool supplyWord = firstIn(parts.words, supplyWords) != nullptr;
  if (found.word == nullptr) {
    const bool bare = parts.unit == nullptr && !parts.unknownUnit && supplyWord && !isIn(parts.words, "input") &&
                      !isIn(parts.words, "bus");
    const bool volts = isIn(parts.words, "v") && supplyWord;  // "v_bus"
    if (bare || volts) return taken(parts, columnName(Quantity::supply, Axis::rotary), 1);
    if (parts.unknownUnit) return aside("its unit \"" + parts.unitText + "\" is unknown", parts);
    return byUnitAlone(parts);
  }
  UnitKind kind = found.word->kind;
  if (parts.unknownUnit) return aside("its unit \"" + parts.unitText + "\" is unknown", parts);
  if (parts.unit != nullptr && !fits(parts.unit->kind, kind)) {
    const bool electrical = parts.unit->kind == UnitKind::current || parts.unit->kind == UnitKind::voltage;
    const bool strongElectrical = kind == UnitKind::current || kind == UnitKind::voltage;
    if (found.word->weak || (electrical && !strongElectrical && supplyWord)) return byUnitAlone(parts);
    if (isSingleLetter(parts.unitText, "abcuvw") && strongElectrical) return aside("is one phase's", parts);
    return aside("its unit \"" + parts.unitText + "\" is none of " + nounOf(kind), parts);
  }
  if (parts.unit != nullptr) kind = parts.unit->kind;
  bool reference = false;
  int unknownBefore = 0;
  for (size_t k = 0; k < parts.words.size(); ++k) {
    const std::string& word = parts.words[k];
    if (isIn(referenceWords, word)) {
      reference = true;
    } else if (k > found.at && !isIn(decorations, word) && quantityNamed(word) == nullptr && !isIn(supplyWords, word) &&
               !isSingleLetter(word, "abcduvwxyz")) {
      return aside("what \"" + word + "\" makes of it is unknown", parts);
    } else if (k < found.at && !isIn(decorations, word)) {
      ++unknownBefore;
    }
    if (found.word->weak && k != found.at && !isIn(decorations, word) && !isIn(referenceWords, word) &&
        quantityNamed(word) == nullptr && kind != UnitKind::time)
      return aside("its name says nothing that is known", parts);
  }
  const bool electrical = kind == UnitKind::current || kind == UnitKind::voltage;
  const bool supply = supplyWord && electrical;
  if (kind == UnitKind::voltage && supply && !reference)
    return taken(parts, columnName(Quantity::supply, Axis::rotary), 1);
  if (electrical) {
    if (const auto why =
            notTheMotors(kind, parts.words, supply || (kind == UnitKind::current && isIn(parts.words, "in")));
        !why.empty())
      return aside(why, parts);
  }
  if (kind == UnitKind::torque || kind == UnitKind::force) {
    if (const std::string* word = firstIn(parts.words, loadWords))
      return aside("\"" + *word + "\" is not what the motor gives", parts);
  }
  if (kind == UnitKind::temperature) {
    if (const std::string* word = firstIn(parts.words, driverWords))
      return aside("is the temperature of the " + *word + ", not of the winding", parts);
  }
  const bool moves = kind == UnitKind::angle || kind == UnitKind::angularVelocity || kind == UnitKind::torque ||
                     kind == UnitKind::length || kind == UnitKind::linearVelocity;
  if (moves && isIn(parts.words, "input")) reference = true;  // what a controller is given
  const std::string to = contractName(kind, reference);
  if (to.empty()) return aside("is a reference, not what was measured", parts);
  const bool q = isIn(parts.words, "q") || isIn(parts.words, "iq");
  const bool command = reference && to.find("reference") == std::string::npos;
  int rank = (parts.unit == nullptr ? 1 : 0) + (found.word->weak ? 2 : 0) + (command ? 4 : 0);
  if (kind == UnitKind::current && !q) ++rank;
  if (kind == UnitKind::time && unknownBefore > 0) rank += 2;  // "loop_time" after "time"
  return taken(parts, to, rank);
}

}  // namespace breakaway
