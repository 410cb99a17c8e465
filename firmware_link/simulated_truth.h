// What a simulated rig really has: read from its rig file, never from a drive. For truth.csv and for tests.
#pragma once

#include <string>

#include "base/result.h"
#include "friction/friction_map.h"

namespace breakaway {

/// The plant's true map at the bins' centres, in the meaning of a measured one: static and Coulomb are whole motor
/// torques, so position torque is in them. `uri` as for openDrive(). Standard errors are zero.
Result<FrictionMap> trueMap(const std::string& uri, size_t bins, double totalVelocity_rad_per_s);

/// The same at the bins of a measured map, and at its velocity.
Result<FrictionMap> trueMap(const std::string& uri, const FrictionMap& measured);

}  // namespace breakaway
