#include "diagnose/verdict/block_maps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr size_t flips = 499;

/// The map's energy with the blocks' sums times `sign`.
double energyOf(const BlockMap& map, const std::vector<double>& sign) {
  double all = 0.0, strongest = 0.0, group = 0.0;
  for (size_t cell = 0; cell < map.sums.size(); ++cell) {
    if (map.together > 0 && cell % map.together == 0) group = 0.0;
    if (!(map.count[cell] > 0.0)) continue;
    const double sum = std::inner_product(sign.begin(), sign.end(), map.sums[cell].begin(), 0.0);
    all += sum * sum / map.count[cell];
    group += sum * sum / map.count[cell];
    strongest = std::max(strongest, group);
  }
  return map.together > 0 ? strongest : all;
}

}  // namespace

double BlockMap::sum(size_t cell) const {
  return std::accumulate(sums[cell].begin(), sums[cell].end(), 0.0);
}

double BlockMap::error(size_t cell) const {
  return std::sqrt(std::inner_product(sums[cell].begin(), sums[cell].end(), sums[cell].begin(), 0.0));
}

std::vector<Significance> significances(const std::vector<BlockMap>& maps, size_t blocks, std::uint64_t seed,
                                        size_t together) {
  std::vector<double> sign(blocks, 1.0), energy, centre, spread;
  energy.reserve(maps.size());
  for (const BlockMap& map : maps) energy.push_back(energyOf(map, sign));
  Random random(seed);
  std::vector<std::vector<double>> chance(maps.size());
  for (size_t flip = 0; flip < flips; ++flip) {
    for (size_t block = 0; block < blocks; ++block)
      sign[block] = block % together > 0 ? sign[block - 1] : random.bits() >> 63 ? 1.0 : -1.0;
    for (size_t m = 0; m < maps.size(); ++m) chance[m].push_back(energyOf(maps[m], sign));
  }
  std::vector<Significance> out(maps.size());
  for (size_t m = 0; m < maps.size(); ++m) {
    centre.push_back(mean(chance[m]));
    double squares = 0.0;
    for (const double one : chance[m]) squares += (one - centre[m]) * (one - centre[m]);
    spread.push_back(std::max(std::sqrt(squares / static_cast<double>(flips)), 1e-300));
    out[m].energy = std::max(0.0, energy[m] - centre[m]);
  }
  for (size_t m = 0; m < maps.size(); ++m) {
    size_t beaten = 0;
    for (size_t flip = 0; flip < flips; ++flip) {
      double most = -1e300;
      for (size_t j = 0; j < maps.size(); ++j) most = std::max(most, (chance[j][flip] - centre[j]) / spread[j]);
      beaten += most >= (energy[m] - centre[m]) / spread[m] ? 1 : 0;
    }
    out[m].pValue = static_cast<double>(1 + beaten) / static_cast<double>(1 + flips);
  }
  return out;
}

}  // namespace breakaway
