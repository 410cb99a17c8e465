// A load inertia behind a spring or a gap as it is simulated: what backlash and compliance share.
#pragma once

#include <span>
#include <string>

#include "diagnose/model/effect.h"

namespace breakaway {

/// The load is simulated in coordinates relative to the motor, so that its state outlives a restart:
///   δ = θ − θ_load,  J_load ω_load' = T − F_load sgn ω_load,
///   T/J_load = ω_a² (|δ| − gap/2) + 2 ζ ω_a |δ|'  towards the motor, in contact only, where a gap never pulls.
/// A load that rests goes on resting while |T| ≤ F_load. Given the motor's motion, T is linear in J_load at constant
/// ω_a and F_load/J_load.
/// Hidden state: δ in rad, δ' in rad/s, the motor's velocity in rad/s and the time in s, both as remembered last. Time
/// 0: nothing was remembered yet, and the load takes the motor's velocity.
class TwoMassEffect : public Effect, private LoadPart {
 public:
  const HiddenState* hidden() const final { return this; }
  const LoadPart* load() const final { return this; }
  /// T at `at`, whose memory may be older: the motor is taken to have changed its velocity evenly since.
  Term term(std::span<const double> p, const Situation& at) const final;
  /// A step that two inertias of any share up to 90 % take without a visible error.
  double longestStep_s(std::span<const double> p) const final;
  Written written(std::span<const double> p, Axis axis) const final;

 private:
  /// ω_a, ζ, half the gap and F_load/J_load of loadOf(), written down and separated by commas; J_load is p0.
  virtual std::string loadWritten() const = 0;
  size_t size() const final { return 4; }
  /// The motor's velocity changes evenly meanwhile. Stable for any dt_s.
  void remember(std::span<const double> p, const Situation& at, double dt_s, std::span<double> memory) const final;
  void place(double place, double speed, double velocity, double time_s, std::span<double> memory) const final;
};

/// The highest ω_a in rad/s that is simulated; contact that is stiffer is taken as this stiff.
inline constexpr double highestFrequency = 5e3;

/// A load inertia that is a part of the whole one.
bool plausibleLoad(double inertia, const Excitation& seen);

}  // namespace breakaway
