// From strokes by voltage over a linear axis' travel to its moving mass.
#pragma once

#include <vector>

#include "base/estimate.h"
#include "base/result.h"
#include "experiment/spin_block.h"

namespace breakaway {

/// The moving mass from strokes by voltage: within each tenth of the travel and each way the friction is projected
/// out, and what is left of ∫Kf·i dt follows the speed's change. Errors: fewer than 20 windows.
Result<Estimate> massByStrokes(const std::vector<SpinBlock>& blocks, double forceConstant_N_per_A);

}  // namespace breakaway
