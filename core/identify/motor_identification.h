// The motor from the bench's own tests: winding, back-EMF, inertia, average friction.
#pragma once

#include <optional>
#include <vector>

#include "base/estimate.h"
#include "base/result.h"
#include "experiment/spin_test.h"
#include "motor/winding_line.h"

namespace breakaway {

struct IdentifiedMotor {
  Estimate torqueConstant_Nm_per_A;
  bool torqueConstantTrusted = false;  ///< the bench's own; else tied to the back-EMF constant, Kt = Ke in SI
  Estimate backEmfConstant_V_s_per_rad;
  Estimate resistance_ohm;
  Estimate inductance_H;
  Estimate deadZone_V;
  Estimate inertia_kg_m2;
  Estimate coulomb_Nm;  ///< mean of both ways
  Estimate viscous_Nm_s_per_rad;
};

struct MotorIdentificationOptions {
  std::optional<double> trustedTorqueConstant_Nm_per_A;
  double window_s = 0.1;  ///< of the momentum balance
};

/// Back-EMF constant and dead zone by least squares of v − R·i = Ke·ω + V0·sgn ω over the blocks that turn; inertia and
/// friction by the balance of momentum over windows, Kt·∫i dt = J·Δω + C·s·Δt + B·Δθ, which needs no second derivative.
/// A gain error of the current sensor can't be told from Kt: all torques then carry it. Errors: too few blocks that
/// turn.
Result<IdentifiedMotor> identifyMotor(const std::vector<SpinBlock>& blocks, const WindingLine& winding,
                                      const Estimate& timeConstant_s, const MotorIdentificationOptions& options);

}  // namespace breakaway
