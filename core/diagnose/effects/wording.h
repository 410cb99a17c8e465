// Names and words that effects share: units by axis, numbers with three digits, angles in degrees.
#pragma once

#include <span>
#include <string>

#include "base/message.h"
#include "diagnose/model/effect.h"

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
Message wayText(double sign, Axis axis);

/// As files have it, and by its words where another language is spoken.
Message effectName(const Effect& effect);
/// "torque" or "force".
Message torqueWord(Axis axis);
/// Stiffness: "_Nm_per_rad" or "_N_per_m".
std::string stiffnessName(const std::string& stem, Axis axis);
std::string stiffnessText(double value, Axis axis);
std::string timeText(double value_s);
/// A short way: "0.057°", "12 µm".
std::string travelText(double value, Axis axis);
/// "1.2 mNm (38 %)": with the share of the base model's dry friction where that says something.
std::string frictionText(double value, const Excitation& seen);

/// `stem` with the unit of inertia (or mass) or position at its end.
std::string inertiaName(const std::string& stem, Axis axis);
std::string positionName(const std::string& stem, Axis axis);
std::string inertiaText(double value, Axis axis);
/// Three significant digits with SI prefix and the unit given: "0.2 V".
std::string quantityText(double value, const char* unit);

/// The way of an experiment that is to pass each place twice, rad or m.
double twoTurns(const Excitation& seen);

}  // namespace breakaway
