#include "recording/column_meaning.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <utility>
#include <vector>

namespace breakaway {

namespace {

enum class Kind {
  time,
  angle,
  length,
  angularVelocity,
  linearVelocity,
  current,
  voltage,
  torque,
  force,
  temperature,
  ratio
};

struct Unit {
  const char* name;
  Kind kind;
  double scale;
  double offset = 0.0;
};

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double degree = turn / 360.0;

constexpr auto units = std::to_array<Unit>({
    {"s", Kind::time, 1},
    {"sec", Kind::time, 1},
    {"seconds", Kind::time, 1},
    {"sekunden", Kind::time, 1},
    {"ms", Kind::time, 1e-3},
    {"msec", Kind::time, 1e-3},
    {"millis", Kind::time, 1e-3},
    {"milliseconds", Kind::time, 1e-3},
    {"us", Kind::time, 1e-6},
    {"usec", Kind::time, 1e-6},
    {"micros", Kind::time, 1e-6},
    {"microseconds", Kind::time, 1e-6},
    {"ns", Kind::time, 1e-9},
    {"min", Kind::time, 60},
    {"rad", Kind::angle, 1},
    {"radians", Kind::angle, 1},
    {"mrad", Kind::angle, 1e-3},
    {"deg", Kind::angle, degree},
    {"degree", Kind::angle, degree},
    {"degrees", Kind::angle, degree},
    {"grad", Kind::angle, degree},
    {"rev", Kind::angle, turn},
    {"revs", Kind::angle, turn},
    {"turn", Kind::angle, turn},
    {"turns", Kind::angle, turn},
    {"m", Kind::length, 1},
    {"cm", Kind::length, 1e-2},
    {"mm", Kind::length, 1e-3},
    {"um", Kind::length, 1e-6},
    {"rad_per_s", Kind::angularVelocity, 1},
    {"rads", Kind::angularVelocity, 1},
    {"rad_per_sec", Kind::angularVelocity, 1},
    {"deg_per_s", Kind::angularVelocity, degree},
    {"deg_per_sec", Kind::angularVelocity, degree},
    {"dps", Kind::angularVelocity, degree},
    {"rpm", Kind::angularVelocity, turn / 60},
    {"1_per_min", Kind::angularVelocity, turn / 60},
    {"u_per_min", Kind::angularVelocity, turn / 60},
    {"rev_per_min", Kind::angularVelocity, turn / 60},
    {"r_per_min", Kind::angularVelocity, turn / 60},
    {"rev_per_s", Kind::angularVelocity, turn},
    {"turn_per_s", Kind::angularVelocity, turn},
    {"turns_per_s", Kind::angularVelocity, turn},
    {"rps", Kind::angularVelocity, turn},
    {"m_per_s", Kind::linearVelocity, 1},
    {"mm_per_s", Kind::linearVelocity, 1e-3},
    {"a", Kind::current, 1},
    {"amp", Kind::current, 1},
    {"amps", Kind::current, 1},
    {"ampere", Kind::current, 1},
    {"ma", Kind::current, 1e-3},
    {"v", Kind::voltage, 1},
    {"volt", Kind::voltage, 1},
    {"volts", Kind::voltage, 1},
    {"mv", Kind::voltage, 1e-3},
    {"nm", Kind::torque, 1},
    {"n_m", Kind::torque, 1},
    {"mnm", Kind::torque, 1e-3},
    {"ncm", Kind::torque, 1e-2},
    {"n", Kind::force, 1},
    {"newton", Kind::force, 1},
    {"kn", Kind::force, 1e3},
    {"degc", Kind::temperature, 1},
    {"c", Kind::temperature, 1},
    {"celsius", Kind::temperature, 1},
    {"k", Kind::temperature, 1, -273.15},
    {"percent", Kind::ratio, 1e-2},
    {"%", Kind::ratio, 1e-2},
    {"prozent", Kind::ratio, 1e-2},
    {"1", Kind::ratio, 1},
});

struct Quantity {
  const char* word;
  Kind kind;
  const char *name, *linearName;  ///< contract names; the second where the unit is one of length
  const char* reference;          ///< the name of its reference, or nullptr
  const char* linearReference;
};

constexpr Quantity timeIs(const char* word) {
  return {word, Kind::time, "time_s", nullptr, nullptr, nullptr};
}
constexpr Quantity positionIs(const char* word) {
  return {word, Kind::angle, "angle_rad", "position_m", "angle_reference_rad", "position_reference_m"};
}
constexpr Quantity velocityIs(const char* word) {
  return {word,
          Kind::angularVelocity,
          "velocity_rad_per_s",
          "velocity_m_per_s",
          "velocity_reference_rad_per_s",
          "velocity_reference_m_per_s"};
}
constexpr Quantity plain(const char* word, Kind kind, const char* name, const char* reference = nullptr) {
  return {word, kind, name, nullptr, reference, nullptr};
}

/// In order: the first word that a name has decides ("supply voltage" is a supply, "current position" a position).
constexpr auto quantities = std::to_array<Quantity>({
    timeIs("time"),
    timeIs("t"),
    timeIs("timestamp"),
    timeIs("zeit"),
    timeIs("zeitstempel"),
    timeIs("elapsed"),
    timeIs("uptime"),
    velocityIs("velocity"),
    velocityIs("vel"),
    velocityIs("speed"),
    velocityIs("omega"),
    velocityIs("w"),
    velocityIs("drehzahl"),
    velocityIs("geschwindigkeit"),
    velocityIs("rpm"),
    positionIs("position"),
    positionIs("pos"),
    positionIs("angle"),
    positionIs("theta"),
    positionIs("th"),
    positionIs("phi"),
    positionIs("q"),
    positionIs("winkel"),
    plain("torque", Kind::torque, "torque_Nm"),
    plain("tau", Kind::torque, "torque_Nm"),
    plain("drehmoment", Kind::torque, "torque_Nm"),
    plain("moment", Kind::torque, "torque_Nm"),
    plain("force", Kind::force, "force_N"),
    plain("kraft", Kind::force, "force_N"),
    plain("f", Kind::force, "force_N"),
    plain("temperature", Kind::temperature, "temperature_degC"),
    plain("temp", Kind::temperature, "temperature_degC"),
    plain("temperatur", Kind::temperature, "temperature_degC"),
    plain("supply", Kind::voltage, "supply_V"),
    plain("vbus", Kind::voltage, "supply_V"),
    plain("bus", Kind::voltage, "supply_V"),
    plain("vdc", Kind::voltage, "supply_V"),
    plain("battery", Kind::voltage, "supply_V"),
    plain("batt", Kind::voltage, "supply_V"),
    plain("vin", Kind::voltage, "supply_V"),
    plain("input", Kind::voltage, "supply_V"),
    plain("duty", Kind::ratio, "duty"),
    plain("dutycycle", Kind::ratio, "duty"),
    plain("pwm", Kind::ratio, "duty"),
    plain("voltage", Kind::voltage, "voltage_V"),
    plain("volt", Kind::voltage, "voltage_V"),
    plain("volts", Kind::voltage, "voltage_V"),
    plain("spannung", Kind::voltage, "voltage_V"),
    plain("u", Kind::voltage, "voltage_V"),
    plain("uq", Kind::voltage, "voltage_V"),
    plain("vm", Kind::voltage, "voltage_V"),
    plain("vq", Kind::voltage, "voltage_V"),
    plain("current", Kind::current, "current_A", "current_reference_A"),
    plain("curr", Kind::current, "current_A", "current_reference_A"),
    plain("cur", Kind::current, "current_A", "current_reference_A"),
    plain("amps", Kind::current, "current_A", "current_reference_A"),
    plain("i", Kind::current, "current_A", "current_reference_A"),
    plain("iq", Kind::current, "current_A", "current_reference_A"),
    plain("strom", Kind::current, "current_A", "current_reference_A"),
});

constexpr auto referenceWords =
    std::to_array<const char*>({"ref", "reference", "target", "goal", "setpoint", "sp", "cmd", "command", "commanded",
                                "desired", "des", "demand", "soll", "set", "sollwert"});
constexpr auto decorations = std::to_array<const char*>(
    {"actual", "act",   "measured", "meas",    "present",  "motor", "shaft", "rotor", "encoder",  "enc", "joint",
     "axis",   "value", "ist",      "istwert", "feedback", "fb",    "stamp", "cycle", "estimate", "est", "voltage"});

using Words = std::vector<std::string>;

/// Lower-case words of a name; "/" is the word "per", signs of units are spelt out.
Words wordsOf(std::string_view text, bool splitCamel) {
  Words words;
  std::string word;
  const auto close = [&] {
    if (!word.empty()) words.push_back(std::exchange(word, {}));
  };
  for (size_t k = 0; k < text.size(); ++k) {
    const std::string_view rest = text.substr(k);
    const auto c = static_cast<unsigned char>(text[k]);
    if (rest.starts_with("°")) {
      word += "deg";
      ++k;
    } else if (rest.starts_with("µ") || rest.starts_with("μ")) {
      word += 'u';
      ++k;
    } else if (rest.starts_with("·")) {
      ++k;
    } else if (c == '*') {
    } else if (c == '/') {
      close();
      words.emplace_back("per");
    } else if (std::isalnum(c) != 0 || c == '%' || c >= 0x80U) {
      const bool hump = splitCamel && std::isupper(c) != 0 && !word.empty() &&
                        std::islower(static_cast<unsigned char>(word.back())) != 0 && k > 0 &&
                        std::islower(static_cast<unsigned char>(text[k - 1])) != 0;
      if (hump) close();
      word += static_cast<char>(std::tolower(c));
    } else {
      close();
    }
  }
  close();
  return words;
}

std::string joined(const Words& words, size_t from) {
  std::string text;
  for (size_t k = from; k < words.size(); ++k) text += (k == from ? "" : "_") + words[k];
  return text;
}

const Unit* unitNamed(std::string_view name) {
  const auto it = std::find_if(units.begin(), units.end(), [name](const Unit& unit) { return name == unit.name; });
  return it == units.end() ? nullptr : &*it;
}

template <typename List>
bool contains(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

struct NameParts {
  Words words;
  const Unit* unit = nullptr;
  bool unknownUnit = false;  ///< a unit stands there, but none that is understood
};

NameParts partsOf(std::string_view name) {
  NameParts parts;
  const size_t open = name.find_last_of("[(");
  const size_t in = name.find(" in ");
  if (open != std::string_view::npos && open > 0 && (name.back() == ']' || name.back() == ')')) {
    const std::string unit = joined(wordsOf(name.substr(open), false), 0);
    parts.unit = unitNamed(unit);
    parts.unknownUnit = !unit.empty() && parts.unit == nullptr;
    parts.words = wordsOf(name.substr(0, open), true);
    return parts;
  }
  if (in != std::string_view::npos) {
    parts.unit = unitNamed(joined(wordsOf(name.substr(in + 4), false), 0));
    parts.unknownUnit = parts.unit == nullptr;
    parts.words = wordsOf(name.substr(0, in), true);
    return parts;
  }
  const Words plainWords = wordsOf(name, false);
  for (size_t from = 1; from < plainWords.size() && parts.unit == nullptr; ++from) {
    parts.unit = unitNamed(joined(plainWords, from));
    if (parts.unit == nullptr) continue;
    parts.words.assign(plainWords.begin(), plainWords.begin() + static_cast<std::ptrdiff_t>(from));
    if (parts.words.size() > 1 && parts.words.back() == "per") parts.words.pop_back();  // "t / ms"
    parts.words = wordsOf(joined(parts.words, 0), true);
  }
  if (parts.unit == nullptr) parts.words = wordsOf(name, true);
  return parts;
}

bool fits(const Unit& unit, const Quantity& quantity) {
  if (unit.kind == quantity.kind) return true;
  if (quantity.linearName == nullptr) return false;
  return quantity.kind == Kind::angle ? unit.kind == Kind::length : unit.kind == Kind::linearVelocity;
}

}  // namespace

bool isUnit(std::string_view text) {
  return unitNamed(joined(wordsOf(text, false), 0)) != nullptr;
}

std::optional<Meaning> meaningOf(std::string_view name) {
  if (name == "index" || name == "enabled") return Meaning{std::string(name), 1.0, 0.0, true};
  if (name == "torque_enable" || name == "enable") return Meaning{"enabled", 1.0, 0.0, true};
  for (const char* rpm : {"rpm", "RPM"}) {
    if (name == rpm) return Meaning{"velocity_rad_per_s", turn / 60, 0.0, true};
  }
  const NameParts parts = partsOf(name);
  if (parts.unknownUnit) return std::nullopt;
  const auto known = [&parts](const Quantity& one) { return contains(parts.words, one.word); };
  const auto it = std::find_if(quantities.begin(), quantities.end(), known);
  if (it == quantities.end() || (parts.unit != nullptr && !fits(*parts.unit, *it))) return std::nullopt;
  bool reference = false;
  for (const std::string& word : parts.words) {
    if (contains(referenceWords, word)) {
      reference = true;
    } else if (word != it->word && !contains(decorations, word) && word != "current") {
      return std::nullopt;  // a word that is not understood may change everything ("velocity error")
    }
  }
  if (std::string_view(it->word) == "input" && parts.unit == nullptr) return std::nullopt;
  const bool linear =
      parts.unit != nullptr && (parts.unit->kind == Kind::length || parts.unit->kind == Kind::linearVelocity);
  const char* to = reference ? (linear ? it->linearReference : it->reference) : (linear ? it->linearName : it->name);
  if (to == nullptr) return std::nullopt;
  if (parts.unit == nullptr) return Meaning{to, 1.0, 0.0, false};
  return Meaning{to, parts.unit->scale, parts.unit->offset, true};
}

}  // namespace breakaway
