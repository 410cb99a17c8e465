// How a model moves from one instant to the next, in the notation of portable programs.
#pragma once

#include <string>

namespace breakaway {

/// Which of the stepper's ways a model needs (diagnose/simulate/stepper.h).
struct MotionKind {
  bool electrical = false;  ///< voltage or duty drives
  bool inductive = false;   ///< and the current takes its time
  bool elastic = false;     ///< friction gives before it slides
  bool changing = false;    ///< forces depend on the state
  bool losesVoltage = false;
};

/// Functions up to advance(&s, input, supply, dt), and where voltage drives advance_open(&s, dt), with open windings:
/// the stepper's equations and order, so that both give the same. They call load_torque(), friction_limit(),
/// keep_history() and, where voltage is lost, voltage_lost(), and use the constants inertia, viscous, torque_constant,
/// back_emf, resistance, inductance, slip_stiffness, slip_damping, longest_step_s.
std::string motionText(const MotionKind& kind);

}  // namespace breakaway
