#include "firmware_link/contradiction.h"

#include <fmt/core.h>
#include <cmath>

namespace breakaway {

namespace {

constexpr double quiet = 0.0025;  ///< of the trip's current: the sensor's own noise and zero
constexpr double still = 0.02;    ///< of the voltage: the back-EMF of a shaft that stands
constexpr double clearly = 0.3;   ///< of the current that voltage and speed foretell

/// By voltage and current.
double electricalSpeed(const MotorFigures& m) {
  return (m.voltage_V - m.resistance_ohm * m.current_A) / m.backEmf_V_s_per_rad;
}

/// By voltage and speed.
double foretoldCurrent(const MotorFigures& m) {
  return (m.voltage_V - m.backEmf_V_s_per_rad * m.velocity_rad_per_s) / m.resistance_ohm;
}

}  // namespace

WiringCause causeOf(const MotorFigures& m) {
  if (!(m.resistance_ohm > 0.0 && m.backEmf_V_s_per_rad > 0.0)) return WiringCause::unknown;
  const double induced_V = m.backEmf_V_s_per_rad * m.velocity_rad_per_s;
  const bool stands = std::abs(induced_V) < still * std::abs(m.voltage_V);
  const bool against = !stands && induced_V * m.voltage_V < 0.0;
  if (std::abs(m.current_A) < quiet * m.trip_A) {
    if (stands) return WiringCause::leadOff;
    // What drives without a word accelerates; what has lost its lead runs down.
    return std::abs(m.now_rad_per_s) >= std::abs(m.velocity_rad_per_s) ? WiringCause::sensorDead : WiringCause::leadOff;
  }
  const bool currentAgainst = m.current_A * m.voltage_V < 0.0;
  if (against) return currentAgainst ? WiringCause::bridgeReversed : WiringCause::encoderReversed;
  const double foretold_A = foretoldCurrent(m);
  if (m.current_A * foretold_A < 0.0 && std::abs(m.current_A) > clearly * std::abs(foretold_A))
    return stands ? WiringCause::sensorOrBridgeReversed : WiringCause::sensorReversed;
  if (stands) return WiringCause::encoderStands;
  return WiringCause::countsFactor;
}

std::string contradictionWords(const MotorFigures& m) {
  const double turns = electricalSpeed(m), shown = m.velocity_rad_per_s;
  switch (causeOf(m)) {
    case WiringCause::encoderReversed:
      return fmt::format(
          "the encoder counts against the motor: {:.1f} V drive it at {:.0f} rad/s, the encoder shows {:.0f} rad/s; "
          "swap "
          "the encoder's A and B, or the motor's leads",
          m.voltage_V, turns, shown);
    case WiringCause::encoderStands:
      return fmt::format(
          "the encoder stands while voltage and current say that the motor turns at {:.0f} rad/s ({:.1f} V, {:.2f} A); "
          "check coupling, encoder cable and the encoder's supply",
          turns, m.voltage_V, m.current_A);
    case WiringCause::countsFactor:
      return fmt::format(
          "the encoder shows {:.0f} rad/s where {:.1f} V and {:.2f} A say {:.0f} rad/s, {:.2f} times as much; check "
          "the "
          "counts per turn (4 edges for a line), the coupling, and the supply's reading",
          shown, m.voltage_V, m.current_A, turns, shown / turns);
    case WiringCause::sensorReversed:
      return fmt::format(
          "the current reads {:.2f} A where {:.1f} V at {:.0f} rad/s drive {:.2f} A: the current sensor is reversed; "
          "swap its leads, or the sign in the board",
          m.current_A, m.voltage_V, shown, foretoldCurrent(m));
    case WiringCause::bridgeReversed:
      return fmt::format(
          "{:.1f} V drive {:.2f} A and {:.0f} rad/s, both the other way round: the bridge is reversed; swap its two "
          "inputs, or the sign in the board",
          m.voltage_V, m.current_A, shown);
    case WiringCause::sensorOrBridgeReversed:
      return fmt::format(
          "{:.1f} V drive {:.2f} A, the other way round: the current sensor or the bridge is reversed; swap the "
          "sensor's leads or the bridge's inputs",
          m.voltage_V, m.current_A);
    case WiringCause::sensorDead:
      return fmt::format(
          "the current sensor reads {:.2f} A while {:.1f} V drive the shaft at {:.0f} rad/s, where {:.1f} A are to be "
          "expected: it is dead; check its supply and its wire",
          m.current_A, m.voltage_V, shown, foretoldCurrent(m));
    case WiringCause::leadOff:
      return fmt::format("no current flows at {:.1f} V: a lead of the motor is off; check its terminals", m.voltage_V);
    case WiringCause::unknown:
      break;
  }
  return "voltage, current and motion don't belong to one motor; check the wiring of motor, encoder and current sensor";
}

}  // namespace breakaway
