#include "recording/import/units.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr double degree = turn_rad / 360.0;
constexpr double gravity_m_per_s2 = 9.80665;
constexpr double pound_N = 0.45359237 * gravity_m_per_s2;
constexpr double inch_m = 0.0254;
using enum UnitKind;

/// Names as `normalized` leaves them: words joined by "_".
constexpr auto units = std::to_array<Unit>({
    {"s", time, 1},
    {"sec", time, 1},
    {"secs", time, 1},
    {"second", time, 1},
    {"seconds", time, 1},
    {"sekunde", time, 1},
    {"sekunden", time, 1},
    {"ms", time, 1e-3},
    {"msec", time, 1e-3},
    {"msecs", time, 1e-3},
    {"millis", time, 1e-3},
    {"millisecond", time, 1e-3},
    {"milliseconds", time, 1e-3},
    {"millisec", time, 1e-3},
    {"milisec", time, 1e-3},
    {"milliseg", time, 1e-3},
    {"milisegundos", time, 1e-3},
    {"millisecs", time, 1e-3},
    {"us", time, 1e-6},
    {"usec", time, 1e-6},
    {"usecs", time, 1e-6},
    {"micros", time, 1e-6},
    {"microsecond", time, 1e-6},
    {"microseconds", time, 1e-6},
    {"microsec", time, 1e-6},
    {"microsecs", time, 1e-6},
    {"ns", time, 1e-9},
    {"nsec", time, 1e-9},
    {"nsecs", time, 1e-9},
    {"nanos", time, 1e-9},
    {"nanosec", time, 1e-9},
    {"nanosecond", time, 1e-9},
    {"nanoseconds", time, 1e-9},
    {"min", time, 60},
    {"minutes", time, 60},
    {"h", time, 3600},
    {"hours", time, 3600},
    {"days", time, 86400},

    {"rad", angle, 1},
    {"rads", angle, 1},
    {"radian", angle, 1},
    {"radians", angle, 1},
    {"mrad", angle, 1e-3},
    {"deg", angle, degree},
    {"degs", angle, degree},
    {"degree", angle, degree},
    {"degrees", angle, degree},
    {"grad", angle, degree},
    {"gradi", angle, degree},
    {"grados", angle, degree},
    {"graden", angle, degree},
    {"grader", angle, degree},
    {"graus", angle, degree},
    {"degré", angle, degree},
    {"degrés", angle, degree},
    {"degres", angle, degree},
    {"stopni", angle, degree},
    {"derece", angle, degree},
    {"stupně", angle, degree},
    {"stupňů", angle, degree},
    {"fok", angle, degree},
    {"cdeg", angle, 1e-2 * degree},
    {"mdeg", angle, 1e-3 * degree},
    {"gon", angle, 0.9 * degree},
    {"arcmin", angle, degree / 60},
    {"arcsec", angle, degree / 3600},
    {"rev", angle, turn_rad},
    {"revs", angle, turn_rad},
    {"revolution", angle, turn_rad},
    {"revolutions", angle, turn_rad},
    {"turn", angle, turn_rad},
    {"turns", angle, turn_rad},
    {"rot", angle, turn_rad},
    {"rotation", angle, turn_rad},
    {"rotations", angle, turn_rad},
    {"umdr", angle, turn_rad},
    {"umdrehung", angle, turn_rad},
    {"umdrehungen", angle, turn_rad},
    {"count", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"counts", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"cnt", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"cnts", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"cts", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"tick", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"ticks", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"steps", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"inkr", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"inkremente", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"microsteps", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"pulses", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"quadcounts", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"inc", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"incs", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"ink", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"inkremente", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"increments", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"pulse", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"pulses", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"lsb", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"qc", angle, turn_rad, 0, UnitNeeds::countsPerRev},
    {"edeg", angle, degree, 0, UnitNeeds::polePairs},
    {"erad", angle, 1, 0, UnitNeeds::polePairs},
    {"erev", angle, turn_rad, 0, UnitNeeds::polePairs},

    {"m", length, 1},
    {"meter", length, 1},
    {"meters", length, 1},
    {"cm", length, 1e-2},
    {"mm", length, 1e-3},
    {"um", length, 1e-6},
    {"inch", length, inch_m},
    {"inches", length, inch_m},
    {"feet", length, 12 * inch_m},

    {"rad_per_s", angularVelocity, 1},
    {"mrad_per_s", angularVelocity, 1e-3},
    {"krad_per_s", angularVelocity, 1e3},
    {"deg_per_s", angularVelocity, degree},
    {"mdeg_per_s", angularVelocity, 1e-3 * degree},
    {"dps", angularVelocity, degree},
    {"degps", angularVelocity, degree},
    {"radps", angularVelocity, 1},
    {"degpersec", angularVelocity, degree},
    {"radpersec", angularVelocity, 1},
    {"hz", angularVelocity, turn_rad},
    {"deg_per_min", angularVelocity, degree / 60},
    {"rev_per_s", angularVelocity, turn_rad},
    {"rps", angularVelocity, turn_rad},
    {"rpm", angularVelocity, turn_rad / 60},
    {"krpm", angularVelocity, 1000 * turn_rad / 60},
    {"mrpm", angularVelocity, 1e-3 * turn_rad / 60},
    {"rev_per_min", angularVelocity, turn_rad / 60},
    {"1_per_min", angularVelocity, turn_rad / 60},
    {"min_1", angularVelocity, turn_rad / 60},
    {"u_per_min", angularVelocity, turn_rad / 60},
    {"umin", angularVelocity, turn_rad / 60},
    {"r_per_min", angularVelocity, turn_rad / 60},
    {"erpm", angularVelocity, turn_rad / 60, 0, UnitNeeds::polePairs},
    {"erad_per_s", angularVelocity, 1, 0, UnitNeeds::polePairs},
    {"count_per_s", angularVelocity, turn_rad, 0, UnitNeeds::countsPerRev},
    {"cps", angularVelocity, turn_rad, 0, UnitNeeds::countsPerRev},
    {"m_per_s", linearVelocity, 1},
    {"cm_per_s", linearVelocity, 1e-2},
    {"mm_per_s", linearVelocity, 1e-3},
    {"um_per_s", linearVelocity, 1e-6},
    {"mps", linearVelocity, 1},
    {"m_per_min", linearVelocity, 1.0 / 60},
    {"mm_per_min", linearVelocity, 1e-3 / 60},
    {"inch_per_s", linearVelocity, inch_m},
    {"feet_per_s", linearVelocity, 12 * inch_m},

    {"a", current, 1},
    {"amp", current, 1},
    {"amps", current, 1},
    {"ampere", current, 1},
    {"amperes", current, 1},
    {"arms", current, 1},
    {"a_rms", current, 1},
    {"aeff", current, 1},
    {"a_eff", current, 1},
    {"ma", current, 1e-3},
    {"marms", current, 1e-3},
    {"ma_rms", current, 1e-3},
    {"ma_eff", current, 1e-3},
    {"milliamp", current, 1e-3},
    {"milliamps", current, 1e-3},
    {"ua", current, 1e-6},
    {"ka", current, 1e3},
    {"da", current, 1e-1},
    {"v", voltage, 1},
    {"volt", voltage, 1},
    {"volts", voltage, 1},
    {"mv", voltage, 1e-3},
    {"millivolt", voltage, 1e-3},
    {"millivolts", voltage, 1e-3},
    {"kv", voltage, 1e3},
    {"dv", voltage, 1e-1},

    {"nm", torque, 1},
    {"n_m", torque, 1},
    {"newton_meter", torque, 1},
    {"newton_meters", torque, 1},
    {"newtonmeter", torque, 1},
    {"mnm", torque, 1e-3},
    {"mn_m", torque, 1e-3},
    {"n_mm", torque, 1e-3},
    {"nmm", torque, 1e-3},
    {"unm", torque, 1e-6},
    {"ncm", torque, 1e-2},
    {"cnm", torque, 1e-2},
    {"dnm", torque, 1e-1},
    {"n_cm", torque, 1e-2},
    {"knm", torque, 1e3},
    {"oz_in", torque, pound_N / 16 * inch_m},
    {"ozin", torque, pound_N / 16 * inch_m},
    {"oz_inch", torque, pound_N / 16 * inch_m},
    {"ozf_in", torque, pound_N / 16 * inch_m},
    {"ozfin", torque, pound_N / 16 * inch_m},
    {"in_oz", torque, pound_N / 16 * inch_m},
    {"lb_in", torque, pound_N* inch_m},
    {"lbin", torque, pound_N* inch_m},
    {"lbf_in", torque, pound_N* inch_m},
    {"in_lb", torque, pound_N* inch_m},
    {"in_lbs", torque, pound_N* inch_m},
    {"inlbs", torque, pound_N* inch_m},
    {"lbs_in", torque, pound_N* inch_m},
    {"lb_ft", torque, pound_N * 12 * inch_m},
    {"lbf_ft", torque, pound_N * 12 * inch_m},
    {"ft_lb", torque, pound_N * 12 * inch_m},
    {"ft_lbs", torque, pound_N * 12 * inch_m},
    {"lbs_ft", torque, pound_N * 12 * inch_m},
    {"kgf_cm", torque, gravity_m_per_s2 * 1e-2},
    {"kgfcm", torque, gravity_m_per_s2 * 1e-2},
    {"kg_cm", torque, gravity_m_per_s2 * 1e-2},
    {"kgcm", torque, gravity_m_per_s2 * 1e-2},
    {"kgf_m", torque, gravity_m_per_s2},
    {"kgfm", torque, gravity_m_per_s2},
    {"kg_m", torque, gravity_m_per_s2},
    {"gf_cm", torque, gravity_m_per_s2 * 1e-5},
    {"gfcm", torque, gravity_m_per_s2 * 1e-5},
    {"g_cm", torque, gravity_m_per_s2 * 1e-5},
    {"gcm", torque, gravity_m_per_s2 * 1e-5},

    {"n", force, 1},
    {"newton", force, 1},
    {"newtons", force, 1},
    {"mn", force, 1e-3},
    {"kn", force, 1e3},
    {"kgf", force, gravity_m_per_s2},
    {"gf", force, 1e-3 * gravity_m_per_s2},
    {"lbf", force, pound_N},

    {"degc", temperature, 1},
    {"deg_c", temperature, 1},
    {"c", temperature, 1},
    {"celsius", temperature, 1},
    {"k", temperature, 1, -273.15},
    {"kelvin", temperature, 1, -273.15},
    {"degf", temperature, 5.0 / 9, -160.0 / 9},
    {"deg_f", temperature, 5.0 / 9, -160.0 / 9},
    {"fahrenheit", temperature, 5.0 / 9, -160.0 / 9},

    {"percent", ratio, 1e-2},
    {"%", ratio, 1e-2},
    {"pct", ratio, 1e-2},
    {"prozent", ratio, 1e-2},
    {"permille", ratio, 1e-3},
    {"‰", ratio, 1e-3},
    {"1", ratio, 1},
    {"pu", ratio, 1},
});

const Unit* exactly(std::string_view name) {
  const auto it = std::find_if(units.begin(), units.end(), [name](const Unit& unit) { return name == unit.name; });
  return it == units.end() ? nullptr : &*it;
}

/// What moves, in the one word that stands in front of "per".
std::string_view oneWord(std::string_view word) {
  static constexpr auto same = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"rads", "rad"},    {"radian", "rad"},  {"radians", "rad"},  {"degs", "deg"},       {"degree", "deg"},
       {"degrees", "deg"}, {"grad", "deg"},    {"revs", "rev"},     {"revolution", "rev"}, {"revolutions", "rev"},
       {"turn", "rev"},    {"turns", "rev"},   {"rot", "rev"},      {"rotation", "rev"},   {"rotations", "rev"},
       {"u", "rev"},       {"r", "rev"},       {"umdr", "rev"},     {"tr", "rev"},         {"giri", "rev"},
       {"obr", "rev"},     {"ot", "rev"},      {"omw", "rev"},      {"toer", "rev"},       {"varv", "rev"},
       {"об", "rev"},      {"dev", "rev"},     {"gradi", "deg"},    {"grados", "deg"},     {"graden", "deg"},
       {"degrés", "deg"},  {"derece", "deg"},  {"counts", "count"}, {"cnt", "count"},      {"cts", "count"},
       {"tick", "count"},  {"steps", "count"}, {"step", "count"},   {"pulse", "count"},    {"ticks", "count"},
       {"inc", "count"},   {"ink", "count"},   {"pulses", "count"}, {"lsb", "count"},      {"meter", "m"},
       {"meters", "m"},    {"metre", "m"},     {"metres", "m"},     {"millimeters", "mm"}, {"in", "inch"},
       {"inches", "inch"}, {"ft", "feet"},     {"foot", "feet"}});
  const auto it = std::find_if(same.begin(), same.end(), [word](const auto& one) { return one.first == word; });
  return it == same.end() ? word : it->second;
}

/// The small letter of a capital one with two bytes of UTF-8, Latin with an accent or Cyrillic.
std::optional<std::string> lowerLetter(std::string_view text) {
  if (text.size() < 2) return std::nullopt;
  const auto lead = static_cast<unsigned char>(text[0]), tail = static_cast<unsigned char>(text[1]);
  const auto letter = [](unsigned first, unsigned second) {
    return std::string{static_cast<char>(first), static_cast<char>(second)};
  };
  if (lead == 0xC3U && tail >= 0x80U && tail <= 0x9EU && tail != 0x97U) return letter(lead, tail + 0x20U);
  if (lead == 0xD0U && tail >= 0x90U && tail <= 0x9FU) return letter(lead, tail + 0x20U);
  if (lead == 0xD0U && tail >= 0xA0U && tail <= 0xAFU) return letter(0xD1U, tail - 0x20U);
  return std::nullopt;
}

std::string_view oneTime(std::string_view word) {
  if (word == "sec" || word == "second" || word == "seconds" || word == "sekunde") return "s";
  if (word == "minute" || word == "minutes" || word == "мин" || word == "dak" || word == "dk") return "min";
  if (word == "сек" || word == "с" || word == "sn") return "s";
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
                          std::isalnum((unsigned char)text[k - 1]) != 0;
      if (hump || lastOfCapitals || number) close();
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
  const std::string& last = words.back();
  if (count == 3 && words[from + 1] == "per")
    return exactly(std::string(oneWord(words[from])) + "_per_" + std::string(oneTime(last)));
  // "rad_s", "rad.s", "deg_sec": what turns, and a time; "rad·s⁻¹", "rad s-1"
  const bool inverse = count == 3 && last == "1";
  if (count != 2 && !inverse) return nullptr;
  const std::string_view moved = oneWord(words[from]), time = oneTime(words[from + 1]);
  if (time != "s" && time != "min") return nullptr;
  return exactly(std::string(moved) + "_per_" + std::string(time));
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
