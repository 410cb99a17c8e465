// A measured map against the truth.
#pragma once

#include <cmath>
#include <functional>

#include "friction/friction_map.h"

namespace breakaway::test {

/// RMS error over the bins and mean error, both parts of the true mean.
struct Deviation {
  double rms = 0.0;
  double mean = 0.0;
};

inline Deviation deviation(const FrictionMap& measured, const FrictionMap& truth, Way way,
                           const std::function<double(const WayBin&)>& value) {
  double squares = 0.0, sum = 0.0, level = 0.0;
  for (size_t k = 0; k < truth.bins.size(); ++k) {
    const double is = value(truth.bins[k].way[static_cast<size_t>(way)]);
    const double error = value(measured.bins[k].way[static_cast<size_t>(way)]) - is;
    squares += error * error;
    sum += error;
    level += is;
  }
  const auto n = static_cast<double>(truth.bins.size());
  return {std::sqrt(squares / n) / (level / n), sum / level};
}

inline double staticOf(const WayBin& bin) {
  return bin.static_Nm.value;
}
inline double coulombOf(const WayBin& bin) {
  return bin.coulomb_Nm.value;
}
inline double viscousOf(const WayBin& bin) {
  return bin.viscous_Nm_s_per_rad.value;
}

}  // namespace breakaway::test
