// The motions of two axes in one table.
#pragma once

#include <cmath>

namespace breakaway::test {

/// A motion to and fro of axis 1, another of the second, at row k; rad.
inline double angleOf(int axis, int k) {
  return axis == 1 ? 5.0 * std::sin(0.04 * k) : 40.0 + 0.3 * k;
}
/// rad/s, at 100 rows a second of the first.
inline double speedOf(int axis, int k) {
  return axis == 1 ? 20.0 * std::cos(0.04 * k) : 30.0;
}

}  // namespace breakaway::test
