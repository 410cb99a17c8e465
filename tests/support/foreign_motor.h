// The motors and axes of foreign rigs, and the ways to drive them.
#pragma once

#include <array>

#include "motor/bench.h"
#include "support/foreign_draw.h"

namespace breakaway::test {

inline constexpr double turn = 6.283185307179586;  // rad

/// In N, m and kg where it is linear.
struct Motor {
  const char* make;
  bool linear;
  double constant, resistance, inductance, inertia, coulomb, supply_V, counts;
  double viscous = 0.0, most_A = 0.0, fastest = 0.0;

  double peak() const { return constant * most_A; }
  double count() const { return linear ? 1.0 / counts : turn / counts; }
};

/// One of the makes, its values 0.6 to 1.7 times as large; `rotary`: none that is linear.
Motor motorFrom(Draw& draw, bool rotary);

/// `measured`: a current that is read, not asked for.
struct Driven {
  DriveInput input;
  bool measured;
  bool beside;  ///< the current is read beside the voltage
  const char* words;

  bool volts() const { return input == DriveInput::voltage || input == DriveInput::duty; }
};
inline constexpr std::array<Driven, 6> drives{{{DriveInput::voltage, false, false, "voltage"},
                                               {DriveInput::voltage, false, true, "voltage, current read"},
                                               {DriveInput::duty, false, false, "duty"},
                                               {DriveInput::current, false, false, "current asked for"},
                                               {DriveInput::current, true, false, "current read"},
                                               {DriveInput::torque, false, false, "torque"}}};

}  // namespace breakaway::test
