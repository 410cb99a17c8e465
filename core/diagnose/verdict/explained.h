// What findings say of the torque that a base model leaves, over a map's axis: the law behind the cells.
#pragma once

#include <vector>

#include "diagnose/verdict/where.h"

namespace breakaway {

/// Points of a curve; NaN in `value` is a gap.
struct Course {
  std::vector<double> at;     ///< on the map's axis, in its unit
  std::vector<double> value;  ///< Nm, N or V, as the map has it
};

/// What effects make of the torque along the recorded motion, `model` having them and `without` not: less what a base
/// model takes up of it as friction and inertia when it is fitted without them (least squares on the direction, the
/// speed and the acceleration), averaged in parts of the map's cells that hold a mean. It has no noise of the sensors:
/// the drive, which both need alike, is in neither. Precondition: a map of all speeds, not over frequency.
Course explainedOver(const ResidualMap& map, const Model& without, const Model& model,
                     const std::vector<Track>& tracks);

}  // namespace breakaway
