// One stroke of a linear axis, taken apart into the bins of its travel.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "friction/measurements.h"

namespace breakaway {

/// Equal bins side by side.
struct TravelBins {
  double from_m = 0.0, to_m = 0.0;
  size_t count = 0;

  double width_m() const { return (to_m - from_m) / static_cast<double>(count); }
  double centre_m(size_t bin) const { return from_m + (static_cast<double>(bin) + 0.5) * width_m(); }
};

/// Every tick of a stroke one way.
struct StrokeTrace {
  std::vector<double> position_m, current_A;
  double tick_s = 0.0;
  double windingTime_s = 0.0;  ///< L/R, by which the current follows a tick's voltage; 0: at once
  bool reachesFar = false;     ///< as below

  void clear() {
    position_m.clear();
    current_A.clear();
  }
};

/// Whether ± this time reaches so far into the bins beside one that a difference over it flattens what cogging makes of
/// the speed: by (ωT)²/6, which would look like friction that grows with speed. A second one over twice the time then
/// takes that off (Richardson), at `farNoise` times the rounding's noise.
inline bool reachesFar(double halfSpan_s, double speed_m_per_s, const TravelBins& bins) {
  return halfSpan_s * std::abs(speed_m_per_s) > 0.26 * bins.width_m();
}
inline constexpr double farNoise = 1.344;

/// What tells whether a stroke went steadily.
struct Steadiness {
  double perAmpere_m_per_s2 = 0.0;  ///< that the axis speeds up by; 0: nothing is told
  double noiseRms_A = 0.0;          ///< of one sample of the current
};

/// Adds to each bin that the stroke crossed from end to end its samples: current (its mean from the tick at which the
/// bin was entered to that at which it was left, as the winding lets it flow between samples), speed, and by how much
/// the speed grew, from the speeds at the bin's ends as central differences over ± `halfSpan_s` (and twice it, where
/// that reaches far). Bins in which it stood
/// or turned are left out, and those in which its speed swung by more than a third of itself, as the swings of the
/// current off its straight line move the axis: one that creeps and jumps from count to count passes through all
/// speeds, and its mean force isn't that of its mean speed.
void addStroke(const StrokeTrace& trace, const TravelBins& bins, double halfSpan_s, const Steadiness& steadiness,
               std::array<std::vector<TravelBinSums>, 2>& sums);

}  // namespace breakaway
