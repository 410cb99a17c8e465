// From a model's named parameters to numbers the stepper runs on, and back.
#pragma once

#include <optional>

#include "base/result.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/stepper.h"

namespace breakaway {

/// The base parameters of `model` as numbers; absent ones are 0 (the torque constant: 1).
Physics physicsOf(const Model& model);
/// The effects of `model` that act in `recording` (a path; empty: any), ready to run. Errors: a name that is not in the
/// catalogue, a wrong set of parameters.
Result<std::vector<CompiledTerm>> termsOf(const Model& model, const std::string& recording = {});
/// What follows the last slash.
std::string fileNameOf(const std::string& path);

/// The pendulum's inertia about the shaft, m·l² + m_arm·l²/3, and its greatest gravity torque, (m + m_arm/2)·9.81·l.
double pendulumInertia(const Pendulum& pendulum);
double pendulumTorque(const Pendulum& pendulum);

}  // namespace breakaway
