#include "firmware_link/contradiction.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr double quiet = 0.005;       ///< of the trip's current: the sensor's own noise and zero
constexpr double nothing = 0.02;      ///< of the current that voltage and motion foretell
constexpr double reversed = 0.3;      ///< likewise, that a sensor shows at least which is only the other way round
constexpr double justReversed = 0.6;  ///< likewise, while its mean over 20 ms shows less
constexpr double still = 0.1;         ///< of the voltage: the back-EMF of a shaft that stands
constexpr double decaying = 0.2;      ///< likewise of the speed that voltage and current tell: the estimate lags behind
constexpr double clearlyLess = 0.5;   ///< of the voltage that the other cause leaves over
constexpr double steadySpeed = 0.1;   ///< of itself, that a speed changes by at most where one tick tells the cause
constexpr double usualFactors[] = {0.25, 0.5, 2.0, 4.0};  ///< lines for edges, one channel for two

/// By voltage and current.
double electricalSpeed(const MotorFigures& m) {
  return (m.voltage_V - m.resistance_ohm * m.current_A) / m.backEmf_V_s_per_rad;
}

/// By voltage and speed.
double foretoldCurrent(const MotorFigures& m) {
  return (m.voltage_V - m.backEmf_V_s_per_rad * m.velocity_rad_per_s) / m.resistance_ohm;
}

/// One tick's reading may be the sensor's noise.
bool currentFlows(const MotorFigures& m) {
  const double foretold_A = std::abs(foretoldCurrent(m)), now_A = std::abs(m.current_A);
  const double least_A = std::max(quiet * m.trip_A, nothing * foretold_A);
  const bool meanFlows = !m.mean_A || std::abs(*m.mean_A) >= least_A;
  return now_A >= least_A && (meanFlows || now_A >= reversed * foretold_A);
}

/// Of a shaft that stands: what a sensor the other way round shows at least, and not its noise only. One that has just
/// turned round has no mean yet.
bool currentAgainst(const MotorFigures& m) {
  const double foretold_A = std::abs(foretoldCurrent(m));
  const bool hasMean = !m.mean_A || std::abs(*m.mean_A) >= reversed * foretold_A;
  return std::abs(m.current_A) >= (hasMean ? reversed : justReversed) * foretold_A;
}

/// What voltage, current and motion leave over if the sensor is the other way round, and if the bridge is: the smaller
/// is the cause, unless back-EMF is too little to part them.
WiringCause sensorOrBridge(const MotorFigures& m) {
  const double current_A = m.mean_V ? m.mean_A.value_or(m.current_A) : m.current_A;
  const double speed = m.mean_V ? m.before_rad_per_s : m.velocity_rad_per_s;
  const double driven_V = m.mean_V.value_or(m.voltage_V) + m.inductive_V + m.resistance_ohm * current_A;
  const double induced_V = m.backEmf_V_s_per_rad * speed;
  const double ofSensor_V = std::abs(driven_V - induced_V), ofBridge_V = std::abs(driven_V + induced_V);
  const bool changes = std::abs(m.velocity_rad_per_s - m.before_rad_per_s) > steadySpeed * std::abs(m.before_rad_per_s);
  if ((m.mean_V || !changes) && std::min(ofSensor_V, ofBridge_V) < clearlyLess * std::max(ofSensor_V, ofBridge_V))
    return ofSensor_V < ofBridge_V ? WiringCause::sensorReversed : WiringCause::bridgeReversed;
  // A true current drives the shaft its way, so one that slows down has the other current.
  const bool motionAlong = m.voltage_V * m.velocity_rad_per_s > 0.0;
  const bool speedsUp = std::abs(m.velocity_rad_per_s) >= std::abs(m.before_rad_per_s);
  return motionAlong == speedsUp ? WiringCause::sensorReversed : WiringCause::bridgeReversed;
}

/// The nearest factor that a wrong number of counts usually has.
std::string factorText(double factor) {
  for (const double usual : usualFactors) {
    if (std::abs(std::log(factor / usual)) < 0.5 * std::log(2.0)) return fmt::format("about {:g} times", usual);
  }
  return fmt::format("{:.2g} times", factor);
}

}  // namespace

std::string shaftSpeedText(double speed, Axis axis) {
  return axis == Axis::rotary ? fmt::format("{:.0f} rad/s", speed) : fmt::format("{:.3g} m/s", speed);
}

WiringCause causeOf(const MotorFigures& m) {
  if (!(m.resistance_ohm > 0.0 && m.backEmf_V_s_per_rad > 0.0)) return WiringCause::unknown;
  const double V = m.voltage_V, resistive_V = m.resistance_ohm * m.current_A,
               induced_V = m.backEmf_V_s_per_rad * m.velocity_rad_per_s;
  const bool stands = std::abs(induced_V) < std::max(still * std::abs(V), decaying * std::abs(V - resistive_V));
  if (!currentFlows(m)) {
    if (stands) return WiringCause::leadOff;
    // What drives without a word accelerates; what has lost its lead runs down.
    return std::abs(m.velocity_rad_per_s) >= std::abs(m.before_rad_per_s) ? WiringCause::sensorDead
                                                                          : WiringCause::leadOff;
  }
  const bool currentAlong = resistive_V * V > 0.0, motionAlong = induced_V * V > 0.0;
  if (stands && currentAlong) return WiringCause::encoderStands;
  if (stands) return currentAgainst(m) ? WiringCause::sensorOrBridgeReversed : WiringCause::leadOff;
  if (currentAlong) return motionAlong ? WiringCause::countsFactor : WiringCause::encoderReversed;
  return sensorOrBridge(m);
}

Message contradictionWords(const MotorFigures& m) {
  const double turns = electricalSpeed(m);
  const std::string driven = shaftSpeedText(turns, m.axis), shown = shaftSpeedText(m.velocity_rad_per_s, m.axis);
  switch (causeOf(m)) {
    case WiringCause::encoderReversed:
      return message(
          "the encoder counts against the motor: {:.1f} V drive it at {}, the encoder shows {}; swap the encoder's A "
          "and B, or the motor's leads",
          m.voltage_V, driven, shown);
    case WiringCause::encoderStands:
      return message(
          "the encoder stands while voltage and current say that the motor runs at {} ({:.1f} V, {:.2f} A); check "
          "coupling, encoder cable and the encoder's supply",
          driven, m.voltage_V, m.current_A);
    case WiringCause::countsFactor:
      return message(
          "the encoder shows {} where {:.1f} V and {:.2f} A say {}, {} as much; check the encoder's counts (four edges "
          "for a line), the coupling, and the supply's reading",
          shown, m.voltage_V, m.current_A, driven, factorText(m.velocity_rad_per_s / turns));
    case WiringCause::sensorReversed:
      return message(
          "the current reads {:.2f} A where {:.1f} V at {} drive {:.2f} A: the current sensor is reversed (swap its "
          "leads), or its zero has moved",
          m.current_A, m.voltage_V, shown, foretoldCurrent(m));
    case WiringCause::bridgeReversed:
      return message(
          "{:.1f} V drive {:.2f} A at {}, the other way round: the bridge is reversed; swap its two inputs, or the "
          "sign in the board",
          m.voltage_V, m.current_A, shown);
    case WiringCause::sensorOrBridgeReversed:
      return message(
          "{:.1f} V drive {:.2f} A, the other way round: the current sensor or the bridge is reversed (swap the "
          "sensor's leads or the bridge's inputs), or the sensor's zero has moved",
          m.voltage_V, m.current_A);
    case WiringCause::sensorDead:
      return message(
          "the current sensor reads {:.2f} A while {:.1f} V drive the motor at {}, where {:.1f} A are to be expected: "
          "it is dead; check its supply and its wire",
          m.current_A, m.voltage_V, shown, foretoldCurrent(m));
    case WiringCause::leadOff:
      return message(
          "no current is seen at {:.1f} V: a lead of the motor is off, or the current sensor is dead (or the encoder, "
          "where friction is small); check the motor's terminals and the sensor's supply",
          m.voltage_V);
    case WiringCause::unknown:
      break;
  }
  return message(
      "voltage, current and motion don't belong to one motor; check the wiring of motor, encoder and current sensor");
}

}  // namespace breakaway
