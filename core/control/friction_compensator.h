// Friction compensation by filtered torques, methods A and B. Freestanding; the board runs them too.
#pragma once

#include "observer/disturbance_observer.h"
#include "observer/reaction_torque_observer.h"

namespace breakaway {

/// Method A: what the disturbance observer sees and the reaction torque observer doesn't is friction.
template <typename Scalar>
class DifferenceCompensator {
 public:
  void configure(const typename DisturbanceObserver<Scalar>::Settings& settings, Scalar tick_s) {
    disturbance_.configure(settings, tick_s);
    reaction_.configure({settings, Scalar(0), Scalar(0)}, tick_s);
  }
  void reset(Scalar velocity_rad_per_s) {
    disturbance_.reset(velocity_rad_per_s);
    reaction_.reset(velocity_rad_per_s);
  }
  /// Once per tick; returns the compensating torque in Nm towards growing angle.
  Scalar step(Scalar current_A, Scalar velocity_rad_per_s, Scalar friction_Nm) {
    return disturbance_.step(current_A, velocity_rad_per_s) -
           reaction_.step(current_A, velocity_rad_per_s, friction_Nm);
  }

 private:
  DisturbanceObserver<Scalar> disturbance_;
  ReactionTorqueObserver<Scalar> reaction_;
};

/// Method B: current and speed cancel in method A, and g/(s+g) of the friction model is left.
template <typename Scalar>
class FilteredCompensator {
 public:
  /// Cutoff 0: the model's torque as it is, without the filter's lag.
  void configure(Scalar cutoff_rad_per_s, Scalar tick_s) {
    filters_ = cutoff_rad_per_s > Scalar(0);
    share_ = filters_ ? Scalar(1) - exponential<Scalar>(-cutoff_rad_per_s * tick_s) : Scalar(1);
  }
  void reset() { state_ = 0; }
  /// Once per tick; returns the compensating torque in Nm towards growing angle.
  Scalar step(Scalar friction_Nm) {
    if (!filters_) return state_ = friction_Nm;
    state_ += share_ * (friction_Nm - state_);
    return state_;
  }

 private:
  bool filters_ = false;
  Scalar share_ = 1, state_ = 0;
};

}  // namespace breakaway
