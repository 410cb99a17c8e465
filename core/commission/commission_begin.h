// How a commissioning begins: fresh, or where an interrupted one ended.
#pragma once

#include "base/result.h"
#include "commission/commission.h"
#include "commission/commission_progress.h"

namespace breakaway {

/// The torque or force constant that the bench trusts.
std::optional<double> trustedConstant(const CommissionOptions& options);

/// Fills `kept` from options.earlier, if that belongs to this job, and `done` with what goes on from it; else afresh.
/// `done.identity` must be known. Errors: it was begun on another board, or with other options.
Result<void> beginProgress(const CommissionOptions& options, Commission& done, CommissionProgress& kept);

}  // namespace breakaway
