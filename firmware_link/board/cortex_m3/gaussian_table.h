// The fall of friction from static to Coulomb, e^(−x²), from a table. Freestanding.
#pragma once

#include "observer/disturbance_observer.h"

namespace breakaway {

/// e^(−x²) at x = 0 … 6 in 1024 steps.
struct GaussianTable {
  static constexpr int steps = 1024;
  static constexpr float perUnit = steps / 6.0f;
  float at[steps + 1] = {};

  constexpr GaussianTable() {
    for (int k = 0; k <= steps; ++k) {
      const double x = 6.0 * k / steps;
      at[k] = static_cast<float>(exponential(-x * x));
    }
  }
};

inline constexpr GaussianTable gaussianTable;

/// e^(−x²) for x ≥ 0 within 1e-5; 0 beyond 6.
inline float gaussianFall(float x) {
  const float place = x * GaussianTable::perUnit;
  if (!(place < static_cast<float>(GaussianTable::steps))) return 0.0f;
  const int low = static_cast<int>(place);
  return gaussianTable.at[low] +
         (place - static_cast<float>(low)) * (gaussianTable.at[low + 1] - gaussianTable.at[low]);
}

}  // namespace breakaway
