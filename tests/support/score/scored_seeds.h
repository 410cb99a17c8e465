// Which seeds tune and which score: a search that was tuned on what it is scored on proves nothing.
#pragma once

#include <cstdint>

namespace breakaway {

struct SeedRange {
  std::uint64_t first;
  std::uint64_t last;
  constexpr bool holds(std::uint64_t seed) const { return seed >= first && seed <= last; }
};

/// For everyone who changes the search, and for the tests.
constexpr SeedRange tuningSeeds{1, 9999};
/// For the table in the manual alone.
constexpr SeedRange scoredSeeds{1000000, 1009999};
/// For one scoring at each release: nobody looks at single ones of them before.
constexpr SeedRange releaseSeeds{2000000, 2009999};

static_assert(tuningSeeds.last < scoredSeeds.first && scoredSeeds.last < releaseSeeds.first);

}  // namespace breakaway
