// What a diagnosis leaves of the torque over time, where the motion can't be foreseen and the torque counts.
#pragma once

#include <optional>

#include "diagnose/diagnosis.h"
#include "diagnose/fit/torque_residual.h"
#include "diagnose/simulate/simulation.h"
#include "recording/recording.h"

namespace breakaway {

/// On a linear axis N for Nm.
struct TorqueView {
  TorqueTrace base, shown;  ///< of the base model, and of the one with findings
  Trace along;              ///< the motion as it was measured: a simulated one runs away
  double wander = 0.0;      ///< rms that a perfect model shows, where the torque wanders as it does here, Nm
};

/// `model` has the findings that are shown. Nothing where errors are in motion.
std::optional<TorqueView> torqueViewOf(const Diagnosis& diagnosis, const Model& model, const Recording& recording);

}  // namespace breakaway
