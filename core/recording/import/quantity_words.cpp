#include "recording/import/quantity_words.h"

#include <algorithm>
#include <set>
#include <string>

#include "recording/import/foreign_words.h"

namespace breakaway {

namespace {

constexpr auto quantities = std::to_array<Word>({
    {"time", UnitKind::time},
    {"timestamp", UnitKind::time},
    {"utime", UnitKind::time},
    {"timestamps", UnitKind::time},
    {"times", UnitKind::time},
    {"tstamp", UnitKind::time},
    {"clk", UnitKind::time, true},
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
    {"angvel", UnitKind::angularVelocity},
    {"dphi", UnitKind::angularVelocity},
    {"dth", UnitKind::angularVelocity},
    {"thdot", UnitKind::angularVelocity},
    {"phip", UnitKind::angularVelocity},
    {"thetap", UnitKind::angularVelocity},
    {"wm", UnitKind::angularVelocity, true},
    {"wr", UnitKind::angularVelocity, true},
    {"drehzahl", UnitKind::angularVelocity, false, "rpm"},
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
    {"posi", UnitKind::angle},
    {"posn", UnitKind::angle},
    {"angle", UnitKind::angle},
    {"theta", UnitKind::angle},
    {"phi", UnitKind::angle},
    {"winkel", UnitKind::angle},
    {"lage", UnitKind::angle},
    {"weg", UnitKind::angle},
    {"displacement", UnitKind::angle},
    {"disp", UnitKind::angle, true},
    {"stroke", UnitKind::angle, true},
    {"travel", UnitKind::angle, true},
    {"drehwinkel", UnitKind::angle},
    {"th", UnitKind::angle, true},
    {"ang", UnitKind::angle, true},
    {"q", UnitKind::angle, true},
    {"encoder", UnitKind::angle, true},
    {"enc", UnitKind::angle, true},
    {"torque", UnitKind::torque},
    {"trq", UnitKind::torque},
    {"torq", UnitKind::torque},
    {"tor", UnitKind::torque},
    {"tq", UnitKind::torque},
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
    {"apos", UnitKind::angle},
    {"aspd", UnitKind::angularVelocity},
    {"uq", UnitKind::voltage},
    {"vq", UnitKind::voltage},
    {"vm", UnitKind::voltage},
    {"umot", UnitKind::voltage},
    {"umotor", UnitKind::voltage},
    {"u", UnitKind::voltage, true},
    {"volts", UnitKind::voltage},
    {"volt", UnitKind::voltage},
    {"current", UnitKind::current},
    {"currents", UnitKind::current},
    {"curr", UnitKind::current},
    {"cur", UnitKind::current},
    {"strom", UnitKind::current},
    {"imot", UnitKind::current},
    {"imotor", UnitKind::current},
    {"im", UnitKind::current, true},
    {"iq", UnitKind::current},
    {"amps", UnitKind::current},
    {"i", UnitKind::current, true},
    {"qvel", UnitKind::angularVelocity},
    {"dtheta", UnitKind::angularVelocity},
    {"ω", UnitKind::angularVelocity},
    {"θ̇", UnitKind::angularVelocity},
    {"qpos", UnitKind::angle},
    {"θ", UnitKind::angle},
    {"ϑ", UnitKind::angle},
    {"φ", UnitKind::angle},
    {"τ", UnitKind::torque},
    {"ts", UnitKind::time},
    {"epoch", UnitKind::time},
    {"unixtime", UnitKind::time},
});

}  // namespace

const Word* quantityNamed(std::string_view word) {
  const auto it =
      std::find_if(quantities.begin(), quantities.end(), [word](const Word& one) { return one.text == word; });
  if (it != quantities.end()) return &*it;
  const auto foreign = std::find_if(foreignQuantities.begin(), foreignQuantities.end(),
                                    [word](const Word& one) { return one.text == word; });
  if (foreign != foreignQuantities.end()) return &*foreign;
  if (word.size() > 4 && word.back() == 's') {  // "joint_temperatures", "torques"
    const auto one = std::find_if(quantities.begin(), quantities.end(),
                                  [&](const Word& each) { return each.text == word.substr(0, word.size() - 1); });
    if (one != quantities.end() && !one->weak) return &*one;
  }
  // German compounds: "Motorstrom", "Solldrehzahl".
  static constexpr auto germanEnds = std::to_array<std::string_view>(
      {"strom", "spannung", "drehzahl", "drehmoment", "winkel", "temperatur", "kraft", "geschwindigkeit", "zeit"});
  for (const std::string_view end : germanEnds) {
    if (word.size() > end.size() + 2 && word.ends_with(end)) return quantityNamed(end);
  }
  const auto whole = std::find_if(gapless.begin(), gapless.end(), [word](const Word& one) { return one.text == word; });
  return whole == gapless.end() ? nullptr : &*whole;
}

size_t quantityAtEnd(std::string_view word) {
  size_t begin = 0;
  for (const Word& one : gapless) {
    const bool ends = word.size() > one.text.size() && word.ends_with(one.text);
    if (ends && (begin == 0 || word.size() - one.text.size() < begin)) begin = word.size() - one.text.size();
  }
  return begin;
}

const std::string* otherThingIn(const std::vector<std::string>& words) {
  static constexpr auto ends = std::to_array<std::string_view>({"偏差", "误差", "誤差"});
  const auto it = std::find_if(words.begin(), words.end(), [](const std::string& word) {
    const bool named = std::find(otherThings.begin(), otherThings.end(), word) != otherThings.end();
    return named || std::any_of(ends.begin(), ends.end(), [&](std::string_view end) { return word.ends_with(end); });
  });
  return it == words.end() ? nullptr : &*it;
}

size_t foreignWordsIn(std::string_view text) {
  std::set<std::string_view> found;
  for (const Word& one : gapless) {
    if (text.find(one.text) != std::string_view::npos) found.insert(one.text);
  }
  const auto isForeign = [](const std::string& word) {
    return std::any_of(word.begin(), word.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80U; });
  };
  for (const std::string& word : wordsOf(text, false)) {
    const Word* quantity = isForeign(word) ? quantityNamed(word) : nullptr;
    if (quantity != nullptr) found.insert(quantity->text);
  }
  return found.size();
}

}  // namespace breakaway
