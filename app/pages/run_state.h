// What a page's row in the rail says of a run of its own kinds.
#pragma once

#include <vector>

#include "session/run.h"
#include "widgets/step_state.h"

namespace breakaway {

class Connection;

/// Running with its share, failed or stopped with why; else open, with what is missing where no board is connected.
StepState stateOf(const Connection& connection, const std::vector<RunKind>& kinds);

}  // namespace breakaway
