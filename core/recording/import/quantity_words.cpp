#include "recording/import/quantity_words.h"

#include <algorithm>

namespace breakaway {

namespace {

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
    {"torq", UnitKind::torque},
    {"tor", UnitKind::torque},
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
    {"vitesse", UnitKind::angularVelocity},
    {"velocidad", UnitKind::angularVelocity},
    {"velocidade", UnitKind::angularVelocity},
    {"velocita", UnitKind::angularVelocity},
    {"velocità", UnitKind::angularVelocity},
    {"qvel", UnitKind::angularVelocity},
    {"dtheta", UnitKind::angularVelocity},
    {"ω", UnitKind::angularVelocity},
    {"θ̇", UnitKind::angularVelocity},
    {"posicion", UnitKind::angle},
    {"posición", UnitKind::angle},
    {"posição", UnitKind::angle},
    {"posizione", UnitKind::angle},
    {"angulo", UnitKind::angle},
    {"ángulo", UnitKind::angle},
    {"ângulo", UnitKind::angle},
    {"angolo", UnitKind::angle},
    {"qpos", UnitKind::angle},
    {"θ", UnitKind::angle},
    {"ϑ", UnitKind::angle},
    {"φ", UnitKind::angle},
    {"couple", UnitKind::torque},
    {"coppia", UnitKind::torque},
    {"τ", UnitKind::torque},
    {"courant", UnitKind::current},
    {"corriente", UnitKind::current},
    {"corrente", UnitKind::current},
    {"voltaje", UnitKind::voltage},
    {"tensione", UnitKind::voltage},
    {"tensión", UnitKind::voltage},
    {"tensão", UnitKind::voltage},
    {"tension", UnitKind::voltage},
    {"temps", UnitKind::time},
    {"tiempo", UnitKind::time},
    {"tempo", UnitKind::time},
    {"ts", UnitKind::time},
    {"epoch", UnitKind::time},
    {"unixtime", UnitKind::time},
    {"czas", UnitKind::time},
    {"время", UnitKind::time},
    {"Время", UnitKind::time},
    {"predkosc", UnitKind::angularVelocity},
    {"prędkość", UnitKind::angularVelocity},
    {"скорость", UnitKind::angularVelocity},
    {"Скорость", UnitKind::angularVelocity},
    {"pozycja", UnitKind::angle},
    {"kat", UnitKind::angle},
    {"kąt", UnitKind::angle},
    {"угол", UnitKind::angle},
    {"Угол", UnitKind::angle},
    {"prad", UnitKind::current},
    {"prąd", UnitKind::current},
    {"ток", UnitKind::current},
    {"Ток", UnitKind::current},
    {"napiecie", UnitKind::voltage},
    {"napięcie", UnitKind::voltage},
    {"напряжение", UnitKind::voltage},
    {"Напряжение", UnitKind::voltage},
    {"момент", UnitKind::torque},
    {"Момент", UnitKind::torque},
});

/// Written without gaps, so they stand at the end of a word.
constexpr auto gapless = std::to_array<Word>({
    {"时间", UnitKind::time},
    {"時間", UnitKind::time},
    {"时间戳", UnitKind::time},
    {"转速", UnitKind::angularVelocity, false, "rpm"},
    {"轉速", UnitKind::angularVelocity, false, "rpm"},
    {"回転数", UnitKind::angularVelocity, false, "rpm"},
    {"角速度", UnitKind::angularVelocity},
    {"速度", UnitKind::angularVelocity},
    {"位置", UnitKind::angle},
    {"角度", UnitKind::angle},
    {"转角", UnitKind::angle},
    {"电流", UnitKind::current},
    {"電流", UnitKind::current},
    {"电压", UnitKind::voltage},
    {"電圧", UnitKind::voltage},
    {"電壓", UnitKind::voltage},
    {"扭矩", UnitKind::torque},
    {"转矩", UnitKind::torque},
    {"力矩", UnitKind::torque},
    {"トルク", UnitKind::torque},
    {"温度", UnitKind::temperature},
});

}  // namespace

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

}  // namespace breakaway
