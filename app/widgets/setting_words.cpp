#include "widgets/setting_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "widgets/axis_units.h"
#include "widgets/number_text.h"

namespace breakaway {

namespace {

enum class Unit { gain, integral, derivative, integralPerTime, perTime, inertia, constant, current, speed };

struct SettingInWords {
  double ControllerSettings::*setting;
  Unit unit;
  const char* title;
  const char* linearTitle;  ///< where it is another
  const char* meaning;
};

using S = ControllerSettings;
constexpr SettingInWords settingTable[] = {
    {&S::velocity_kp_A_s_per_rad, Unit::gain, QT_TRANSLATE_NOOP("SettingWords", "Velocity Kp"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords", "Current per velocity error: stiffer against loads, and louder.")},
    {&S::velocity_ki_A_per_rad, Unit::integral, QT_TRANSLATE_NOOP("SettingWords", "Velocity Ki"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords", "Current per accumulated velocity error: takes away what a load leaves.")},
    {&S::velocity_kd_A_s2_per_rad, Unit::derivative, QT_TRANSLATE_NOOP("SettingWords", "Velocity Kd"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords", "Current per change of the velocity error: damps, and amplifies noise.")},
    {&S::position_kp_A_per_rad, Unit::integral, QT_TRANSLATE_NOOP("SettingWords", "Position Kp"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords", "Current per position error, when a position is held.")},
    {&S::position_ki_A_per_rad_s, Unit::integralPerTime, QT_TRANSLATE_NOOP("SettingWords", "Position Ki"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords", "Current per accumulated position error: takes away what friction leaves.")},
    {&S::position_kd_A_s_per_rad, Unit::gain, QT_TRANSLATE_NOOP("SettingWords", "Position Kd"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords", "Current per speed of the position error: damps the approach.")},
    {&S::observer_cutoff_rad_per_s, Unit::perTime, QT_TRANSLATE_NOOP("SettingWords", "Observer cutoff g"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords",
                       "Bandwidth of the disturbance observer's feedback; 0 switches the feedback off.")},
    {&S::nominal_inertia_kg_m2, Unit::inertia, QT_TRANSLATE_NOOP("SettingWords", "Nominal inertia"),
     QT_TRANSLATE_NOOP("SettingWords", "Nominal mass"),
     QT_TRANSLATE_NOOP("SettingWords", "What the observer takes for the moving parts.")},
    {&S::nominal_torque_constant_Nm_per_A, Unit::constant, QT_TRANSLATE_NOOP("SettingWords", "Nominal torque constant"),
     QT_TRANSLATE_NOOP("SettingWords", "Nominal force constant"),
     QT_TRANSLATE_NOOP("SettingWords", "What the observer takes the motor to give per ampere.")},
    {&S::current_limit_A, Unit::current, QT_TRANSLATE_NOOP("SettingWords", "Current limit"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords", "The controller asks for no more current than this, either way.")},
    {&S::velocity_limit_rad_per_s, Unit::speed, QT_TRANSLATE_NOOP("SettingWords", "Velocity limit"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords", "The controller goes no faster than this, either way.")},
    {&S::velocity_bandwidth_rad_per_s, Unit::perTime, QT_TRANSLATE_NOOP("SettingWords", "Speed observer w"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords",
                       "Bandwidth of the speed from the encoder's counts: faster lags less, and "
                       "lets more of their rounding through.")},
    {&S::current_bandwidth_rad_per_s, Unit::perTime, QT_TRANSLATE_NOOP("SettingWords", "Current loop w"), nullptr,
     QT_TRANSLATE_NOOP("SettingWords",
                       "Bandwidth of the current loop: faster follows more closely, and lets more "
                       "of the sensor's noise into the winding.")}};

QString settingText(const char* text) {
  return QCoreApplication::translate("SettingWords", text);
}

QString unitText(Unit unit, Axis axis) {
  const AxisUnits units = unitsOf(axis);
  switch (unit) {
    case Unit::gain:
      return units.gain;
    case Unit::integral:
      return units.integral;
    case Unit::derivative:
      return units.derivative;
    case Unit::integralPerTime:
      return axis == Axis::linear ? settingText(QT_TRANSLATE_NOOP("SettingWords", "A/(m s)"))
                                  : settingText(QT_TRANSLATE_NOOP("SettingWords", "A/(rad s)"));
    case Unit::perTime:
      return settingText(QT_TRANSLATE_NOOP("SettingWords", "rad/s"));
    case Unit::inertia:
      return units.inertia;
    case Unit::constant:
      return units.constant;
    case Unit::current:
      return settingText(QT_TRANSLATE_NOOP("SettingWords", "A"));
    case Unit::speed:
      return units.speed;
  }
  return {};
}

}  // namespace

QString SettingWords::rangeText(const SettingRange& range) const {
  const QString least = plainText(scale * range.least);
  return std::isfinite(range.most)
             ? settingText(QT_TRANSLATE_NOOP("SettingWords", "%1 to %2")).arg(least, plainText(scale * range.most))
             : settingText(QT_TRANSLATE_NOOP("SettingWords", "%1 and more")).arg(least);
}

SettingWords settingWords(double ControllerSettings::*setting, Axis axis) {
  const auto* found = std::find_if(std::begin(settingTable), std::end(settingTable),
                                   [&](const SettingInWords& one) { return one.setting == setting; });
  if (found == std::end(settingTable)) return {};
  const bool other = axis == Axis::linear && found->linearTitle != nullptr;
  return {settingText(other ? found->linearTitle : found->title), unitText(found->unit, axis),
          found->unit == Unit::inertia ? unitsOf(axis).inertiaScale : 1.0, settingText(found->meaning)};
}

}  // namespace breakaway
