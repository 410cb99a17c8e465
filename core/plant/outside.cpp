#include "plant/outside.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace breakaway {

Outside::Outside(const OutsidePhysics& physics, double step_s, std::uint64_t seed)
    : physics_(physics),
      step_s_(step_s),
      every_(std::max(1, static_cast<int>(std::lround(1e-3 / step_s)))),
      random_(seed) {
}

void Outside::step(double time_s, double velocity) {
  if (steps_++ % every_ != 0) return;
  const OutsidePhysics& o = physics_;
  const double dt = every_ * step_s_;
  noise_ = o.noise > 0.0 ? o.noise * random_.normal() : 0.0;
  if (o.wander > 0.0) {
    const double keep = std::exp(-dt / o.wanderTime_s);
    wander_ = keep * wander_ + std::sqrt(1.0 - keep * keep) * o.wander * random_.normal();
  }
  if (o.bursts != 0.0) {
    burst_s_ -= dt;
    if (burst_s_ <= 0.0 && random_.uniform() < dt / o.burstEvery_s)
      burst_s_ = o.burstLength_s * (0.5 + random_.uniform());
  }
  if (o.lag != 0.0) laggedSpeed_ += dt / o.lagTime_s * (std::abs(velocity) - laggedSpeed_);
  if (o.breathing != 0.0) breathing_ = o.breathing * std::sin(turn_rad * time_s / o.breathingPeriod_s);
}

double Outside::torque(double angle_rad, double velocity) const {
  const OutsidePhysics& o = physics_;
  double torque = noise_ + wander_;
  if (o.whirl.amplitude != 0.0) {
    const double ratio = velocity / o.whirlSpeed;
    torque += o.whirl.at(angle_rad) * ratio * ratio;
  }
  if (const Harmonic& d = o.slippingDetent; d.amplitude != 0.0)
    torque += Harmonic{d.order, d.amplitude, d.phase_rad + o.detentSlip_s * velocity}.at(angle_rad);
  return torque;
}

double Outside::friction(double speed, double coulomb) const {
  return coulomb * breathing_ + (burst_s_ > 0.0 ? physics_.bursts : 0.0) + physics_.lag * (speed - laggedSpeed_);
}

double Outside::passedOn(double torque) const {
  return torque - std::clamp(torque, -physics_.deadBand, physics_.deadBand);
}

}  // namespace breakaway
