// A rig's torques around the rotor, with the concealed effects that are functions of the angle alone folded in.
#pragma once

#include "plant/rig.h"

namespace breakaway {

/// What friction and position torque are at one rotor angle; indexed by Way.
struct RigTorques {
  std::array<double, 2> static_Nm{};
  std::array<double, 2> coulomb_Nm{};
  std::array<double, 2> viscous_Nm_s_per_rad{};
  double position_Nm = 0.0;  ///< towards growing angle; includes a constant load
};

/// The torques at `angle_rad` from the index. Time-dependent effects are taken at their warm, long-rested end. Friction
/// is never below zero.
RigTorques torquesAt(const Rig& rig, double angle_rad);

/// The highest harmonic order in the rig, at least 1; how fine a table must be.
int highestOrder(const Rig& rig);

}  // namespace breakaway
