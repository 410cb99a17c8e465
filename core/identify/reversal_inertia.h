// Inertia from a rotor that constant current turns round.
#pragma once

#include <vector>

#include "base/estimate.h"
#include "base/result.h"
#include "experiment/spin_block.h"

namespace breakaway {

struct ReversalOptions {
  double torqueConstant_Nm_per_A = 0.0;
  double commanded_A = 0.0;  ///< the current that was asked for
};

/// Before the reversal friction helps to brake, J·|a₁| = Kt·i₁ + F(ω); after it, at the same speeds the other way, it
/// hinders, J·|a₂| = Kt·i₂ − F(ω). The sum is free of friction whatever its law: J = Kt·(i₁ + i₂)/(|a₁| + |a₂|), from
/// the slopes of the speed between 20 and 65 % of the highest. kg m², the mean over the reversals of either way,
/// which position torque pulls apart; the standard error from their scatter. Errors: fewer than three reversals either
/// way; a current that stays more than a fifth below the one asked for.
Result<Estimate> reversalInertia(const std::vector<SpinBlock>& blocks, const ReversalOptions& options);

}  // namespace breakaway
