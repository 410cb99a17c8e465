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

  int bins = 0;                                 ///< 0: no friction is known
  Scalar index_rad = 0;                         ///< angle of the index as the encoder counts it
  Scalar perRad = Scalar(0.15915494309189535);  ///< one over what the bins cover from there: a turn, or a travel
  Scalar blend_rad_per_s =
      0;  ///< up to this speed the Coulomb torque grows in proportion, so that noise can't shake it
  Scalar stribeck_rad_per_s = 0;  ///< speed over which friction falls from static to Coulomb; 0: static isn't known
  Scalar coulomb_Nm[2][mostBins] = {};
  Scalar viscous_Nm_s_per_rad[2][mostBins] = {};
  Scalar static_Nm[2][mostBins] = {};  ///< that starts motion from standstill

  /// What the motor must give to take friction and position torque off the shaft, in Nm towards growing angle:
  /// ½(C_ccw − C_cw) + s·½(C_ccw + C_cw) + B·ω, s the way within ±1. `intent`, within ±1, is the way that the rotor is
  /// to go: while it stands that decides instead of its speed, and as far as it does, friction is the static one on
  /// the rotor's way from standstill: C + (S − C)·|intent|·fallen(ω). Without intent nothing is pushed from rest.
  Scalar torque_Nm(Scalar angle_rad, Scalar velocity_rad_per_s, Scalar intent = Scalar(0)) const {
    if (bins <= 0) return Scalar(0);
    const Place place = placeOf(angle_rad);
    const Scalar viscous = at(viscous_Nm_s_per_rad[velocity_rad_per_s < Scalar(0) ? 0 : 1], place);
    const Scalar moved = wayOf(velocity_rad_per_s), still = Scalar(1) - (moved < Scalar(0) ? -moved : moved);
    return dryTorque_Nm(place, moved + still * intent, risingPart(velocity_rad_per_s, intent)) +
           viscous * velocity_rad_per_s;
  }

  /// The same for a rotor that is to turn at the target and has come to `velocity_rad_per_s` so far: friction of the
  /// target's speed, whatever the measured speed's noise, but static as long as the rotor is slow.
  Scalar movingTorque_Nm(Scalar angle_rad, Scalar target_rad_per_s, Scalar velocity_rad_per_s) const {
    if (bins <= 0) return Scalar(0);
    const Place place = placeOf(angle_rad);
    const Scalar viscous = at(viscous_Nm_s_per_rad[target_rad_per_s < Scalar(0) ? 0 : 1], place);
    const Scalar way = wayOf(target_rad_per_s);
    return dryTorque_Nm(place, way, risingPart(velocity_rad_per_s, way)) + viscous * target_rad_per_s;
  }

  /// Coulomb friction at an angle, the mean of both ways.
  Scalar friction_Nm(Scalar angle_rad) const {
    const Place place = placeOf(angle_rad);
    return Scalar(0.5) * (at(coulomb_Nm[0], place) + at(coulomb_Nm[1], place));
  }

 private:
  struct Place {
    int low, high;
    Scalar part;
  };

  /// How much of the step from Coulomb to static friction is there: exp(−x²), x the speed over the Stribeck speed, as
  /// (1 − x²/4)⁴, which no board needs a library for; it ends at x = 2 and errs by 0.08 at most. None while the rotor
  /// still turns the other way.
  Scalar risingPart(Scalar velocity_rad_per_s, Scalar intent) const {
    if (!(stribeck_rad_per_s > Scalar(0)) || intent == Scalar(0)) return Scalar(0);
    const Scalar along = intent > Scalar(0) ? velocity_rad_per_s : -velocity_rad_per_s;
    if (along < -blend_rad_per_s || along >= Scalar(2) * stribeck_rad_per_s) return Scalar(0);
    const Scalar x = along / stribeck_rad_per_s, y = Scalar(1) - Scalar(0.25) * x * x;
    return (intent > Scalar(0) ? intent : -intent) * y * y * y * y;
  }

  Scalar dryTorque_Nm(const Place& place, Scalar way, Scalar rising) const {
    Scalar cw = at(coulomb_Nm[0], place), ccw = at(coulomb_Nm[1], place);
    if (rising > Scalar(0)) {
      cw += rising * (at(static_Nm[0], place) - cw);
      ccw += rising * (at(static_Nm[1], place) - ccw);
    }
    return Scalar(0.5) * (ccw - cw) + Scalar(0.5) * (ccw + cw) * way;
  }

  Scalar wayOf(Scalar velocity_rad_per_s) const {
    if (velocity_rad_per_s >= blend_rad_per_s) return velocity_rad_per_s > Scalar(0) ? Scalar(1) : Scalar(0);
    if (velocity_rad_per_s <= -blend_rad_per_s) return Scalar(-1);
    return velocity_rad_per_s / blend_rad_per_s;
  }

  Place placeOf(Scalar angle_rad) const {
    if (bins == 1) return {0, 0, Scalar(0)};
    const Scalar turns = (angle_rad - index_rad) * perRad;
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
