#include "firmware_link/trip_words.h"

#include <cmath>

namespace breakaway {

Message tripWords(Trip trip, const TripFigures& figures) {
  switch (trip) {
    case Trip::overCurrent:
      return message(
          "over-current: {:.1f} A measured, the board trips at {:.1f} A; check motor leads and bridge for a short",
          std::abs(figures.current_A), figures.trip_A);
    case Trip::openSensor:
      return message(
          "the current sensor shows {:.1f} A while the windings are open; check the bridge for a short, the sensor and "
          "its wires",
          figures.current_A);
    case Trip::supplyLow:
      return message("the supply dropped to {:.1f} V of {:.1f} V; check the power supply and its current limit",
                     figures.supply_V, figures.nominalSupply_V);
    case Trip::encoderJump:
      return message(
          "the encoder jumped by about {:.0f} counts within a control tick, which no motion does; check encoder cable "
          "and shield, then home again",
          figures.jumpedCounts);
    case Trip::blocked:
      return message(
          "the rotor is blocked: no motion for {:.1f} s at the current limit of {:.2f} A; free the shaft, or raise the "
          "limit",
          figures.blockedFor_s, figures.limit_A);
    case Trip::supplyHigh:
      return message(
          "the supply reads {:.1f} V where {:.1f} V belong: braking feeds it (add a brake resistor or brake more "
          "gently), or the board's divider is another one",
          figures.supply_V, figures.nominalSupply_V);
    case Trip::overSpeed:
      return message(
          "over-speed: {}, more than the motor may turn at or more than half again what was asked for; check the "
          "gains, the encoder's direction and its counts, and whether a load drives the shaft",
          shaftSpeedText(std::abs(figures.motor.velocity_rad_per_s), figures.motor.axis));
    case Trip::windingHeat:
      return message(
          "the winding gets too hot: {:.1f} A now, and for a third of a minute more than it bears for ever; let it "
          "cool, and ask for less torque or free the shaft",
          std::abs(figures.current_A));
    case Trip::contradiction:
      return contradictionWords(figures.motor);
    case Trip::none:
      break;
  }
  return {};
}

Message linkLossWords(double silent_s) {
  return message(
      "the link to the board is lost: no samples for {:.2f} s, so the board opened the windings; check cable and "
      "power, then connect and home again",
      silent_s);
}

}  // namespace breakaway
