// Which column of a recording drives a bench.
#pragma once

#include <string>

#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

/// The bench's own, but of one driven by voltage the duty where only that was recorded, and the other way.
std::string recordedInput(const Recording& recording, const Bench& bench);

}  // namespace breakaway
