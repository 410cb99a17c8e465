// Whether what a search found stands: what it explains, and what held-out data say to it.
#pragma once

#include <vector>

#include "diagnose/fit/preparation.h"
#include "diagnose/search/search.h"
#include "diagnose/verdict/finding.h"
#include "diagnose/verdict/fit_score.h"
#include "diagnose/verdict/proof.h"
#include "diagnose/verdict/remainder.h"

namespace breakaway {

/// What stands of a search.
struct Judgement {
  Model base, model;  ///< the same where nothing stands
  std::vector<Finding> findings;
  FitScore fit;
  Proof proof;
  Remainder rest;
};

/// Decisions rest on training windows; the worst tenth, which a restart at the edge of standstill may rule, is left
/// out. Held-out data choose nothing, but they may refuse: then the least important finding goes, and what is left is
/// judged again.
Judgement judge(const Bench& bench, const Preparation& prepared, const SearchInput& input, const SearchResult& found);

}  // namespace breakaway
