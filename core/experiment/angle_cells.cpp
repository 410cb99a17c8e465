#include "experiment/angle_cells.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {
constexpr size_t mostPerBin = 8;
constexpr double fewestSamples = 10.0;  // that a cell should get in a run
}  // namespace

size_t cellsPerBin(double countsPerRev, size_t bins, double samples) {
  if (!(countsPerRev > 0.0) || bins == 0) return 1;
  const double perBin = countsPerRev / static_cast<double>(bins), room = samples / static_cast<double>(bins);
  for (size_t cells = mostPerBin; cells > 1; --cells) {
    const auto n = static_cast<double>(cells);
    if (std::fmod(perBin, n * countsPerLine) == 0.0 && room >= n * fewestSamples) return cells;
  }
  return 1;
}

void AngleCells::add(size_t bin, double place, double amps, double rad_per_s) {
  const double within = (place - std::floor(place)) * static_cast<double>(perBin_);
  sums_[bin * perBin_ + std::min(perBin_ - 1, static_cast<size_t>(within))].add(amps, rad_per_s);
}

std::vector<AngleBinSums> AngleCells::bins(const AngleCells& all) const {
  std::vector<AngleBinSums> bins(sums_.size() / perBin_);
  for (size_t k = 0; k < bins.size(); ++k) {
    const auto first = static_cast<std::ptrdiff_t>(k * perBin_), end = first + static_cast<std::ptrdiff_t>(perBin_);
    const bool seen = std::all_of(all.sums_.begin() + first, all.sums_.begin() + end,
                                  [](const AngleBinSums& cell) { return cell.samples > 0; });
    double weights = 0.0, current_A = 0.0, velocity_rad_per_s = 0.0;
    for (size_t j = k * perBin_; j < (k + 1) * perBin_; ++j) {
      bins[k].add(sums_[j]);
      if (!seen) continue;
      const double weight = 1.0 / static_cast<double>(all.sums_[j].samples);
      weights += weight * static_cast<double>(sums_[j].samples);
      current_A += weight * sums_[j].current_A;
      velocity_rad_per_s += weight * sums_[j].velocity_rad_per_s;
    }
    if (!(weights > 0.0)) continue;
    const double scale = static_cast<double>(bins[k].samples) / weights;
    bins[k].current_A = scale * current_A;
    bins[k].velocity_rad_per_s = scale * velocity_rad_per_s;
  }
  return bins;
}

}  // namespace breakaway
