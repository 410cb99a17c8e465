// Means over the cells of a map and their significance, by sign flips of whole blocks of time across all maps at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace breakaway {

/// Sums of a residual over the cells of one map, kept apart by block of time. The residual's energy that lies in a
/// cell's mean is (Σ sums)²/count.
struct BlockMap {
  std::vector<std::vector<double>> sums;  ///< by cell, then by block
  std::vector<double> count;              ///< by cell
  size_t together = 0;  ///< 0: all cells' energy counts; else the strongest group of so many neighbouring cells

  double sum(size_t cell) const;
  /// Standard error of the sum, from the blocks.
  double error(size_t cell) const;
};

struct Significance {
  double energy = 0.0;  ///< of the map, less what chance gives
  double pValue = 1.0;  ///< that the strongest of all maps shows as much by chance
};

/// One per map. The blocks' signs are flipped for all maps alike, so that the family-wise p-value knows how the maps
/// depend on each other (P. Westfall, S. Young, 'Resampling-Based Multiple Testing', 1993: max-T); each map counts in
/// standard deviations of its own flips. `together`: neighbouring blocks whose signs flip as one, for a residual that
/// lasts longer than a block.
std::vector<Significance> significances(const std::vector<BlockMap>& maps, size_t blocks, std::uint64_t seed,
                                        size_t together = 1);

}  // namespace breakaway
