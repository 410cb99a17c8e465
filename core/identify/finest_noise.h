// How noisy a curve is, told by its own finest structure.
#pragma once

#include <vector>

namespace breakaway {

/// Standard deviation of the noise in each of a curve's equally spaced values, from the median power of its finest
/// two thirds of orders: friction has few harmonics there, noise has all. It tells what one turn's scatter can't, and
/// what all turns share that has no order. `around`: the last value is the first one's neighbour. 0 for fewer than 12
/// values.
double finestNoise(const std::vector<double>& values, bool around);

}  // namespace breakaway
