// What the portable board is told of the hardware that it runs on. Freestanding.
#pragma once

#include <cstdint>

#include "control/board_watch.h"
#include "control/servo_controller.h"

namespace breakaway::board {

/// Who calls the ticks.
enum class Pace : std::uint8_t {
  real,    ///< a timer; the lease runs out in the same time
  granted  ///< whoever has a plant to compute, and only as far as the host allows
};

template <typename Scalar>
struct BoardHardware {
  Pace pace = Pace::real;
  std::uint16_t boot = 0;  ///< another number after each powering up: a counter that survives, noise, a clock
  bool simulated = false, hasIndex = true, hasTemperature = false;
  const char* device = "";  ///< outlives the board
  const char* firmware = "";
  const char* serialNumber = "";  ///< empty: nobody knows it

  Scalar loopRate_Hz = 0;
  std::uint32_t countsPerRev = 0;
  Scalar supply_V = 0;         ///< nominal
  Scalar sensorRange_A = 0;    ///< largest current that the sensor shows
  Scalar sensorStep_A = 0;     ///< of its converter; 0: finer than the telemetry
  std::uint32_t pwmSteps = 0;  ///< of the timer, from duty 0 to 1; 0: as fine as may be
  typename ServoController<Scalar>::Board servo;
  typename BoardWatch<Scalar>::Limits watch;
  ServoSettings<Scalar> start;  ///< settings at power-up
  Scalar mostCurrent_A = 0;     ///< that the current limit may be set to
  Scalar mostVelocity_rad_per_s = 0;
};

/// What the port measured at the beginning of a tick.
template <typename Scalar>
struct Readings {
  std::int32_t count = 0;  ///< of the encoder since power-up, wrapping
  bool index = false;      ///< was passed since the last tick
  Scalar current_A = 0;    ///< as the sensor reads, its zero still in it
  Scalar supply_V = 0;
  Scalar temperature_degC = 0;
};

/// What the port is to do until the next tick.
template <typename Scalar>
struct Drive {
  bool enabled = false;  ///< false: all switches of the bridge open
  Scalar duty = 0;       ///< −1 … 1, a whole number of the timer's steps
};

}  // namespace breakaway::board
