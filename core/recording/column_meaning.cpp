#include "recording/column_meaning.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "recording/columns.h"

namespace breakaway {

namespace {

struct Unit {
  const char* name;
  const char* si;  ///< the unit of the columns that it converts to
  double scale;
  double offset = 0.0;
};

constexpr double degree = turn_rad / 360.0;

constexpr auto units = std::to_array<Unit>({
    {"s", "s", 1},
    {"sec", "s", 1},
    {"seconds", "s", 1},
    {"sekunden", "s", 1},
    {"ms", "s", 1e-3},
    {"msec", "s", 1e-3},
    {"millis", "s", 1e-3},
    {"milliseconds", "s", 1e-3},
    {"us", "s", 1e-6},
    {"usec", "s", 1e-6},
    {"micros", "s", 1e-6},
    {"microseconds", "s", 1e-6},
    {"ns", "s", 1e-9},
    {"min", "s", 60},
    {"rad", "rad", 1},
    {"radians", "rad", 1},
    {"mrad", "rad", 1e-3},
    {"deg", "rad", degree},
    {"degree", "rad", degree},
    {"degrees", "rad", degree},
    {"grad", "rad", degree},
    {"rev", "rad", turn_rad},
    {"revs", "rad", turn_rad},
    {"turn", "rad", turn_rad},
    {"turns", "rad", turn_rad},
    {"m", "m", 1},
    {"cm", "m", 1e-2},
    {"mm", "m", 1e-3},
    {"um", "m", 1e-6},
    {"rad_per_s", "rad/s", 1},
    {"rads", "rad/s", 1},
    {"rad_per_sec", "rad/s", 1},
    {"deg_per_s", "rad/s", degree},
    {"deg_per_sec", "rad/s", degree},
    {"dps", "rad/s", degree},
    {"rpm", "rad/s", turn_rad / 60},
    {"1_per_min", "rad/s", turn_rad / 60},
    {"u_per_min", "rad/s", turn_rad / 60},
    {"rev_per_min", "rad/s", turn_rad / 60},
    {"r_per_min", "rad/s", turn_rad / 60},
    {"rev_per_s", "rad/s", turn_rad},
    {"turn_per_s", "rad/s", turn_rad},
    {"turns_per_s", "rad/s", turn_rad},
    {"rps", "rad/s", turn_rad},
    {"m_per_s", "m/s", 1},
    {"mm_per_s", "m/s", 1e-3},
    {"a", "A", 1},
    {"amp", "A", 1},
    {"amps", "A", 1},
    {"ampere", "A", 1},
    {"ma", "A", 1e-3},
    {"v", "V", 1},
    {"volt", "V", 1},
    {"volts", "V", 1},
    {"mv", "V", 1e-3},
    {"nm", "Nm", 1},
    {"n_m", "Nm", 1},
    {"mnm", "Nm", 1e-3},
    {"ncm", "Nm", 1e-2},
    {"n", "N", 1},
    {"newton", "N", 1},
    {"kn", "N", 1e3},
    {"degc", "°C", 1},
    {"c", "°C", 1},
    {"celsius", "°C", 1},
    {"k", "°C", 1, -273.15},
    {"percent", "1", 1e-2},
    {"%", "1", 1e-2},
    {"prozent", "1", 1e-2},
    {"1", "1", 1},
});

struct Word {
  const char* text;
  Quantity quantity;
  Axis axis = Axis::rotary;  ///< where no unit tells it
};

/// In order: the first word that a name has decides ("supply voltage" is a supply, "current position" a position).
constexpr auto quantityWords = std::to_array<Word>({
    {"time", Quantity::time},
    {"t", Quantity::time},
    {"timestamp", Quantity::time},
    {"zeit", Quantity::time},
    {"zeitstempel", Quantity::time},
    {"elapsed", Quantity::time},
    {"uptime", Quantity::time},
    {"velocity", Quantity::velocity},
    {"vel", Quantity::velocity},
    {"speed", Quantity::velocity},
    {"omega", Quantity::velocity},
    {"w", Quantity::velocity},
    {"drehzahl", Quantity::velocity},
    {"geschwindigkeit", Quantity::velocity},
    {"rpm", Quantity::velocity},
    {"position", Quantity::position},
    {"pos", Quantity::position},
    {"angle", Quantity::position},
    {"theta", Quantity::position},
    {"th", Quantity::position},
    {"phi", Quantity::position},
    {"q", Quantity::position},
    {"winkel", Quantity::position},
    {"torque", Quantity::torque},
    {"tau", Quantity::torque},
    {"drehmoment", Quantity::torque},
    {"moment", Quantity::torque},
    {"force", Quantity::torque, Axis::linear},
    {"kraft", Quantity::torque, Axis::linear},
    {"f", Quantity::torque, Axis::linear},
    {"temperature", Quantity::temperature},
    {"temp", Quantity::temperature},
    {"temperatur", Quantity::temperature},
    {"supply", Quantity::supply},
    {"vbus", Quantity::supply},
    {"bus", Quantity::supply},
    {"vdc", Quantity::supply},
    {"battery", Quantity::supply},
    {"batt", Quantity::supply},
    {"vin", Quantity::supply},
    {"input", Quantity::supply},
    {"duty", Quantity::duty},
    {"dutycycle", Quantity::duty},
    {"pwm", Quantity::duty},
    {"voltage", Quantity::voltage},
    {"volt", Quantity::voltage},
    {"volts", Quantity::voltage},
    {"spannung", Quantity::voltage},
    {"u", Quantity::voltage},
    {"uq", Quantity::voltage},
    {"vm", Quantity::voltage},
    {"vq", Quantity::voltage},
    {"current", Quantity::current},
    {"curr", Quantity::current},
    {"cur", Quantity::current},
    {"amps", Quantity::current},
    {"i", Quantity::current},
    {"iq", Quantity::current},
    {"strom", Quantity::current},
});

std::optional<Quantity> referenceOf(Quantity quantity) {
  switch (quantity) {
    case Quantity::position:
      return Quantity::positionReference;
    case Quantity::velocity:
      return Quantity::velocityReference;
    case Quantity::current:
      return Quantity::currentReference;
    default:
      return std::nullopt;
  }
}

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

}  // namespace

bool isUnit(std::string_view text) {
  return unitNamed(joined(wordsOf(text, false), 0)) != nullptr;
}

std::optional<Meaning> meaningOf(std::string_view name) {
  if (columnNamed(name) != nullptr) return Meaning{std::string(name), 1.0, 0.0, true};
  if (name == "torque_enable" || name == "enable") return Meaning{"enabled", 1.0, 0.0, true};
  for (const char* rpm : {"rpm", "RPM"}) {
    if (name == rpm) return Meaning{"velocity_rad_per_s", turn_rad / 60, 0.0, true};
  }
  const NameParts parts = partsOf(name);
  if (parts.unknownUnit) return std::nullopt;
  const auto known = [&parts](const Word& one) { return contains(parts.words, one.text); };
  const auto it = std::find_if(quantityWords.begin(), quantityWords.end(), known);
  if (it == quantityWords.end()) return std::nullopt;
  bool reference = false;
  for (const std::string& word : parts.words) {
    if (contains(referenceWords, word)) {
      reference = true;
    } else if (word != it->text && !contains(decorations, word) && word != "current") {
      return std::nullopt;  // a word that is not understood may change everything ("velocity error")
    }
  }
  if (std::string_view(it->text) == "input" && parts.unit == nullptr) return std::nullopt;
  const auto quantity = reference ? referenceOf(it->quantity) : it->quantity;
  if (!quantity) return std::nullopt;
  if (parts.unit == nullptr) return Meaning{columnName(*quantity, it->axis), 1.0, 0.0, false};
  const Column* column = columnIn(parts.unit->si, *quantity);
  if (column == nullptr) return std::nullopt;
  return Meaning{column->name, parts.unit->scale, parts.unit->offset, true};
}

}  // namespace breakaway
