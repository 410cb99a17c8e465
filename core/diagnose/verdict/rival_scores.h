// What other effects in a finding's place make of held-out data: why it won, or why it can't be told from them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/statistics.h"
#include "diagnose/fit/preparation.h"
#include "diagnose/search/search.h"
#include "diagnose/verdict/finding.h"

namespace breakaway {

/// 95 % interval of the RMSE over windows, whose mean squares are given.
Interval errorInterval(const std::vector<double>& squares, std::uint64_t seed);

/// Of all that the search tried in a chosen effect's place, in the model `best` that stands, the rivals, refined as
/// that was, and the best few of the others, as the search fits them: scored on held-out windows, which chose none of
/// them. One that can't be fitted so is left out.
std::vector<RivalScore> rivalScores(const Chosen& chosen, const SearchResult& found, const Model& best,
                                    const Preparation& prepared, const SearchInput& input);

}  // namespace breakaway
