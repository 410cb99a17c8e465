// Edges of what happens once, where the data to learn from don't show them.
#pragma once

#include <vector>

#include "diagnose/fit/split.h"
#include "diagnose/model/model.h"

namespace breakaway {

/// A push that begins or ends where no training window lies begins and ends, as far as anybody knows, where they do: it
/// claims nothing of the time between, over which the edge's interval reaches.
Model withinSeen(Model model, const std::vector<Track>& tracks, const Split& split);

}  // namespace breakaway
