#include "diagnose/effects/wording.h"

#include <fmt/core.h>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/typeset.h"

namespace breakaway {

namespace {

std::string withPrefix(double value, const char* unit) {
  const double size = std::abs(value);
  const double scale = size >= 1.0 || size == 0.0 ? 1.0 : size >= 1e-3 ? 1e3 : 1e6;
  const char* prefix = scale == 1.0 ? "" : scale == 1e3 ? "m" : "µ";
  return digitsText(value * scale) + " " + prefix + unit;
}

}  // namespace

std::string torqueName(const std::string& stem, Axis axis) {
  return stem + (axis == Axis::rotary ? "_Nm" : "_N");
}
std::string viscousName(const std::string& stem, Axis axis) {
  return stem + (axis == Axis::rotary ? "_Nm_s_per_rad" : "_N_s_per_m");
}
std::string speedName(const std::string& stem, Axis axis) {
  return stem + (axis == Axis::rotary ? "_rad_per_s" : "_m_per_s");
}

std::string torqueText(double value, Axis axis) {
  return withPrefix(value, axis == Axis::rotary ? "Nm" : "N");
}
std::string viscousText(double value, Axis axis) {
  return withPrefix(value, axis == Axis::rotary ? "Nm s/rad" : "N s/m");
}
std::string speedText(double value, Axis axis) {
  return axis == Axis::rotary ? digitsText(value) + " rad/s" : withPrefix(value, "m/s");
}
std::string angleText(double value_rad) {
  return typeset(fmt::format("{:.0f}°", value_rad * 180.0 / std::numbers::pi));
}
std::string lengthText(double value_m) {
  return withPrefix(value_m, "m");
}
std::string percentText(double fraction) {
  return typeset(fmt::format("{:.0f} %", fraction * 100.0));
}
std::string digitsText(double value) {
  const double size = std::abs(value);
  return typeset(size >= 999.5 && size < 1e6 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value));
}
Message wayText(double sign, Axis axis) {
  if (axis == Axis::rotary) return sign > 0.0 ? message("counter-clockwise") : message("clockwise");
  return sign > 0.0 ? message("towards growing position") : message("towards falling position");
}

Message effectName(const Effect& effect) {
  return Message(effect.name(), {});
}
Message torqueWord(Axis axis) {
  return axis == Axis::rotary ? message("torque") : message("force");
}
std::string stiffnessName(const std::string& stem, Axis axis) {
  return stem + (axis == Axis::rotary ? "_Nm_per_rad" : "_N_per_m");
}
std::string stiffnessText(double value, Axis axis) {
  if (value >= 1e4) return digitsText(1e-3 * value) + (axis == Axis::rotary ? " kNm/rad" : " kN/m");
  return withPrefix(value, axis == Axis::rotary ? "Nm/rad" : "N/m");
}
std::string timeText(double value_s) {
  return withPrefix(value_s, "s");
}
std::string travelText(double value, Axis axis) {
  return axis == Axis::rotary ? digitsText(value * 180.0 / std::numbers::pi) + "°" : lengthText(value);
}
std::string frictionText(double value, const Excitation& seen) {
  const double share = seen.coulomb > 0.0 ? value / seen.coulomb : 0.0;
  const std::string size = torqueText(value, seen.axis);
  return share > 0.005 && share < 5.0 ? size + " (" + percentText(share) + ")" : size;
}

std::string inertiaName(const std::string& stem, Axis axis) {
  return stem + (axis == Axis::rotary ? "_kg_m2" : "_kg");
}
std::string positionName(const std::string& stem, Axis axis) {
  return stem + (axis == Axis::rotary ? "_rad" : "_m");
}
std::string inertiaText(double value, Axis axis) {
  return digitsText(value) + (axis == Axis::rotary ? " kg m²" : " kg");
}
std::string quantityText(double value, const char* unit) {
  return withPrefix(value, unit);
}

double twoTurns(const Excitation& seen) {
  return seen.axis == Axis::rotary ? 2.0 * turn_rad : 2.0 * seen.travel;
}

}  // namespace breakaway
