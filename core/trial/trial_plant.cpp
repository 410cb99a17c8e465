#include "trial/trial_plant.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

double sign(double x) {
  return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
}

double valueOf(const TrialWave& wave, double position, double shift = 0.0) {
  if (wave.amplitude == 0.0) return 0.0;
  return wave.amplitude * std::cos(wave.order * position - wave.phase_rad - shift);
}

}  // namespace

TrialPlant::TrialPlant(const TrialPhysics& physics, double step_s, std::uint64_t seed)
    : physics_(physics), step_s_(step_s), random_(seed) {
  inputs_.assign(static_cast<size_t>(std::lround(physics.delay_s / step_s)) + 1, 0.0);
  noiseEvery_ = std::max(1, static_cast<int>(std::lround(1e-3 / step_s)));
}

void TrialPlant::set(double position, double velocity, double current) {
  position_ = loadPosition_ = position;
  velocity_ = loadVelocity_ = velocity;
  current_ = current;
  acceleration_ = 0.0;
}

/// The input as it reaches the plant: late, clipped, too slow.
double TrialPlant::acting(double input) {
  newest_ = newest_ + 1 == inputs_.size() ? 0 : newest_ + 1;
  inputs_[newest_] = input;
  double u = inputs_[newest_ + 1 == inputs_.size() ? 0 : newest_ + 1];
  if (physics_.inputLimit > 0.0) u = std::clamp(u, -physics_.inputLimit, physics_.inputLimit);
  if (physics_.inputSlewPerS > 0.0) {
    const double reach = physics_.inputSlewPerS * step_s_;
    slewed_ += std::clamp(u - slewed_, -reach, reach);
    u = slewed_;
  }
  return u;
}

void TrialPlant::advanceWindings(double voltage) {
  const TrialPhysics& p = physics_;
  double v = voltage;
  if (p.sagResistance_ohm > 0.0) {
    v *= 1.0 - p.sagResistance_ohm * std::max(0.0, voltage * current_) / (p.supply_V * p.supply_V);
  }
  if (p.deadTime_V != 0.0) v -= p.deadTime_V * std::tanh(current_ / p.deadTimeCurrent_A);
  v -= p.torqueConstant * (1.0 + valueOf(p.ripple, position_)) * velocity_;
  const double resistance = p.resistance_ohm * (1.0 + heat_);
  const double slope = p.inductance_H / step_s_;
  const double before = current_;
  current_ = (current_ * (slope - 0.5 * resistance) + v) / (slope + 0.5 * resistance);
  if (p.heatingPerJoule > 0.0) {
    const double loss = resistance * before * before;
    heat_ += step_s_ * (p.heatingPerJoule * loss - heat_ / p.heatingTime_s);
  }
}

double TrialPlant::torqueOfMotor(double torque) const {
  const TrialPhysics& p = physics_;
  double out = torque * (1.0 + valueOf(p.ripple, position_));
  if (p.saturationTorque > 0.0) out = p.saturationTorque * std::tanh(out / p.saturationTorque);
  if (p.outside.deadBand > 0.0) out -= std::clamp(out, -p.outside.deadBand, p.outside.deadBand);
  return out;
}

/// What opposes growing position whatever the direction of motion.
double TrialPlant::loadTorque(double position, double velocity) const {
  const TrialPhysics& p = physics_;
  double load = p.constantLoad - valueOf(p.imbalance, position) - valueOf(p.cogging, position) - noise_ - wander_;
  if (p.gravityTorque > 0.0) load += p.gravityTorque * std::sin(position - p.downAngle_rad);
  if (p.stops) {
    const double beyond = position > p.highStop  ? position - p.highStop
                          : position < p.lowStop ? position - p.lowStop
                                                 : 0.0;
    const double push = p.stopStiffness * beyond + (beyond != 0.0 ? p.stopDamping * velocity : 0.0);
    if (push * beyond > 0.0) load += push;
  }
  if (p.disturbance != 0.0) {
    const double since = time_s() - p.disturbanceStart_s;
    if (since >= 0.0 && since < p.disturbanceLength_s) load += p.disturbance;
  }
  const TrialOutside& o = p.outside;
  if (o.whirl.amplitude != 0.0) {
    const double ratio = velocity / o.whirlSpeed;
    load -= valueOf(o.whirl, position) * ratio * ratio;
  }
  load -= valueOf(o.slippingDetent, position, o.detentSlip_s * velocity);
  return load;
}

/// The level of friction while it moves in `direction` at `velocity`, 0 or more.
double TrialPlant::slidingFriction(double direction, double position, double velocity) const {
  const TrialFriction& f = physics_.friction;
  const TrialOutside& o = physics_.outside;
  const double speed = std::abs(velocity);
  double level = f.coulomb * (1.0 + breathing_) + 0.5 * direction * f.asymmetry + f.quadratic * speed * speed;
  level += (f.viscous + 0.5 * direction * f.viscousAsymmetry + valueOf(f.viscousOverAngle, position)) * speed;
  if (f.stribeckExcess != 0.0) {
    level += f.stribeckExcess * std::exp(-std::pow(speed / f.stribeckSpeed, f.stribeckExponent));
  }
  level += valueOf(f.overAngle, position) + f.ofLoad * std::abs(driveTorque_);
  level += f.warmupExcess * warmup_;
  if (burst_s_ > 0.0) level += o.bursts;
  if (o.lag != 0.0) level += o.lag * (speed - laggedSpeed_);
  return std::max(level, 0.02 * f.coulomb);
}

double TrialPlant::shaftTorque() const {
  const TrialPhysics& p = physics_;
  const double twist = position_ - loadPosition_ + 0.5 * step_s_ * (velocity_ - loadVelocity_);
  const double play = twist - std::clamp(twist, -0.5 * p.gap, 0.5 * p.gap);
  if (p.gap > 0.0 && play == 0.0) return 0.0;
  const double torque = p.shaftStiffness * play + p.shaftDamping * (velocity_ - loadVelocity_);
  return p.gap > 0.0 && torque * play < 0.0 ? 0.0 : torque;  // teeth push, they don't pull
}

/// LuGre's friction torque at the present velocity; advances the bristles implicitly.
double TrialPlant::gentleFriction(double level) {
  const TrialFriction& f = physics_.friction;
  const double viscous = f.viscous * std::abs(velocity_);
  const double dry = std::max(level - viscous, 1e-12);
  const double before = bristle_;
  bristle_ = (bristle_ + step_s_ * velocity_) / (1.0 + step_s_ * f.stiffness * std::abs(velocity_) / dry);
  return f.stiffness * bristle_ + f.damping * (bristle_ - before) / step_s_ + f.viscous * velocity_;
}

void TrialPlant::drawDisturbances() {
  const TrialOutside& o = physics_.outside;
  const double dt = noiseEvery_ * step_s_;
  noise_ = physics_.processNoise > 0.0 ? physics_.processNoise * random_.normal() : 0.0;
  if (o.wander > 0.0) {
    const double keep = std::exp(-dt / o.wanderTime_s);
    wander_ = keep * wander_ + std::sqrt(1.0 - keep * keep) * o.wander * random_.normal();
  }
  if (o.bursts != 0.0) {
    burst_s_ -= dt;
    if (burst_s_ <= 0.0 && random_.uniform() < dt / o.burstEvery_s) {
      burst_s_ = o.burstLength_s * (0.5 + random_.uniform());
    }
  }
  if (o.lag != 0.0) laggedSpeed_ += dt / o.lagTime_s * (std::abs(velocity_) - laggedSpeed_);
  if (o.breathing != 0.0) breathing_ = o.breathing * std::sin(6.283185307179586 * time_s() / o.breathingPeriod_s);
  if (physics_.friction.warmupExcess != 0.0) warmup_ = std::exp(-time_s() / physics_.friction.warmupTime_s);
}

/// One step of sliding or sticking under rigid friction.
void TrialPlant::slide(double drive, double level, double holding) {
  if (velocity_ == 0.0 && std::abs(drive) <= holding) {
    acceleration_ = 0.0;
    rest_s_ += step_s_;
    return;
  }
  if (velocity_ == 0.0) {
    const TrialFriction& f = physics_.friction;
    restLevel_ = f.restExcess > 0.0 ? f.restExcess * (1.0 - std::exp(-rest_s_ / f.restTime_s)) : 0.0;
    rest_s_ = 0.0;
  }
  const double direction = velocity_ != 0.0 ? sign(velocity_) : sign(drive);
  acceleration_ = (drive - direction * (level + restLevel_)) / physics_.inertia;
  if (velocity_ == 0.0 && acceleration_ * direction <= 0.0) acceleration_ = 0.0;
  const double after = velocity_ + step_s_ * acceleration_;
  double moved = 0.5 * step_s_ * (velocity_ + after);
  if (velocity_ * after < 0.0 || (after == 0.0 && velocity_ != 0.0)) {  // it comes to rest within the step
    const double remaining_s = step_s_ + velocity_ / acceleration_;
    moved = -0.5 * velocity_ * velocity_ / acceleration_;
    const bool reverses = drive * direction < 0.0 && std::abs(drive) > holding;
    acceleration_ = reverses ? (drive + direction * level) / physics_.inertia : 0.0;
    velocity_ = acceleration_ * remaining_s;
    moved += 0.5 * velocity_ * remaining_s;
  } else {
    velocity_ = after;
  }
  position_ += moved;
  if (restLevel_ > 0.0) restLevel_ *= std::exp(-std::abs(moved) / physics_.friction.restTravel);
}

void TrialPlant::advance(double input, int steps) {
  const TrialPhysics& p = physics_;
  const TrialFriction& f = p.friction;
  for (int k = 0; k < steps; ++k) {
    if (steps_ % noiseEvery_ == 0) drawDisturbances();
    const double u = acting(input);
    if (p.electrical) advanceWindings(u);
    driveTorque_ = p.electrical ? p.torqueConstant * current_ : u;
    if (!p.electrical) current_ = u / p.torqueConstant;
    const double speed = velocity_ + 0.5 * step_s_ * acceleration_;
    const double place = position_ + 0.5 * step_s_ * velocity_;
    const double shaft = p.loadInertia > 0.0 ? shaftTorque() : 0.0;
    const double drive = torqueOfMotor(driveTorque_) - loadTorque(place, speed) - shaft;
    const double direction = velocity_ != 0.0 ? sign(velocity_) : sign(drive);
    const double level = slidingFriction(direction, place, speed);
    if (p.loadInertia > 0.0) {
      const double before = loadVelocity_;
      loadVelocity_ += step_s_ * shaft / p.loadInertia;
      loadPosition_ += 0.5 * step_s_ * (before + loadVelocity_);
    }
    if (f.stiffness > 0.0) {
      const double before = velocity_;
      acceleration_ = (drive - gentleFriction(level)) / p.inertia;
      velocity_ += step_s_ * acceleration_;
      position_ += 0.5 * step_s_ * (before + velocity_);
    } else {
      const double risen =
          velocity_ == 0.0 && f.restExcess > 0.0 ? f.restExcess * (1.0 - std::exp(-rest_s_ / f.restTime_s)) : 0.0;
      slide(drive, level, level + risen);
    }
    ++steps_;
  }
}

}  // namespace breakaway
