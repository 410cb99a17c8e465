// Friction compensation: the torque that takes friction off the shaft. Freestanding; the board runs it too.
#pragma once

#include "observer/disturbance_observer.h"
#include "observer/reaction_torque_observer.h"

namespace breakaway {

/// Friction around the rotor as a controller knows it: whole motor torques per way and angle bin, linear in between.
/// One bin is an average. Positive in the way's direction, index 0 falling angle (cw), 1 growing angle (ccw).
template <typename Scalar>
struct FrictionTable {
  static constexpr int mostBins = 256;

  int bins = 0;          ///< 0: no friction is known
  Scalar index_rad = 0;  ///< angle of the index as the encoder counts it
  Scalar blend_rad_per_s =
      0;  ///< up to this speed the Coulomb torque grows in proportion, so that noise can't shake it
  Scalar coulomb_Nm[2][mostBins] = {};
  Scalar viscous_Nm_s_per_rad[2][mostBins] = {};

  /// What the motor must give to take friction and position torque off the shaft, in Nm towards growing angle:
  /// ½(C_ccw − C_cw) + s·½(C_ccw + C_cw) + B·ω, s the way within ±1.
  Scalar torque_Nm(Scalar angle_rad, Scalar velocity_rad_per_s) const {
    if (bins <= 0) return Scalar(0);
    const Place place = placeOf(angle_rad);
    const Scalar cw = at(coulomb_Nm[0], place), ccw = at(coulomb_Nm[1], place);
    const Scalar viscous = at(viscous_Nm_s_per_rad[velocity_rad_per_s < Scalar(0) ? 0 : 1], place);
    return Scalar(0.5) * (ccw - cw) + Scalar(0.5) * (ccw + cw) * wayOf(velocity_rad_per_s) +
           viscous * velocity_rad_per_s;
  }

 private:
  struct Place {
    int low, high;
    Scalar part;
  };

  Scalar wayOf(Scalar velocity_rad_per_s) const {
    if (velocity_rad_per_s >= blend_rad_per_s) return velocity_rad_per_s > Scalar(0) ? Scalar(1) : Scalar(0);
    if (velocity_rad_per_s <= -blend_rad_per_s) return Scalar(-1);
    return velocity_rad_per_s / blend_rad_per_s;
  }

  Place placeOf(Scalar angle_rad) const {
    if (bins == 1) return {0, 0, Scalar(0)};
    const Scalar turns = (angle_rad - index_rad) * Scalar(0.15915494309189535);
    auto whole = static_cast<long>(turns);
    if (turns < Scalar(whole)) --whole;
    const Scalar place = (turns - Scalar(whole)) * Scalar(bins) + Scalar(bins) - Scalar(0.5);
    const int low = static_cast<int>(place);
    return {low % bins, (low + 1) % bins, place - Scalar(low)};
  }

  static Scalar at(const Scalar* values, const Place& place) {
    return values[place.low] + place.part * (values[place.high] - values[place.low]);
  }
};

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
    pole_ = cutoff_rad_per_s > Scalar(0) ? exponential<Scalar>(-cutoff_rad_per_s * tick_s) : Scalar(0);
  }
  void reset() { state_ = 0; }
  /// Once per tick; returns the compensating torque in Nm towards growing angle.
  Scalar step(Scalar friction_Nm) {
    state_ += (Scalar(1) - pole_) * (friction_Nm - state_);
    return state_;
  }

 private:
  Scalar pole_ = 0, state_ = 0;
};

}  // namespace breakaway
