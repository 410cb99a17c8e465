// A load inertia behind a spring with damping and, maybe, a gap: what backlash and compliance share.
#pragma once

#include <span>

#include "diagnose/model/effect.h"

namespace breakaway {

/// The load is simulated in coordinates relative to the motor, so that its state outlives a restart:
///   δ = θ − θ_load,  J_load ω_load' = T − F_load sgn ω_load,
///   T/J_load = ω_a² (|δ| − gap/2) + 2 ζ ω_a |δ|'  towards the motor, in contact only, where a gap never pulls.
/// A load that rests goes on resting while |T| ≤ F_load. Given the motor's motion, T is linear in J_load at constant
/// ω_a and F_load/J_load.
struct TwoMass {
  double inertia = 0.0;       ///< J_load, kg m²
  double frequency = 0.0;     ///< ω_a = √(k/J_load), the antiresonance, rad/s
  double dampingRatio = 0.0;  ///< ζ
  double halfGap = 0.0;       ///< rad
  double friction = 0.0;      ///< F_load, Nm: Coulomb's, on the load's side; only where there is no gap
};

/// Hidden state: δ in rad, δ' in rad/s, the motor's velocity in rad/s and the time in s, both as remembered last. Time
/// 0: nothing was remembered yet, and the load takes the motor's velocity.
inline constexpr size_t twoMassMemory = 4;

/// The highest ω_a in rad/s that is simulated; contact that is stiffer is taken as this stiff.
inline constexpr double highestFrequency = 5e3;

/// T at `at`, whose memory may be older: the motor is taken to have changed its velocity evenly since.
Term twoMassTerm(const TwoMass& load, const Situation& at);
/// Advances the hidden state by dt_s with the motor's velocity changing evenly. Stable for any dt_s.
void twoMassRemember(const TwoMass& load, const Situation& at, double dt_s, std::span<double> memory);
void placeTwoMass(double deflection, double speed, double velocity, double time_s, std::span<double> memory);
/// A step that two inertias of any share up to 90 % take without a visible error.
double twoMassStep_s(const TwoMass& load);
/// 2π/ω_a, s.
double twoMassPeriod_s(const TwoMass& load);
/// A load inertia that is a part of the whole one.
bool plausibleLoad(double inertia, const Excitation& seen);

}  // namespace breakaway
