// Names and words that effects share: units by axis, numbers with three digits, angles in degrees.
#pragma once

#include <span>
#include <string>

#include "diagnose/effect.h"

namespace breakaway {

/// `stem` with the unit of torque (or force), viscous friction or speed at its end.
std::string torqueName(const std::string& stem, Axis axis);
std::string viscousName(const std::string& stem, Axis axis);
std::string speedName(const std::string& stem, Axis axis);

/// Three significant digits with SI prefix and unit: "3.12 mNm", "20.4 N".
std::string torqueText(double value, Axis axis);
std::string viscousText(double value, Axis axis);
std::string speedText(double value, Axis axis);
std::string angleText(double value_rad);
std::string lengthText(double value_m);
std::string percentText(double fraction);
std::string digitsText(double value);
/// "growing angle" or "growing position", and their opposites.
std::string wayText(double sign, Axis axis);

/// `stem` with the unit of inertia (or mass), position or stiffness at its end.
std::string inertiaName(const std::string& stem, Axis axis);
std::string positionName(const std::string& stem, Axis axis);
std::string stiffnessName(const std::string& stem, Axis axis);
/// Three significant digits with SI prefix and the unit given: "0.2 V", "12 ms".
std::string quantityText(double value, const char* unit);
/// A small angle ("0.35°") or length, and an inertia or mass.
std::string positionText(double value, Axis axis);
std::string inertiaText(double value, Axis axis);

}  // namespace breakaway
