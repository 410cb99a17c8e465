// How far something may be raised before one of the things that were promised is lost.
#pragma once

#include <functional>
#include <string>

namespace breakaway {

struct Reach {
  double most = 0.0;   ///< without a loss; 0: there is one everywhere
  std::string heldBy;  ///< what is lost beyond it, in words; empty: nothing up to the highest value that was looked at
};

/// The upper end of the first stretch between `lowest` and `highest` without a loss that is met from below, to 0.2 %;
/// stretches shorter than a factor of 1.4 may be missed. `loss` says what is lost at a value, empty when nothing is.
Reach farthest(double lowest, double highest, const std::function<std::string(double)>& loss);

}  // namespace breakaway
