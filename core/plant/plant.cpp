#include "plant/plant.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr int cellsPerOrder = 256;  // linear interpolation errs by 8e-5 of a harmonic's amplitude
constexpr double heatStep_s = 0.01;

/// A stop pushes back, and never pulls.
template <typename Stop>
double pushBack(const Stop& stop, double beyond, double velocity) {
  const double torque = -stop.stiffness * beyond - stop.damping * velocity;
  return torque * beyond < 0.0 ? torque : 0.0;
}

}  // namespace

Plant::Plant(const PlantPhysics& physics, double substep_s, uint64_t seed)
    : physics_(physics),
      substep_s_(substep_s),
      load_rad_(physics.startAngle_rad),
      noise_(seed),
      angle_rad_(physics.startAngle_rad) {
  const PlantPhysics& p = physics_;
  const int cells = std::max(4096, cellsPerOrder * highestOrder(p));
  cellsPerTurn_ = cells;
  cells_.resize(static_cast<size_t>(cells) + 1);
  double viscousSum[2] = {0.0, 0.0};
  for (int k = 0; k <= cells; ++k) {
    const AngleTorques torques = torquesAt(p, turn_rad * k / cells);
    Cell& cell = cells_[static_cast<size_t>(k)];
    for (size_t way = 0; way < 2; ++way) {
      cell.static_Nm[way] = std::max(0.0, p.holding[way].at(turn_rad * k / cells));
      cell.coulomb_Nm[way] = torques.coulomb_Nm[way];
      cell.viscous[way] = torques.viscous_Nm_s_per_rad[way];
      if (k < cells) viscousSum[way] += cell.viscous[way];
    }
    cell.position_Nm = torques.position_Nm;
    cell.ripple = torques.ripple;
  }
  for (size_t way = 0; way < 2; ++way)
    motor_[way] = {p.torqueConstant, p.backEmfConstant, p.resistance_ohm,
                   p.inductance_H,   p.inertia,         viscousSum[way] / cells};
  if (p.delay_s > 0.0 || p.inputLimit > 0.0 || p.inputSlew_per_s > 0.0) path_.emplace(p, substep_s);
  if (p.outside != OutsidePhysics{}) outside_.emplace(p.outside, substep_s, seed);
  bent_ = !p.ripple.empty() || p.saturationTorque > 0.0 || p.outside.deadBand > 0.0;
  further_ = p.warmup.excess != 0.0 || p.ofLoad != 0.0 || p.rest.excess != 0.0 || outside_.has_value();
  prepare();
  comeToRest();
  moving_ = p.bristles.stiffness > 0.0;  // on bristles it never stands
}

void Plant::set(double angle_rad, double velocity_rad_per_s, double current_A) {
  angle_rad_ = load_rad_ = angle_rad;
  velocity_ = loadVelocity_ = velocity_rad_per_s;
  current_ = current_A;
  acceleration_ = 0.0;
  moving_ = velocity_ != 0.0 || physics_.bristles.stiffness > 0.0;
  way_ = velocity_ < 0.0 ? 0 : 1;
}

void Plant::prepare() {
  for (int way = 0; way < 2; ++way) {
    motor_[way].resistance_ohm = physics_.resistance_ohm * resistancePart_ * (1.0 + heat_);
    closed_[way] = closedWindings(motor_[way], substep_s_);
    opened_[way] = breakaway::openWindings(motor_[way], substep_s_);
  }
}

Plant::Local Plant::localAt(double angle_rad, int way) const {
  const double turns = angle_rad * (1.0 / turn_rad);
  const double place = (turns - std::floor(turns)) * cellsPerTurn_;
  const auto index = std::min(static_cast<size_t>(place), cells_.size() - 2);
  const double part = place - static_cast<double>(index);
  const Cell &a = cells_[index], &b = cells_[index + 1];
  const auto mix = [part](double low, double high) { return low + part * (high - low); };
  return {mix(a.static_Nm[way], b.static_Nm[way]), mix(a.coulomb_Nm[way], b.coulomb_Nm[way]),
          mix(a.viscous[way], b.viscous[way]), mix(a.position_Nm, b.position_Nm),
          motor_[way].torqueConstant * mix(a.ripple, b.ripple)};
}

/// What the electromagnetic torque is worth on the shaft.
double Plant::motorTorque(const Local& here, double current_A) const {
  double torque = here.torqueConstant * current_A;
  if (physics_.saturationTorque > 0.0)
    torque = physics_.saturationTorque * std::tanh(torque / physics_.saturationTorque);
  return outside_ ? outside_->passedOn(torque) : torque;
}

/// By how much all dry friction is more than when warm.
double Plant::warmth() const {
  const auto& w = physics_.warmup;
  return w.share == 0.0 ? 1.0 : 1.0 + w.share * std::exp(-time_s_ / w.time_s);
}

/// How far the present rest has grown what a long one adds.
double Plant::rested() const {
  return 1.0 - std::exp(-(time_s_ - restStart_s_) / physics_.rest.time_s);
}

double Plant::outerTorque(double angle_rad) const {
  const auto& p = physics_.pulse;
  double torque = time_s_ >= p.start_s && time_s_ < p.start_s + p.duration_s ? p.torque : 0.0;
  for (const auto& one : physics_.attached) {
    if (time_s_ < one.from_s) continue;
    torque += one.torque;
    if (one.pendulum != 0.0) torque -= one.pendulum * std::sin(angle_rad - physics_.startAngle_rad);
  }
  return torque;
}

void Plant::placeWalls() {
  for (auto& wall : physics_.walls) {
    if (wall.placed || time_s_ < wall.from_s) continue;
    wall.placed = true;
    const double beyond = wall.side * (encoderAngle_rad() - wall.at_rad);
    if (beyond <= 0.0) continue;
    if (physics_.stops.present) {
      wall.side = -wall.side;
    } else {
      wall.at_rad += wall.side * turn_rad * std::ceil(beyond / turn_rad);
    }
  }
}

double Plant::stopTorque(double angle_rad, double velocity) const {
  const auto& s = physics_.stops;
  double torque = 0.0;
  if (s.present && angle_rad < s.low_rad) torque += pushBack(s, angle_rad - s.low_rad, velocity);
  if (s.present && angle_rad > s.high_rad) torque += pushBack(s, angle_rad - s.high_rad, velocity);
  for (const auto& wall : physics_.walls) {
    const double beyond = angle_rad - wall.at_rad;
    if (time_s_ >= wall.from_s && wall.side * beyond > 0.0) torque += pushBack(wall, beyond, velocity);
  }
  return torque;
}

/// What acts on the motor's shaft from outside over a step, at the step's middle, where coupling and stops are then
/// solved to second order.
double Plant::outsideTorque(double duration_s) {
  placeWalls();
  const double half = 0.5 * duration_s;
  const RigCoupling& coupling = physics_.coupling;
  const double outer =
      outerTorque(angle_rad_ + half * velocity_) +
      (outside_ ? outside_->torque(angle_rad_ + half * velocity_, velocity_ + half * acceleration_) : 0.0);
  if (!coupling.present()) return outer + stopTorque(angle_rad_ + half * velocity_, velocity_);
  const double load_rad = load_rad_ + half * loadVelocity_;
  coupled_Nm_ = coupling.torque_Nm(angle_rad_ + half * velocity_ - load_rad, velocity_ - loadVelocity_);
  loadStop_Nm_ = stopTorque(load_rad, loadVelocity_);
  return outer - coupled_Nm_;
}

/// The load takes the very impulse that the motor gives.
void Plant::moveLoad(double duration_s) {
  if (!physics_.coupling.present()) return;
  const double before = loadVelocity_;
  loadVelocity_ += (coupled_Nm_ + loadStop_Nm_) * duration_s / physics_.coupling.loadInertia_kg_m2;
  load_rad_ += 0.5 * (before + loadVelocity_) * duration_s;
}

double Plant::windingVoltage() const {
  const PlantPhysics& p = physics_;
  double voltage = acting_;
  if (p.supplyResistance_ohm != 0.0) {
    const double busCurrent = voltage * current_ / p.supply_V;
    voltage *= 1.0 - p.supplyResistance_ohm * std::max(0.0, busCurrent) / p.supply_V;
  }
  if (p.deadTime_V != 0.0) {
    // The diodes take their drop from whichever way the current flows; at rest they hold it at zero up to that drop.
    if (p.deadTimeCurrent_A > 0.0) {
      voltage -= p.deadTime_V * std::tanh(current_ / p.deadTimeCurrent_A);
    } else if (std::abs(current_) > 1e-6) {
      voltage -= std::copysign(p.deadTime_V, current_);
    } else {
      voltage = std::copysign(std::max(0.0, std::abs(voltage) - p.deadTime_V), voltage);
    }
  }
  return voltage;
}

/// Dry friction beyond Coulomb friction and what a breakaway leaves of static friction.
double Plant::further(const Local& here, double speed, double current_A) const {
  const PlantPhysics& p = physics_;
  double torque = p.ofLoad * std::abs(p.torqueConstant * current_A);
  if (p.warmup.excess != 0.0) torque += p.warmup.excess * std::exp(-time_s_ / p.warmup.time_s);
  return outside_ ? torque + outside_->friction(speed, here.coulomb_Nm) : torque;
}

double Plant::threshold(const Local& here, int way, double current_A) const {
  const auto& rest = physics_.rest;
  const double grown = 1.0 + (rest.share != 0.0 ? rest.share * rested() : 0.0);
  const double held = here.static_Nm * scatter_[way] * grown * warmth();
  if (!further_) return held;
  return held + further(here, 0.0, current_A) + (rest.excess != 0.0 ? rest.excess * rested() : 0.0);
}

void Plant::comeToRest() {
  velocity_ = 0.0;
  acceleration_ = 0.0;
  moving_ = false;
  // Asperities that have hardly moved hold as before: a slip that short is the same standstill.
  if (std::abs(angle_rad_ - restAngle_rad_) < physics_.sameStand_rad) return;
  restStart_s_ = time_s_;
  restAngle_rad_ = angle_rad_;
  for (double& factor : scatter_) factor = std::max(0.0, 1.0 + physics_.scatterRms * noise_.normal());
}

// Standing: the current is an exact exponential, so the moment at which it reaches the breakaway level is a logarithm.
double Plant::stand(double duration_s) {
  const LinearMotor& m = motor_[1];
  const double rate = shaftAlone() ? 0.0 : m.resistance_ohm / m.inductance_H;
  const double start = open_ ? 0.0 : current_;
  const double target = shaftAlone() ? start : windingVoltage() / m.resistance_ohm;
  const double end = target + (start - target) * std::exp(-rate * duration_s);
  const double outside = outsideTorque(duration_s);
  for (int way = 0; way < 2; ++way) {
    const Local here = localAt(angle_rad_, way);
    const double sign = signOfWay(way), limit = threshold(here, way, end), free = here.position_Nm + outside;
    const double most = motorTorque(here, end);
    if (blocked_ || sign * (most + free) <= limit) continue;
    double used = 0.0;
    const double level = (sign * limit - free) / here.torqueConstant;  // current at which it lets go
    if (bent_) {
      const double least = motorTorque(here, start), needed = sign * limit - free;
      if (sign * (needed - least) > 0.0) used = duration_s * (needed - least) / (most - least);
    } else if (sign * (level - start) > 0.0) {
      used = std::clamp(-std::log((level - target) / (start - target)) / rate, 0.0, duration_s);
    }
    current_ = target + (start - target) * std::exp(-rate * used);
    time_s_ += used;
    moveLoad(used);
    moving_ = true;
    way_ = way;
    if (physics_.rest.share != 0.0) scatter_[way] *= 1.0 + physics_.rest.share * rested();
    if (physics_.rest.excess != 0.0) restLeft_Nm_ = physics_.rest.excess * rested();
    return used;
  }
  current_ = end;
  time_s_ += duration_s;
  moveLoad(duration_s);
  return duration_s;
}

Propagator Plant::propagatorFor(int way, double duration_s) const {
  if (duration_s == substep_s_) return shaftAlone() ? opened_[way] : closed_[way];
  return shaftAlone() ? breakaway::openWindings(motor_[way], duration_s) : closedWindings(motor_[way], duration_s);
}

/// LuGre's torque under the friction `dry_Nm` of steady motion; advances the bristles implicitly.
double Plant::bristleTorque(double dry_Nm, double duration_s) {
  const auto& b = physics_.bristles;
  const double before = bristle_rad_;
  bristle_rad_ = (bristle_rad_ + duration_s * velocity_) /
                 (1.0 + duration_s * b.stiffness * std::abs(velocity_) / std::max(dry_Nm, 1e-12));
  return b.stiffness * bristle_rad_ + b.damping * (bristle_rad_ - before) / duration_s;
}

double Plant::slide(double duration_s) {
  const PlantPhysics& p = physics_;
  const bool bristly = p.bristles.stiffness > 0.0;
  if (bristly && velocity_ != 0.0) way_ = velocity_ < 0.0 ? 0 : 1;
  const double sign = signOfWay(way_), half = 0.5 * duration_s;
  double middle = velocity_ + half * acceleration_;  // mid-step speed, for what changes slowly
  if (middle * sign < 0.0) middle = 0.0;
  const Local here = localAt(angle_rad_ + half * velocity_, way_);
  const double x = std::abs(middle / p.stribeckVelocity), above = here.static_Nm * scatter_[way_] - here.coulomb_Nm;
  const double fallen = p.stribeckExponent == 2.0 ? x * x : std::pow(x, p.stribeckExponent);
  const double excess = above != 0.0 && fallen < 36.0 ? above * std::exp(-fallen) : 0.0;
  const LinearMotor& m = motor_[way_];
  const double i0 = open_ ? 0.0 : current_, w0 = velocity_;
  double dry = warmth() * (here.coulomb_Nm + excess);
  if (further_) dry = std::max(0.0, dry + further(here, std::abs(middle), i0) + restLeft_Nm_);
  const double outside = outsideTorque(duration_s);
  double torque = here.position_Nm + outside - (bristly ? bristleTorque(dry, duration_s) : sign * dry);
  torque -= (here.viscous - m.viscous) * middle + p.quadraticDrag * middle * std::abs(middle);
  if (bent_ && !shaftAlone()) torque += motorTorque(here, i0) - m.torqueConstant * i0;
  if (!p.electrical) torque += motorTorque(here, i0);
  double drive = 0.0;
  if (!shaftAlone()) {
    double voltage = windingVoltage();
    if (bent_) voltage -= (here.torqueConstant / m.torqueConstant - 1.0) * m.backEmfConstant * middle;
    drive = voltage / m.inductance_H;
  }
  const double push = torque / m.inertia;
  const auto speedAfter = [&](const Propagator& of) {
    return of.phi[1][0] * i0 + of.phi[1][1] * w0 + of.gamma[1][0] * drive + of.gamma[1][1] * push;
  };
  Propagator e = propagatorFor(way_, duration_s);
  double w1 = speedAfter(e), used = duration_s;
  const bool rests = !bristly && w1 * sign <= 0.0;
  if (rests && w0 * sign > 0.0) {
    // Zero of the exact solution by the Illinois method; the speed changes its sign once within so short a step.
    double low = 0.0, high = duration_s, atLow = w0, atHigh = w1;
    bool wasBefore = false, first = true;
    for (int k = 0; k < 60 && high - low > 1e-13 * duration_s + 1e-18; ++k) {
      used = (low * atHigh - high * atLow) / (atHigh - atLow);
      e = propagatorFor(way_, used);
      w1 = speedAfter(e);
      if (w1 == 0.0) break;
      const bool before = w1 * sign > 0.0;
      (before ? low : high) = used;
      (before ? atLow : atHigh) = w1;
      if (!first && before == wasBefore) (before ? atHigh : atLow) *= 0.5;
      wasBefore = before;
      first = false;
    }
  }
  if (p.electrical) current_ = e.phi[0][0] * i0 + e.phi[0][1] * w0 + e.gamma[0][0] * drive + e.gamma[0][1] * push;
  const double moved = 0.5 * (w0 + (rests ? 0.0 : w1)) * used;
  angle_rad_ += moved;
  if (restLeft_Nm_ != 0.0) restLeft_Nm_ *= std::exp(-std::abs(moved) / p.rest.travel_rad);
  time_s_ += used;
  moveLoad(used);
  acceleration_ = (w1 - w0) / used;
  velocity_ = w1;
  if (!rests) return used;
  if (w0 == 0.0) {  // let go and held again at once: the same standstill goes on
    velocity_ = acceleration_ = 0.0;
    moving_ = false;
    return used;
  }
  comeToRest();
  return used;
}

void Plant::heat() {
  if (!open_) loss_J_ += motor_[0].resistance_ohm * current_ * current_ * substep_s_;
  const double elapsed = time_s_ - heatDone_s_;
  if (elapsed < heatStep_s) return;
  const double steady = physics_.heatingPerJoule * physics_.heatingTime_s * loss_J_ / elapsed;
  heat_ += (steady - heat_) * -std::expm1(-elapsed / physics_.heatingTime_s);
  loss_J_ = 0.0;
  heatDone_s_ = time_s_;
  prepare();
}

void Plant::scaleResistance(double part) {
  if (part == resistancePart_) return;
  resistancePart_ = part;
  prepare();
}

void Plant::advance(int substeps) {
  if (blocked_ && moving_) comeToRest();
  for (int k = 0; k < substeps; ++k) {
    if (outside_) outside_->step(time_s_, velocity_);
    acting_ = path_ ? path_->next(input_) : input_;
    if (!physics_.electrical) current_ = acting_ / physics_.torqueConstant;
    double left = substep_s_;
    // Rest and breakaway can follow each other within a step; what eight events leave over is less than a step.
    for (int events = 0; events < 8 && left > 0.0; ++events) left -= moving_ ? slide(left) : stand(left);
    if (physics_.heatingPerJoule != 0.0) heat();
  }
}

double coarsestStep_s(const Rig& rig) {
  constexpr double coarsest_s = 50e-6;
  constexpr double phase_rad = 0.045;  // of the swing in a step: the frequency is off by its square over 24
  const double resonance = rig.coupling.resonance_rad_per_s(rig.inertia_kg_m2);
  return resonance > 0.0 ? std::min(coarsest_s, phase_rad / resonance) : coarsest_s;
}

}  // namespace breakaway
