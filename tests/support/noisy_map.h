// A friction map as a rotor leaves it: one wave a turn, the same noise in every bin, and a place that may stand out.
#pragma once

#include <cmath>
#include <random>

#include "friction/friction_map.h"

namespace breakaway::test {

constexpr double mapNoise_Nm = 2e-4;

inline FrictionMap noisyMap(double mean_Nm, unsigned seed, size_t bins = 90, double bump_Nm = 0.0) {
  FrictionMap map;
  map.rig = "rig";
  map.turns = 1;
  map.totalVelocity_rad_per_s = 1.0;
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, mapNoise_Nm);
  for (size_t k = 0; k < bins; ++k) {
    MapBin bin;
    bin.angle_rad = (static_cast<double>(k) + 0.5) * turn_rad / static_cast<double>(bins);
    const bool there = bin.angle_rad > 2.0 && bin.angle_rad < 2.4;
    const double friction_Nm = mean_Nm * (1.0 + 0.1 * std::cos(bin.angle_rad)) + (there ? bump_Nm : 0.0);
    for (WayBin& way : bin.way) {
      way.static_Nm = {friction_Nm + noise(random), mapNoise_Nm};
      way.coulomb_Nm = {0.8 * friction_Nm + noise(random), mapNoise_Nm};
      way.viscous_Nm_s_per_rad = {1e-5, 1e-7};
      way.total_Nm = way.coulomb_Nm.value;
      way.samples = 2;
    }
    map.bins.push_back(bin);
  }
  map.coulombAverage_Nm = {0.8 * mean_Nm, 0.01 * mean_Nm};
  map.viscousAverage_Nm_s_per_rad = {1e-5, 1e-7};
  return map;
}

}  // namespace breakaway::test
