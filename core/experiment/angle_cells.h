// Means over a bin's angle, where the speed within it isn't even.
#pragma once

#include <cstddef>
#include <vector>

#include "friction/measurements.h"

namespace breakaway {

/// Of an encoder's line: they are of unequal width, where its two tracks aren't a quarter of a line apart, and the
/// loop, which takes that for speed, answers one in the next.
inline constexpr double countsPerLine = 4.0;

/// How many cells a bin has: as many as divide its counts into whole lines, up to a limit; fewer where `samples` of the
/// whole run are too few for each to get its part. 1 where bins don't hold whole lines.
size_t cellsPerBin(double countsPerRev, size_t bins, double samples);

/// Over a turn position torque does no work, and a current's mean over the angle is friction's alone. Its mean over
/// time isn't: cogging makes the rotor slow where it has to be overcome, and so that is there for longer. How long the
/// rotor was in a cell is what the cell's samples count to: each cell's mean over time counts alike, and no speed is
/// differentiated.
class AngleCells {
 public:
  explicit AngleCells(size_t bins = 0, size_t perBin = 1) : perBin_(perBin), sums_(bins * perBin) {}

  /// `place`: in bins, from the first one's beginning on.
  void add(size_t bin, double place, double amps, double rad_per_s);
  /// The bins' sums, in which each cell counts as much as the others by its samples in `all`, the whole run's; bins
  /// with a cell that is empty there, over time.
  std::vector<AngleBinSums> bins(const AngleCells& all) const;

 private:
  size_t perBin_;
  std::vector<AngleBinSums> sums_;
};

}  // namespace breakaway
