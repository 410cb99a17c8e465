// What pulls a shaft besides its motor and its friction: a load, an arm.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/estimate.h"
#include "base/message.h"
#include "friction/friction_map.h"

namespace breakaway {

/// A torque that acts once per turn, the same both ways.
struct ArmTorque {
  Estimate amplitude_Nm;
  double down_rad = 0.0;  ///< angle from the index at which it hangs still, in [0, 2π)
};

struct ShaftLoad {
  std::optional<Estimate> constant_Nm;  ///< towards growing angle; N on a linear axis
  std::optional<ArmTorque> arm;
};

/// Half the difference of both ways' whole torques is what acts the same both ways; its mean and its first harmonic,
/// where breakaways and moving friction agree about it within a third, and it is more than a fifth of the mean Coulomb
/// friction: friction that isn't the same both ways makes less. The value is that of the map's position torque.
/// `zeroError_Nm`: of the current sensor's zero, as a torque; `scaleError`: of all torques, relative.
ShaftLoad shaftLoad(const FrictionMap& map, double zeroError_Nm, double scaleError = 0.0);

/// One sentence each, with size, interval and direction.
std::vector<Message> wordsOf(const ShaftLoad& load, Axis axis);

}  // namespace breakaway
