// The coupling between a simulated rig's motor and what sits behind it: load and encoder.
#pragma once

#include "base/axis.h"

namespace breakaway {

class JsonObject;

/// A spring and a damper that act beyond half the play either way; all on the rig's shaft.
struct RigCoupling {
  double stiffness_Nm_per_rad = 0.0;  ///< 0: motor and encoder sit on one stiff shaft
  double damping_Nm_s_per_rad = 0.0;
  double loadInertia_kg_m2 = 0.0;
  double gap_rad = 0.0;  ///< play, from one flank to the other

  bool present() const { return stiffness_Nm_per_rad > 0.0; }
  /// Of motor and load against each other, undamped and without play: √(k·(1/J + 1/J_load)).
  double resonance_rad_per_s(double motorInertia_kg_m2) const;
  /// What the motor's side passes on to the load's, `twist_rad` being motor less load, `slip_rad_per_s` its rate.
  double torque_Nm(double twist_rad, double slip_rad_per_s) const;
};

/// The field `coupling` of a rig file, with the names of its axis and one rad of the shaft being `unitPerRad` of it;
/// not present when it is missing. What is wrong becomes a fault of `root`.
RigCoupling readCoupling(JsonObject& root, Axis axis, double unitPerRad, double motorInertia_kg_m2);

}  // namespace breakaway
