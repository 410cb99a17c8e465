// Data that shows everything, as the search sees it: what known_servo.h's servo does in a good experiment.
#pragma once

#include <numbers>
#include <vector>

#include "diagnose/model/effect.h"

namespace breakaway::test {

inline Excitation richExcitation(DriveInput input, Axis axis = Axis::rotary) {
  Excitation seen;
  seen.axis = axis;
  seen.electrical = input == DriveInput::voltage || input == DriveInput::duty;
  seen.currentDrive = input == DriveInput::current;
  seen.currentSeen = seen.supplySeen = seen.electrical;
  seen.bothWays = true;
  seen.step_s = 1e-3;
  seen.duration_s = 60.0;
  seen.lowSpeed = 0.5;
  seen.highSpeed = 20.0;
  seen.lowest = -8.0;
  seen.highest = 12.0;
  seen.travel = 20.0;
  seen.count = 2.0 * std::numbers::pi / 14400.0;
  seen.peakTorque = 0.08;
  seen.peakCurrent = input == DriveInput::torque ? 0.0 : 1.1;
  seen.usualCurrent = 0.4 * seen.peakCurrent;
  seen.peakInput = seen.electrical ? 2.5 : seen.currentDrive ? 1.2 : 0.09;
  seen.peakAcceleration = 500.0;
  seen.longestRest_s = 2.0;
  seen.starts = 40;
  seen.reversals = 60;
  seen.inertia = 6e-5;
  seen.coulomb = 0.012;
  return seen;
}

/// The middle one of the shapes that such data can show, at the size the search starts from; empty: none.
inline std::vector<double> typicalParameters(const Effect& effect, const Excitation& seen) {
  const std::vector<Shape> shapes = effect.shapes(seen);
  if (shapes.empty()) return {};
  const Shape& shape = shapes[shapes.size() / 2];
  std::vector<double> amplitude(shape.size(), 0.0);
  amplitude.front() = 1.0;
  return effect.scaled(shape, amplitude);
}

}  // namespace breakaway::test
