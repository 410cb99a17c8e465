#include "plant/command_path.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

CommandPath::CommandPath(const PlantPhysics& physics, double step_s)
    : inputs_(static_cast<size_t>(std::lround(physics.delay_s / step_s)) + 1, 0.0),
      limit_(physics.inputLimit),
      reach_(physics.inputSlew_per_s * step_s) {
}

double CommandPath::next(double commanded) {
  newest_ = newest_ + 1 == inputs_.size() ? 0 : newest_ + 1;
  inputs_[newest_] = commanded;
  double input = inputs_[newest_ + 1 == inputs_.size() ? 0 : newest_ + 1];
  if (limit_ > 0.0) input = std::clamp(input, -limit_, limit_);
  if (reach_ == 0.0) return input;
  slewed_ += std::clamp(input - slewed_, -reach_, reach_);
  return slewed_;
}

}  // namespace breakaway
