// The physics that a foreign rig has and its bench file doesn't tell.
#pragma once

#include <limits>
#include <vector>

namespace breakaway::test {

inline constexpr double never = std::numeric_limits<double>::infinity();

struct Wave {
  double amplitude;
  int order;
  double phase;
};
struct Push {
  double from_s, until_s, torque;
};

/// What the bench doesn't tell; zero where it isn't there.
struct Concealed {
  double loadInertia = 0.0, play = 0.0, stiffness = 0.0, damping = 0.0, loadFriction = 0.0;  ///< behind the motor
  double stopStiffness = 0.0, stopDamping = 0.0, high = never;
  double late_s = 0.0;
  double stribeck = 0.0, stribeckSpeed = 1.0;
  double bristle = 0.0;  ///< stiffness of elastic friction
  double load = 0.0, arm = 0.0, armDown = 0.0;
  std::vector<Wave> detents, uneven;
  double ofTorque = 0.0;  ///< friction by what is transmitted
  double deadVolts = 0.0, source_ohm = 0.0;
  double warming = 0.0, warming_s = 10.0;
  double drag = 0.0, saturation = 0.0;
  double discOff = 0.0, discAt = 0.0;
  std::vector<Push> pushes;
  // What the catalogue lacks.
  double deadTorque = 0.0, clutch = never;
  double breathing = 0.0, breathing_s = 1.0;
  double catching = 0.0, catchWidth = 1.0, catchAt = 0.0;
  double above = 0.0, aboveSpeed = 1.0;
  double thinning = 0.0, thinning_s = 1.0, thinningSpeed = 1.0;
};

}  // namespace breakaway::test
