// One part of a long list of jobs, so that several processes share them.
#pragma once

#include <cstddef>
#include <string>

#include "base/result.h"

namespace breakaway {

/// Every `count`-th job, beginning with the `index`-th; counted from 1.
struct Shard {
  size_t index = 1;
  size_t count = 1;

  /// Whether job `k`, counted from 0, is one of this part's.
  bool holds(size_t k) const { return k % count == index - 1; }
};

/// Reads "I/N" with 1 ≤ I ≤ N.
Result<Shard> parseShard(const std::string& text);

}  // namespace breakaway
