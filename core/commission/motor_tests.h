// What a motor is identified from, from one test to the next.
#pragma once

#include "commission/known.h"
#include "identify/bridge_fit.h"
#include "identify/winding_fit.h"

namespace breakaway {

struct MotorTests {
  WindingFit winding;
  IdentifiedMotor rough;  ///< by the first test that moves a rotor
  BridgeTests bridge;
};

/// Winding and bridge of `motor` once more, from all tests together; a bridge that can't be told from the motor leaves
/// a remark in `known`.
void takeBridge(const MotorTests& tests, IdentifiedMotor& motor, Commission& known);

}  // namespace breakaway
