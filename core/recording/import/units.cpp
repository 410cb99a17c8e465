#include "recording/import/units.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "recording/import/unit_table.h"

namespace breakaway {

namespace {

const Unit* exactly(std::string_view name) {
  const auto it = std::find_if(unit_table::units.begin(), unit_table::units.end(),
                               [name](const Unit& unit) { return name == unit.name; });
  return it == unit_table::units.end() ? nullptr : &*it;
}

/// What moves, in the one word that stands in front of "per".
std::string_view oneWord(std::string_view word) {
  static constexpr auto same = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"rads", "rad"},    {"radian", "rad"},  {"radians", "rad"}, {"degs", "deg"},       {"degree", "deg"},
       {"degrees", "deg"}, {"grad", "deg"},    {"revs", "rev"},    {"revolution", "rev"}, {"revolutions", "rev"},
       {"turn", "rev"},    {"turns", "rev"},   {"rot", "rev"},     {"rotation", "rev"},   {"rotations", "rev"},
       {"u", "rev"},       {"r", "rev"},       {"umdr", "rev"},    {"tr", "rev"},         {"giri", "rev"},
       {"obr", "rev"},     {"ot", "rev"},      {"omw", "rev"},     {"toer", "rev"},       {"varv", "rev"},
       {"об", "rev"},      {"dev", "rev"},     {"gradi", "deg"},   {"grados", "deg"},     {"graden", "deg"},
       {"degrés", "deg"},  {"derece", "deg"},  {"град", "deg"},    {"рад", "rad"},        {"counts", "count"},
       {"cnt", "count"},   {"cts", "count"},   {"tick", "count"},  {"steps", "count"},    {"step", "count"},
       {"pulse", "count"}, {"ticks", "count"}, {"inc", "count"},   {"ink", "count"},      {"pulses", "count"},
       {"lsb", "count"},   {"graus", "deg"},   {"độ", "deg"},      {"vòng", "rev"},       {"转", "rev"},
       {"圈", "rev"},      {"回転", "rev"},    {"度", "deg"},      {"弧度", "rad"},       {"meter", "m"},
       {"meters", "m"},    {"metre", "m"},     {"metres", "m"},    {"millimeters", "mm"}, {"in", "inch"},
       {"inches", "inch"}, {"ft", "feet"},     {"foot", "feet"}});
  const auto it = std::find_if(same.begin(), same.end(), [word](const auto& one) { return one.first == word; });
  return it == same.end() ? word : it->second;
}

/// The small letter of a capital one with two bytes of UTF-8: Latin, Greek or Cyrillic.
std::optional<std::string> lowerLetter(std::string_view text) {
  if (text.size() < 2) return std::nullopt;
  const auto lead = static_cast<unsigned char>(text[0]), tail = static_cast<unsigned char>(text[1]);
  if (lead < 0xC3U || lead > 0xD2U || (tail & 0xC0U) != 0x80U) return std::nullopt;
  const unsigned capital = ((lead & 0x1FU) << 6U) | (tail & 0x3FU);
  const auto within = [capital](unsigned first, unsigned last) { return capital >= first && capital <= last; };
  unsigned small = capital;
  if ((within(0xC0U, 0xDEU) && capital != 0xD7U) || within(0x391U, 0x3A9U) || within(0x410U, 0x42FU)) small += 0x20U;
  if (within(0x400U, 0x40FU)) small += 0x50U;
  if (within(0x388U, 0x38AU)) small += 0x25U;
  if (capital == 0x386U) small = 0x3ACU;
  const bool oddIsSmall = within(0x100U, 0x137U) || within(0x14AU, 0x177U) || within(0x490U, 0x491U);
  const bool evenIsSmall = within(0x139U, 0x148U) || within(0x179U, 0x17EU);
  if ((oddIsSmall && capital % 2 == 0) || (evenIsSmall && capital % 2 == 1)) ++small;
  if (small == capital || capital == 0x130U || capital == 0x3A2U) return std::nullopt;
  return std::string{static_cast<char>(0xC0U | (small >> 6U)), static_cast<char>(0x80U | (small & 0x3FU))};
}

/// "centideg" as "cdeg", "milliamps" as "ma".
std::string shortened(std::string_view word) {
  static constexpr auto prefixes = std::to_array<std::pair<std::string_view, char>>(
      {{"milli", 'm'}, {"centi", 'c'}, {"deci", 'd'}, {"micro", 'u'}, {"kilo", 'k'}});
  static constexpr auto electrical = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"amp", "a"}, {"amps", "a"}, {"ampere", "a"}, {"amperes", "a"}, {"volt", "v"}, {"volts", "v"}});
  for (const auto& [prefix, letter] : prefixes) {
    if (word.size() < prefix.size() + 2 || !word.starts_with(prefix)) continue;
    const std::string_view rest = word.substr(prefix.size());
    const auto it =
        std::find_if(electrical.begin(), electrical.end(), [rest](const auto& one) { return one.first == rest; });
    return letter + std::string(it != electrical.end() ? it->second : oneWord(rest));
  }
  return std::string(oneWord(word));
}

std::string_view oneTime(std::string_view word) {
  if (word == "sec" || word == "second" || word == "seconds" || word == "sekunde") return "s";
  if (word == "minute" || word == "minutes" || word == "мин" || word == "хв" || word == "phút" || word == "dak" ||
      word == "dk" || word == "分" || word == "分钟")
    return "min";
  if (word == "сек" || word == "с" || word == "sn" || word == "秒") return "s";
  return word;
}

}  // namespace

std::vector<std::string> wordsOf(std::string_view text, bool splitCamel) {
  std::vector<std::string> words;
  std::string word;
  const auto close = [&] {
    if (!word.empty()) words.push_back(std::exchange(word, {}));
  };
  const auto isLower = [&text](size_t k) { return k < text.size() && std::islower((unsigned char)text[k]) != 0; };
  const auto isUpper = [&text](size_t k) { return k < text.size() && std::isupper((unsigned char)text[k]) != 0; };
  const auto isGreek = [&text](size_t k) {  // its two bytes end at k
    return k > 0 && ((unsigned char)text[k - 1] == 0xCEU || (unsigned char)text[k - 1] == 0xCFU);
  };
  const auto isDigit = [&text](size_t k) { return k < text.size() && text[k] >= '0' && text[k] <= '9'; };
  for (size_t k = 0; k < text.size(); ++k) {
    const std::string_view rest = text.substr(k);
    const auto c = static_cast<unsigned char>(text[k]);
    if (rest.starts_with("°") || rest.starts_with("º")) {
      word += "deg";
      ++k;
    } else if (rest.starts_with("℃") || rest.starts_with("℉")) {
      word += rest.starts_with("℃") ? "degc" : "degf";
      k += 2;
    } else if (rest.starts_with("µ") || rest.starts_with("μ")) {
      word += 'u';
      ++k;
    } else if (rest.starts_with("⁻¹")) {
      close();
      words.emplace_back("1");
      k += 4;
    } else if (rest.starts_with("·") || rest.starts_with("×")) {
      ++k;
      close();
    } else if (rest.starts_with("⋅") || rest.starts_with("∙")) {
      k += 2;
      close();
    } else if (c == '/') {
      close();
      words.emplace_back("per");
    } else if (const auto lower = lowerLetter(rest)) {
      word += *lower;
      ++k;
    } else if (std::isalnum(c) != 0 || c == '%' || c >= 0x80U) {
      const bool hump = splitCamel && k > 0 && !word.empty() && isUpper(k) && isLower(k - 1);
      const bool lastOfCapitals = splitCamel && word.size() > 2 && isUpper(k) && isUpper(k - 1) && isLower(k + 1) &&
                                  isLower(k + 2);  // "RPMmotor" stays, "MotorPWMValue" parts
      const bool number = splitCamel && k > 0 && !word.empty() && isDigit(k) != isDigit(k - 1) && word.size() >= 2 &&
                          (std::isalnum((unsigned char)text[k - 1]) != 0 || isGreek(k - 1));            // "θ1"
      const bool behindNumber = splitCamel && k > 0 && isDigit(k - 1) && isUpper(k) && isLower(k + 1);  // "Drive0Pos"
      if (hump || lastOfCapitals || number || behindNumber) close();
      word += static_cast<char>(std::tolower(c));
    } else {
      close();
    }
  }
  close();
  return words;
}

const Unit* unitOfWords(const std::vector<std::string>& words, size_t from) {
  if (from >= words.size() || words.size() - from > 4) return nullptr;
  const size_t count = words.size() - from;
  std::string text;
  for (size_t k = from; k < words.size(); ++k) text += (k == from ? "" : "_") + words[k];
  if (const Unit* unit = exactly(text)) return unit;
  if (count > 1 && (words[from] == "quad" || words[from] == "quadrature")) return unitOfWords(words, from + 1);
  const std::string& last = words.back();
  if (count == 1 && last.size() > 5) {
    if (const Unit* unit = exactly(shortened(last)); unit != nullptr && shortened(last) != oneWord(last)) return unit;
  }
  if (count == 1 && last.size() > 3 && last.ends_with("ps"))  // "mradps"
    return exactly(shortened(std::string_view(last).substr(0, last.size() - 2)) + "_per_s");
  if (count == 3 && words[from + 1] == "per")
    return exactly(shortened(words[from]) + "_per_" + std::string(oneTime(last)));
  // "rad_s", "rad.s", "deg_sec": what turns, and a time; "rad·s⁻¹", "rad s-1"
  const bool inverse = count == 3 && last == "1";
  if (count != 2 && !inverse) return nullptr;
  const std::string moved = shortened(words[from]);
  const std::string_view time = oneTime(words[from + 1]);
  if (time != "s" && time != "min") return nullptr;
  return exactly(moved + "_per_" + std::string(time));
}

const Unit* unitNamed(std::string_view text) {
  while (!text.empty() && (text.front() == '[' || text.front() == '(' || text.front() == ' ')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ']' || text.back() == ')' || text.back() == ' ')) text.remove_suffix(1);
  if (text.empty() || text.size() > 40) return nullptr;
  if (text == "rads") return exactly("rad_per_s");  // as a unit of its own it is a speed more often than an angle
  const Unit* unit = unitOfWords(wordsOf(text, false), 0);
  return unit != nullptr ? unit : unitOfWords(wordsOf(text, true), 0);
}

bool isUnit(std::string_view text) {
  return unitNamed(text) != nullptr;
}

bool isSameWord(std::string_view text, std::string_view lower) {
  return text.size() == lower.size() && std::equal(text.begin(), text.end(), lower.begin(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         });
}

}  // namespace breakaway
