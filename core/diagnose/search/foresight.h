// How long windows may be in which a model's motion can still be foreseen from a noisy drive.
#pragma once

#include "diagnose/screen/screen.h"
#include "diagnose/search/model_fit.h"

namespace breakaway {

/// A rotor that falls from one well into the next can't be replayed for long from a measured current: noise grows, and
/// a perfect model errs by as much as one that lacks the wells. The length in s, from `split.window_s` downwards, at
/// which a perfect model's error is the smallest beside that of `base`, if `proposed`, base and what the
/// screen finds, were the rig; `split.window_s` itself as long as a perfect model errs less than `base` there.
double foreseeable(const SearchInput& input, const Model& base, const Model& proposed);

}  // namespace breakaway
