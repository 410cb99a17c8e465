#include "recording/import/name_parts.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "recording/import/name_words.h"
#include "recording/import/quantity_words.h"

namespace breakaway {

namespace {

/// A unit with a number before it: "0.1°", "x0.01 A", "10mA".
struct MultipliedUnit {
  const Unit* unit = nullptr;
  double factor = 1.0;
  bool decimal = false;  ///< a power of ten, or with a decimal point: no index of an axis
};

MultipliedUnit multipliedUnit(std::string_view text) {
  for (const std::string_view mark : {"x", "*", "×"}) {
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
  }
  MultipliedUnit found;
  const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), found.factor);
  if (code != std::errc() || !(found.factor > 0.0) || !std::isfinite(found.factor)) return {};
  const std::string_view number = text.substr(0, static_cast<size_t>(stop - text.data()));
  text.remove_prefix(number.size());
  while (!text.empty() && (text.front() == ' ' || text.front() == '*')) text.remove_prefix(1);
  found.unit = unitNamed(text);
  found.decimal = number.find('.') != std::string_view::npos ||
                  (number.front() == '1' && number.find_first_not_of('0', 1) == std::string_view::npos);
  return found;
}

void setUnit(std::string_view text, NameParts& parts) {
  parts.unitText = std::string(text);
  parts.unit = unitNamed(text);
  if (parts.unit != nullptr) return;
  const MultipliedUnit multiplied = multipliedUnit(text);
  parts.unit = multiplied.unit;
  parts.factor = multiplied.unit == nullptr ? 1.0 : multiplied.factor;
  parts.unknownUnit = parts.unit == nullptr;
  const std::string_view before = unitBeforeQuantity(text);
  if (!parts.unknownUnit || before.empty()) return;
  parts.unit = unitNamed(before);
  parts.unitText = std::string(before);
  parts.unknownUnit = false;
}

/// "(None)", "-": the file's way to say that it has none.
bool saysNoUnit(std::string_view unit) {
  const Words words = wordsOf(unit, false);
  static constexpr auto nones = std::to_array<std::string_view>({"none", "na", "n_a", "null", "unitless", "nounit"});
  return words.empty() ? unit.find_first_not_of("-–—?.[]() ") == std::string_view::npos
                       : words.size() == 1 && isIn(nones, words[0]);
}

/// Takes a number with a unit off the end of the name: "current_10mA".
std::string takeMultipliedUnit(const std::string& text, NameParts& parts) {
  const size_t from = text.find_last_of(" _");
  if (from == std::string::npos || from + 1 >= text.size() || !isNumber(text.substr(from + 1, 1))) return text;
  const MultipliedUnit multiplied = multipliedUnit(std::string_view(text).substr(from + 1));
  if (multiplied.unit == nullptr) return text;
  parts.unitText = text.substr(from + 1);
  parts.unknownUnit = !multiplied.decimal;
  if (multiplied.decimal) {
    parts.unit = multiplied.unit;
    parts.factor = multiplied.factor;
  }
  return text.substr(0, from);
}

/// Where the bracket at `open` is closed; brackets of the other kind may stand between.
size_t closeOf(std::string_view name, size_t open) {
  const char mark = name[open], end = mark == '(' ? ')' : ']';
  size_t depth = 0;
  for (size_t k = open; k < name.size(); ++k) {
    if (name[k] == mark) ++depth;
    if (name[k] == end && --depth == 0) return k;
  }
  return std::string_view::npos;
}

/// "Position feedback" of "[Axis1] Position feedback".
std::string withoutInnerBrackets(std::string_view inner) {
  std::string text;
  for (size_t open = inner.find_first_of("[("); open != std::string_view::npos; open = inner.find_first_of("[(")) {
    const size_t close = closeOf(inner, open);
    if (close == std::string_view::npos) break;
    text += inner.substr(0, open);
    inner.remove_prefix(close + 1);
  }
  return text + std::string(inner);
}

/// "Winding_A", "phase b".
bool namesPhase(const Words& words) {
  return words.size() == 2 && (words[0] == "winding" || words[0] == "phase") && words[1].size() == 1;
}

/// "J1", "axis 2", "left".
bool namesAxis(const Words& words) {
  if (words.size() == 2) return (words[0] == "axis" || isIn(jointWords, words[0])) && isNumber(words[1]);
  if (words.size() != 1) return false;
  const bool numbered = words[0].size() > 1 && words[0].size() < 4 && isNumber(words[0].substr(1)) &&
                        std::string_view("ajmx").find(words[0][0]) != std::string_view::npos;
  return numbered || words[0] == "left" || words[0] == "right";
}

/// "V" of "V(speed)": a circuit's node, which is in volts whatever it is called; nothing for "V (measured)".
std::string_view circuitUnit(std::string_view before, const Words& inner) {
  const bool other = std::any_of(inner.begin(), inner.end(), [](const std::string& word) {
    const Word* quantity = quantityNamed(word);
    return quantity != nullptr && quantity->kind != UnitKind::voltage && quantity->kind != UnitKind::current;
  });
  if (!other || before.size() != 1) return {};
  return before == "V" ? "V" : before == "I" ? "A" : "";
}

/// Takes bracketed units and indices off the name.
std::string takeBrackets(std::string_view name, NameParts& parts) {
  std::string rest;
  while (!name.empty()) {
    const size_t open = name.find_first_of("[(");
    const size_t close = open == std::string_view::npos ? open : closeOf(name, open);
    if (close == std::string_view::npos || (open == 0 && close + 1 == name.size() && rest.empty())) break;
    rest += name.substr(0, open);
    std::string inner = withoutInnerBrackets(name.substr(open + 1, close - open - 1));
    if (inner == "in") inner = "inch";
    name.remove_prefix(close + 1);
    Words words = wordsOf(inner, true);
    partCompounds(words);
    const bool plainWords = std::all_of(words.begin(), words.end(), [](const std::string& word) {
      return isIn(decorations, word) || isIn(referenceWords, word) || quantityNamed(word) != nullptr;
    });
    if (const Unit* unit = unitNamed(inner); unit != nullptr && !isNumber(inner)) {
      parts.unit = unit;
      parts.unitText = inner;
      parts.unknownUnit = false;
    } else if (const std::string_view circuits = circuitUnit(rest, words); !circuits.empty()) {
      setUnit(circuits, parts);
      rest = inner;
    } else if (isNumber(inner) || namesAxis(words) || namesPhase(words) || (plainWords && !words.empty())) {
      rest += " " + inner + " ";
    } else if (!words.empty() &&
               (name.empty() || std::string_view(":./").find(name.front()) == std::string_view::npos)) {
      setUnit(inner, parts);  // but "knee[Actpack]:position" goes on: it says which of the kind
    }
  }
  return rest + std::string(name);
}

/// The side that such a word names, in whichever language; empty for others.
std::string_view sideOf(std::string_view word) {
  static constexpr auto lefts = std::to_array<std::string_view>(
      {"left", "l", "links", "gauche", "esq", "esquerda", "esquerdo", "izq", "izquierda", "izquierdo", "sinistra"});
  static constexpr auto rights = std::to_array<std::string_view>(
      {"right", "r", "rechts", "droite", "droit", "direita", "direito", "derecha", "derecho", "destra"});
  return isIn(lefts, word) ? "left" : isIn(rights, word) ? "right" : "";
}

bool isSide(std::string_view word) {
  return !sideOf(word).empty();
}

/// Nothing follows, or only what says that it is a reference.
bool onlyReferenceFollows(const Words& words, size_t k) {
  return std::all_of(words.begin() + static_cast<std::ptrdiff_t>(k) + 1, words.end(),
                     [](const std::string& word) { return isIn(referenceWords, word); });
}

/// "rpm_l" is of the axis of "left_amps".
std::string sideNamed(std::string_view word) {
  return std::string(sideOf(word));
}

/// A number behind such a word is a measuring amplifier's channel, and no axis.
bool isChannel(std::string_view word) {
  static constexpr auto words =
      std::to_array<std::string_view>({"ch", "chan", "channel", "kanal", "canal", "voie", "ai", "chn"});
  return isIn(words, word);
}

/// "2", "P1": a channel's.
bool isChannelNumber(std::string_view word) {
  return isNumber(word) || (word.size() > 1 && word.size() < 4 && isNumber(word.substr(1)));
}

/// "Kanal 2 Drehzahl", "ch3_torque": without the channel; where nothing else stands, as it is.
void dropChannel(Words& words) {
  for (size_t k = 0; k + 1 < words.size(); ++k) {
    if (!isChannel(words[k]) || !isChannelNumber(words[k + 1]) || words.size() < 3) continue;
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(k), words.begin() + static_cast<std::ptrdiff_t>(k) + 2);
  }
}

/// "v1" in °/s is the speed of axis 1, "m2" in Nm a torque of axis 2.
bool isQuantityOf(const std::string& letterAndNumber, const Unit* unit) {
  const std::string_view letters = unit == nullptr                           ? ""
                                   : unit->kind == UnitKind::angularVelocity ? "vwn"
                                   : unit->kind == UnitKind::torque          ? "tm"
                                                                             : "";
  return letters.find(letterAndNumber[0]) != std::string_view::npos;
}

void takeGroup(Words& words, std::string& group, const Unit* unit) {
  Words kept;
  const bool model = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return isNumber(word) && word.size() > 2;  // "trs605-5": a sensor's name, not an axis
  });
  const auto own =
      std::count_if(words.begin(), words.end(), [](const std::string& word) { return !isIn(referenceWords, word); });
  bool indexed = false;  // a drive's parameter stands before
  for (size_t k = 0; k < words.size(); ++k) {
    std::string& word = words[k];
    const size_t digit = word.find_first_of("0123456789");
    const bool letterAndNumber = digit == 1 && isNumber(word.substr(1));
    // A drive's "r63", "I80"; not a tenth motor or joint.
    const bool drives =
        word[0] == 'r' || word[0] == 'p' ||
        (k == 0 && words.size() > 1 && std::string_view("majsxyz").find(word[0]) == std::string_view::npos);
    const bool parameter = letterAndNumber && word.size() > 2 && drives;
    if (std::exchange(indexed, parameter) && isNumber(word) && word.size() < 3) continue;              // "r63[0]"
    const bool axis = letterAndNumber && !parameter;                                                   // "m0"
    const bool side = isSide(word) && (word.size() > 1 || (k > 0 && onlyReferenceFollows(words, k)));  // "rpm_l_ref"
    const bool joint = axis && (word[0] == 'j' || word[0] == 'a');  // "tau_J1" is of the axis of "dq1"
    const bool angle = axis && word[0] == 'q' && own == 1;          // "q1", "q1_ref"
    const bool quantity = axis && own == 1 && isQuantityOf(word, unit);
    if (!model && (isNumber(word) || axis || side))
      group += (group.empty() ? "" : ".") + (joint || angle || quantity ? word.substr(1)
                                             : side                     ? sideNamed(word)
                                                                        : word);
    if (angle) kept.emplace_back("q");
    if (quantity) kept.push_back(word.substr(0, 1));
    if (!isNumber(word) && !axis && !side && !parameter) kept.push_back(std::move(word));
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
    const bool moves = word->kind == UnitKind::angle || word->kind == UnitKind::angularVelocity;
    const bool sure = !word->weak || word->text.starts_with("enc");                      // "q_A" is a current
    const bool motor = last == "a" && sure && (moves || word->kind == UnitKind::ratio);  // "encoderA", "pwmA"
    return unit.kind != word->kind && !length && (last == "m" || last == "c" || motor);
  }
  return false;
}

/// The text up to where its word `count` begins.
std::string_view firstWords(std::string_view text, size_t count) {
  size_t end = text.size();
  while (end > 0 && wordsOf(text.substr(0, end), false).size() > count) --end;
  return text.substr(0, end);
}

/// A unit before words that say how it was come by: "rpm_filtered", "pos_deg_target". In short ones letters mean too
/// much.
bool takeUnitBeforeWords(const std::string& text, NameParts& parts) {
  Words plain = wordsOf(text, false);
  if (plain.size() == 1) plain = wordsOf(text, true);  // "ticksL"
  size_t end = plain.size();
  const auto changesNothing = [](const std::string& word) {
    const bool told = (word.size() > 2 && isIn(decorations, word)) || isIn(referenceWords, word);    // "rpm_sp"
    return told || isSide(word) || isNumber(word) || (word.size() > 1 && isNumber(word.substr(1)));  // "m1"
  };
  while (end > 0 && changesNothing(plain[end - 1])) --end;
  if (end == 0 || end == plain.size()) return false;
  const Words head(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(end));
  for (size_t from = 0; from < head.size(); ++from) {
    const Unit* unit = unitOfWords(head, from);
    const bool longEnough = head[from].size() > 2 || (from > 0 && head[from].size() > 1 && head[from] != "in");
    if (unit == nullptr || !longEnough || head[from] == "min" || quantityNamed(head[from]) != nullptr) continue;
    parts.unit = unit;
    parts.unitFirst = from == 0;
    for (size_t k = from; k < end; ++k) parts.unitText += (k == from ? "" : "_") + head[k];
    parts.words = wordsOf(firstWords(text, from), true);
    parts.words.insert(parts.words.end(), plain.begin() + static_cast<std::ptrdiff_t>(end), plain.end());
    if (parts.unitFirst && !parts.words.empty() && isSide(parts.words[0]) && onlyReferenceFollows(parts.words, 0))
      parts.words[0] = sideNamed(parts.words[0]);
    return true;
  }
  return false;
}

/// A unit as the last words; the longest that is one.
void takeUnitWords(const std::string& text, NameParts& parts) {
  static constexpr auto times = std::to_array<std::string_view>({"s", "sec", "ms", "min"});
  Words plain = wordsOf(text, false);
  std::string axis;  // "Speed RPM 2"
  while (!plain.empty() && isNumber(plain.back()) && plain.size() > 1) {
    if (plain.size() > 2 && unitOfWords(plain, plain.size() - 2) != nullptr) break;  // "min 1"
    axis = isIn(times, plain[plain.size() - 2]) ? std::string() : plain.back();      // "rad s 1" is a power
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
      if (!axis.empty() && !camel) parts.words.push_back(axis);
      return;
    }
  }
  if (!takeUnitBeforeWords(text, parts)) parts.words = wordsOf(text, true);
}

/// "PWM Percent" in %: the unit stands in the name, too.
void dropUnitTwice(NameParts& parts) {
  if (parts.unit == nullptr) return;
  for (size_t from = 1; from < parts.words.size(); ++from) {
    const Unit* named = unitOfWords(parts.words, from);
    const bool same = named != nullptr && named->kind == parts.unit->kind && named->scale == parts.unit->scale &&
                      named->needs == parts.unit->needs;
    if (!same || parts.words[from].size() < 2 || quantityNamed(parts.words[from]) != nullptr) continue;
    parts.words.resize(from);
  }
}

/// "3 Velocity (RPM)" of "SPARK MAX 3: Velocity (RPM)": what stands before is a device's name, whatever its words mean.
std::string withoutDevice(std::string_view name) {
  // "01.07 Motor current", "16-14 Motor current": a drive's number of it.
  const size_t dot = name.find_first_of(".-"), blank = name.find(' ');
  const bool parameter = blank != std::string_view::npos && dot < blank && isNumber(name.substr(0, dot)) &&
                         isNumber(name.substr(dot + 1, blank - dot - 1));
  if (parameter) name.remove_prefix(blank + 1);
  const size_t colon = name.find(": ");
  if (colon == std::string_view::npos || colon == 0) return std::string(name);
  const Words device = wordsOf(name.substr(0, colon), false);
  if (device.size() < 2 || !isNumber(device.back())) return std::string(name);
  const Words behind = wordsOf(name.substr(colon + 2), true);
  const bool quantity =
      std::any_of(behind.begin(), behind.end(), [](const std::string& word) { return quantityNamed(word) != nullptr; });
  return quantity ? device.back() + " " + std::string(name.substr(colon + 2)) : std::string(name);
}

}  // namespace

namespace {

/// `{axis="1"}` of `motor_speed_rpm{axis="1"}`, as databases of metrics label a series: the values in quotes.
std::string labelsOf(std::string_view& name) {
  const size_t open = name.find('{');
  if (open == std::string_view::npos || open == 0 || name.back() != '}') return {};
  std::string values;
  std::string_view inner = name.substr(open + 1, name.size() - open - 2);
  name = name.substr(0, open);
  for (size_t quote = inner.find('"'); quote != std::string_view::npos; quote = inner.find('"')) {
    inner.remove_prefix(std::min(inner.find_first_not_of('"', quote), inner.size()));  // in tables they stand twice
    const size_t end = std::min(inner.find('"'), inner.size());
    values += (values.empty() ? "" : ".") + lowered(inner.substr(0, end));
    inner.remove_prefix(std::min(inner.find_first_not_of('"', end), inner.size()));
  }
  return values;
}

}  // namespace

std::string_view unitBeforeQuantity(std::string_view text) {
  const size_t open = text.rfind(" (");
  if (open == std::string_view::npos || open == 0 || text.back() != ')') return {};
  const std::string_view inner = text.substr(open + 2, text.size() - open - 3), before = text.substr(0, open);
  const Words words = wordsOf(inner, true);
  const bool counted = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    const Word* quantity = quantityNamed(word);
    return quantity != nullptr && !quantity->weak;
  });
  return counted && !isUnit(inner) && isUnit(before) ? before : std::string_view{};
}

NameParts partsOfName(std::string_view name, std::string_view unit) {
  NameParts parts;
  const std::string labels = labelsOf(name);
  std::string text = withUnitsApart(takeBrackets(withoutDevice(name), parts));
  if (!unit.empty() && !saysNoUnit(unit)) {
    parts.unknownUnit = false;
    parts.factor = 1.0;
    setUnit(unit, parts);
  }
  if (text.size() > 1 && text.front() == '%') text = text.substr(1) + " %";  // "%PWM"
  if (parts.unit == nullptr && !parts.unknownUnit) text = takeMultipliedUnit(text, parts);
  const size_t comma = text.rfind(", ");  // "Скорость, об/мин"
  if (parts.unit == nullptr && !parts.unknownUnit && comma != std::string::npos) {
    const std::string behind = text.substr(comma + 2);
    if (const Unit* named = unitNamed(behind); named != nullptr && !isNumber(behind)) {
      parts.unit = named;
      parts.unitText = behind;
      text.resize(comma);
    }
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
    dropUnitTwice(parts);
  }
  parts.plain = wordsOf(text, false);
  partWords(parts.words);
  dropChannel(parts.words);
  takeGroup(parts.words, parts.group, parts.unit);
  if (!labels.empty()) parts.group += (parts.group.empty() ? "" : ".") + labels;
  std::erase_if(parts.words, [](const std::string& word) { return word == "per"; });
  joinWords(parts.words);
  return parts;
}

bool isMultiplied(std::string_view name) {
  if (const size_t open = name.rfind('[');
      open != std::string_view::npos && name.ends_with("]") && isNumber(name.substr(open + 1, name.size() - open - 2)))
    name = name.substr(0, open);  // "omega_x10[0]"
  // "temp_c10": tenths of a degree.
  const Words words = wordsOf(name, false);
  if (words.size() > 1) {
    const std::string_view last = words.back();
    const size_t digits = last.find_first_of("0123456789");
    const bool tens = digits != std::string_view::npos && digits > 0 && last.size() > digits + 1 &&
                      last[digits] == '1' && last.find_first_not_of('0', digits + 1) == std::string_view::npos;
    if (tens && unitNamed(last.substr(0, digits)) != nullptr) return true;
  }
  const size_t mark = name.find_last_of("*xX");
  if (mark == std::string_view::npos || mark == 0 || mark + 2 >= name.size() || name.substr(mark + 1, 2) != "10")
    return false;
  return name.find_first_not_of('0', mark + 2) == std::string_view::npos &&
         (name[mark] == '*' || std::isalnum(static_cast<unsigned char>(name[mark - 1])) == 0);
}

std::string lowered(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char one) { return one >= 'A' && one <= 'Z' ? static_cast<char>(one | 0x20) : one; });
  return lower;
}

}  // namespace breakaway
