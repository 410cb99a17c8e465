#include "session/board_tuning.h"

#include <QCoreApplication>
#include <algorithm>

#include "base/numbers.h"
#include "control/tuning.h"
#include "experiment/servo_settings.h"

namespace breakaway {

namespace {

QString sourceWords(const char* text) {
  return QCoreApplication::translate("BoardTuning", text);
}

/// A value known to ±`part` of itself.
Estimate trustedWithin(double value, double part) {
  return {value, part * value / normal95};
}

}  // namespace

KnownMotor knownMotor(const ControllerSettings& settings, const std::optional<Bench>& bench, const Commission& found) {
  if (found.knows(Known::motor)) {
    const IdentifiedMotor& motor = found.motor;
    const double shown = motor.torquePerShownAmpere_Nm(), gain = motor.currentGain.value;
    const Estimate& constant = motor.torqueConstant_Nm_per_A;
    return {
        {motor.inertia_kg_m2.value, shown, std::max(0.0, motor.viscous_Nm_s_per_rad.value), found.shownResistance_ohm,
         std::max(0.0, motor.inductance_H.value / gain), motor.backEmfConstant_V_s_per_rad.value},
        motor.inertia_kg_m2,
        {shown, shown * constant.standardError / constant.value},
        found.noiseRms_A,
        sourceWords(QT_TRANSLATE_NOOP("BoardTuning", "identification"))};
  }
  KnownMotor known;
  if (bench && bench->motor.inertia && bench->motor.torqueConstant) {
    const MotorBelief& motor = bench->motor;
    known.values = {*motor.inertia,
                    *motor.torqueConstant,
                    motor.viscous.value_or(0.0),
                    motor.resistance_ohm.value_or(0.0),
                    motor.inductance_H.value_or(0.0),
                    motor.backEmfConstant.value_or(*motor.torqueConstant)};
    known.inertia_kg_m2 = trustedWithin(*motor.inertia, 0.05);
    known.torqueConstant_Nm_per_A = trustedWithin(*motor.torqueConstant, 0.027);
    known.source = sourceWords(QT_TRANSLATE_NOOP("BoardTuning", "bench file"));
    return known;
  }
  const double J = settings.nominal_inertia_kg_m2, Kt = settings.nominal_torque_constant_Nm_per_A;
  known.values = {J, Kt, 0.0, 0.0, 0.0, Kt};
  known.inertia_kg_m2 = trustedWithin(J, 0.3);
  known.torqueConstant_Nm_per_A = trustedWithin(Kt, 0.3);
  known.source = sourceWords(QT_TRANSLATE_NOOP("BoardTuning", "name plate"));
  return known;
}

ServoLoop boardLoop(const Identity& identity, const ControllerSettings& settings, const KnownMotor& motor) {
  const double tick_s = identity.loopRate_Hz > 0.0 ? 1.0 / identity.loopRate_Hz : 0.0;
  const double revolution = identity.axis == Axis::rotary ? turn_rad : 1.0;  // or a metre
  const double velocity = settings.velocity_bandwidth_rad_per_s, current = settings.current_bandwidth_rad_per_s;
  ServoLoop loop;
  loop.motor = motor.values;
  const bool wound = motor.values.resistance_ohm > 0.0 && motor.values.inductance_H > 0.0;
  loop.current = wound ? CurrentPath::winding : CurrentPath::ideal;
  loop.delay_ticks = identity.simulated ? 0 : 1;
  loop.board = {tick_s,
                identity.countsPerRev > 0.0 ? revolution / identity.countsPerRev : 0.0,
                {motor.values.resistance_ohm, motor.values.inductance_H, motor.values.backEmfConstant_V_s_per_rad,
                 current > 0.0 ? current : boardCurrentBandwidth_rad_per_s(tick_s)},
                velocity > 0.0 ? velocity : boardVelocityBandwidth_rad_per_s(tick_s)};
  loop.settings = servoSettings(settings);
  return loop;
}

Result<ControllerSettings> tunedSettings(const Identity& identity, const ControllerSettings& settings,
                                         const KnownMotor& motor, Stiffness stiffness) {
  ControllerSettings tuned = settings;
  tuned.nominal_inertia_kg_m2 = motor.inertia_kg_m2.value;
  tuned.nominal_torque_constant_Nm_per_A = motor.torqueConstant_Nm_per_A.value;
  const ServoLoop loop = boardLoop(identity, tuned, motor);
  AutoTuningOptions options;
  options.stiffness = stiffness;
  options.noise = {roundingRms_rad(loop.board.count_rad), motor.currentNoise_A};
  const auto tuning = autoTune(loop, motor.inertia_kg_m2, motor.torqueConstant_Nm_per_A, options);
  if (!tuning) return tuning.error();
  return withTuning(settings, tuning->settings);
}

}  // namespace breakaway
