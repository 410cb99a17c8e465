// The way of a command to the plant: late, clipped, too slow.
#pragma once

#include <cstddef>
#include <vector>

#include "plant/physics.h"

namespace breakaway {

/// What reaches the plant in each step of what was commanded, by PlantPhysics::delay_s, inputLimit and inputSlew_per_s.
class CommandPath {
 public:
  CommandPath(const PlantPhysics& physics, double step_s);

  double next(double commanded);

 private:
  std::vector<double> inputs_;  ///< ring of past inputs, one per step
  size_t newest_ = 0;
  double limit_, reach_, slewed_ = 0.0;
};

}  // namespace breakaway
