// The servo controller around its motor as one linear system in sampled time, exact for what the controller's code
// computes while nothing saturates and nothing is rounded.
#pragma once

#include "base/result.h"
#include "control/servo_controller.h"
#include "stability/discrete_system.h"

namespace breakaway {

/// The motor as it is, which the controller's nominal values may miss.
struct LoopMotor {
  double inertia_kg_m2 = 0.0;
  double torqueConstant_Nm_per_A = 0.0;
  double viscous_Nm_s_per_rad = 0.0;
  double resistance_ohm = 0.0;  ///< with the next two only where the current flows through a winding
  double inductance_H = 0.0;
  double backEmfConstant_V_s_per_rad = 0.0;
};

/// Where the controller's speed comes from.
enum class SpeedSource { observer, backwardDifference };
/// How current answers its reference: through the winding and its controller, or held at it for the whole tick.
enum class CurrentPath { winding, ideal };

/// A loop to look at. `board` and `settings` are those of ServoController; `mode` is velocity or position.
struct ServoLoop {
  LoopMotor motor;
  ServoController<double>::Board board;
  ServoSettings<double> settings;
  ServoMode mode = ServoMode::velocity;
  SpeedSource speed = SpeedSource::observer;
  CurrentPath current = CurrentPath::winding;
  int delay_ticks = 1;  ///< whole ticks from a sample to the tick over which its command is held

  /// α = Jn·Kt/(J·Ktn): how much faster than its nominal motor the real one answers.
  double alpha() const;
  /// α·g·T, the number of the rule of thumb.
  double alphaGT() const;
};

/// Why no loop can be made of it, e.g. a missing tick or inertia; the place is the field.
Result<void> check(const ServoLoop& loop);

/// Inputs of closedLoop(): the reference in rad/s (rad in position mode), load torque in Nm against growing angle, held
/// over the tick, white error of the encoder's angle in rad and of the current's measurement in A.
enum class LoopInput { reference, load, angleNoise, currentNoise };
/// Outputs of closedLoop() at the tick's sample: true speed, what the controller takes for it, τ̂ in Nm (0 without
/// observer), current reference in A, voltage in V (0 without winding), true angle in rad (in position mode).
enum class LoopOutput { velocity, velocityEstimate, disturbanceEstimate, currentReference, voltage, angle };

/// The loop closed: 4 inputs, 6 outputs, in the order of the enums. Winding and shaft are discretised exactly for a
/// voltage (or current) and a load that are held over the tick: [Φ Γ; 0 I] = e^{[F G; 0 0]T} (Franklin, Powell,
/// Workman, "Digital Control of Dynamic Systems", 3rd ed., section 4.3.3); the controller is taken over tick by tick
/// from ServoController. Precondition: check(loop).
DiscreteSystem closedLoop(const ServoLoop& loop);

/// L(z), one input and one output: the loop cut where the encoder's movement enters the controller; the closed loop has
/// 1 + L(z) = 0. A factor on L is a factor on the angle that a current makes, Kt/J but for the back-EMF, and not on the
/// measured current: so a gain margin says how far α may be off. Precondition: check(loop).
DiscreteSystem openLoop(const ServoLoop& loop);

}  // namespace breakaway
