#include "plant/plant.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plant/rig_torques.h"

namespace breakaway {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr int cellsPerOrder = 256;  // linear interpolation errs by 8e-5 of a harmonic's amplitude
constexpr double heatStep_s = 0.01;
constexpr double sameStand_rad = 1e-4;

double signOf(int way) {
  return way == 0 ? -1.0 : 1.0;
}

}  // namespace

Plant::Plant(const Rig& rig, double substep_s, uint64_t seed)
    : substep_s_(substep_s),
      stribeckVelocity_(rig.stribeckVelocity_rad_per_s),
      scatterRms_(rig.scatterRms),
      supply_V_(rig.bridge.supply_V),
      coldResistance_ohm_(rig.resistance_ohm),
      coupling_(rig.coupling),
      load_rad_(rig.startAngle_rad()),
      noise_(seed),
      angle_rad_(rig.startAngle_rad()) {
  if (rig.axis == Axis::linear) {
    travel_rad_ = turn;
    stopStiffness_ = rig.travel.stopStiffness_Nm_per_rad;
    stopDamping_ = rig.travel.stopDamping_Nm_s_per_rad;
  }
  const int cells = std::max(4096, cellsPerOrder * highestOrder(rig));
  cellsPerTurn_ = cells;
  double rippleOrder = 0.0, rippleAmplitude = 0.0, ripplePhase = 0.0;
  for (const RigEffect& effect : rig.effects) {
    const auto& name = effect.effect;
    if (name == "quadratic_drag") dragCoefficient_ = effect.parameter("coefficient_Nm_s2_per_rad2");
    if (name == "friction_warmup")
      warmShare_ = effect.parameter("share"), warmTime_s_ = effect.parameter("time_constant_s");
    if (name == "rising_stiction")
      restShare_ = effect.parameter("share"), restTime_s_ = effect.parameter("time_constant_s");
    if (name == "dead_time") deadTime_V_ = effect.parameter("voltage_V");
    if (name == "supply_sag") sagResistance_ohm_ = effect.parameter("resistance_ohm");
    if (name == "winding_heating") {
      heatShare_ = effect.parameter("share");
      heatCurrent_A_ = effect.parameter("current_A");
      heatTime_s_ = effect.parameter("time_constant_s");
    }
    if (name == "torque_ripple") {
      rippleOrder = effect.parameter("order"), rippleAmplitude = effect.parameter("amplitude");
      ripplePhase = effect.parameter("phase_rad");
    }
    if (name == "external_disturbance") {
      pulse_Nm_ = effect.parameter("torque_Nm");
      pulseStart_s_ = effect.parameter("start_s");
      pulseEnd_s_ = pulseStart_s_ + effect.parameter("duration_s");
    }
  }
  sagResistance_ohm_ += rig.bridge.supplyResistance_ohm;
  cells_.resize(static_cast<size_t>(cells) + 1);
  double viscousSum[2] = {0.0, 0.0};
  for (int k = 0; k <= cells; ++k) {
    const double angle = turn * k / cells;
    const RigTorques torques = torquesAt(rig, angle);
    Cell& cell = cells_[static_cast<size_t>(k)];
    for (size_t way = 0; way < 2; ++way) {
      cell.static_Nm[way] = torques.static_Nm[way] / (1.0 + restShare_);
      cell.coulomb_Nm[way] = torques.coulomb_Nm[way];
      cell.viscous[way] = torques.viscous_Nm_s_per_rad[way];
      if (k < cells) viscousSum[way] += cell.viscous[way];
    }
    cell.position_Nm = torques.position_Nm;
    cell.ripple = 1.0 + rippleAmplitude * std::cos(rippleOrder * angle - ripplePhase);
  }
  for (size_t way = 0; way < 2; ++way) {
    motor_[way] = {rig.torqueConstant_Nm_per_A, rig.backEmfConstant_V_s_per_rad, rig.resistance_ohm, rig.inductance_H,
                   rig.inertia_kg_m2,           viscousSum[way] / cells};
  }
  prepare();
  comeToRest();
}

void Plant::prepare() {
  for (int way = 0; way < 2; ++way) {
    motor_[way].resistance_ohm = coldResistance_ohm_ * resistancePart_ * (1.0 + heatShare_ * heat_);
    closed_[way] = closedWindings(motor_[way], substep_s_);
    opened_[way] = breakaway::openWindings(motor_[way], substep_s_);
  }
}

Plant::Local Plant::localAt(double angle_rad, int way) const {
  const double turns = angle_rad * (1.0 / turn);
  const double place = (turns - std::floor(turns)) * cellsPerTurn_;
  const auto index = std::min(static_cast<size_t>(place), cells_.size() - 2);
  const double part = place - static_cast<double>(index);
  const Cell &a = cells_[index], &b = cells_[index + 1];
  const auto mix = [part](double low, double high) { return low + part * (high - low); };
  return {mix(a.static_Nm[way], b.static_Nm[way]), mix(a.coulomb_Nm[way], b.coulomb_Nm[way]),
          mix(a.viscous[way], b.viscous[way]), mix(a.position_Nm, b.position_Nm),
          motor_[way].torqueConstant * mix(a.ripple, b.ripple)};
}

double Plant::warmth() const {
  return warmShare_ == 0.0 ? 1.0 : 1.0 + warmShare_ * std::exp(-time_s_ / warmTime_s_);
}

double Plant::outerTorque() const {
  return time_s_ >= pulseStart_s_ && time_s_ < pulseEnd_s_ ? pulse_Nm_ : 0.0;
}

/// A stop pushes back, and never pulls.
double Plant::stopTorque(double angle_rad, double velocity) const {
  if (travel_rad_ <= 0.0 || (angle_rad >= 0.0 && angle_rad <= travel_rad_)) return 0.0;
  const double beyond = angle_rad < 0.0 ? angle_rad : angle_rad - travel_rad_;
  const double torque = -stopStiffness_ * beyond - stopDamping_ * velocity;
  return torque * beyond < 0.0 ? torque : 0.0;
}

/// What acts on the motor's shaft from outside over a step, at the step's middle, where coupling and stops are then
/// solved to second order.
double Plant::outsideTorque(double duration_s) {
  const double half = 0.5 * duration_s;
  if (!coupling_.present()) return outerTorque() + stopTorque(angle_rad_ + half * velocity_, velocity_);
  const double load_rad = load_rad_ + half * loadVelocity_;
  coupled_Nm_ = coupling_.torque_Nm(angle_rad_ + half * velocity_ - load_rad, velocity_ - loadVelocity_);
  loadStop_Nm_ = stopTorque(load_rad, loadVelocity_);
  return outerTorque() - coupled_Nm_;
}

/// The load takes the very impulse that the motor gives.
void Plant::moveLoad(double duration_s) {
  if (!coupling_.present()) return;
  const double before = loadVelocity_;
  loadVelocity_ += (coupled_Nm_ + loadStop_Nm_) * duration_s / coupling_.loadInertia_kg_m2;
  load_rad_ += 0.5 * (before + loadVelocity_) * duration_s;
}

double Plant::windingVoltage() const {
  double voltage = voltage_V_;
  if (sagResistance_ohm_ != 0.0) {
    const double busCurrent = voltage * current_ / supply_V_;
    voltage *= 1.0 - sagResistance_ohm_ * std::max(0.0, busCurrent) / supply_V_;
  }
  if (deadTime_V_ != 0.0) {
    // The diodes take their drop from whichever way the current flows; at rest they hold it at zero up to that drop.
    if (std::abs(current_) > 1e-6) {
      voltage -= std::copysign(deadTime_V_, current_);
    } else {
      voltage = std::copysign(std::max(0.0, std::abs(voltage) - deadTime_V_), voltage);
    }
  }
  return voltage;
}

double Plant::threshold(int way) const {
  const Local local = localAt(angle_rad_, way);
  double rested = 1.0;
  if (restShare_ != 0.0) rested += restShare_ * (1.0 - std::exp(-(time_s_ - restStart_s_) / restTime_s_));
  return local.static_Nm * scatter_[way] * rested * warmth();
}

void Plant::comeToRest() {
  velocity_ = 0.0;
  acceleration_ = 0.0;
  moving_ = false;
  // Asperities that have hardly moved hold as before: a slip that short is the same standstill.
  if (std::abs(angle_rad_ - restAngle_rad_) < sameStand_rad) return;
  restStart_s_ = time_s_;
  restAngle_rad_ = angle_rad_;
  for (double& factor : scatter_) factor = std::max(0.0, 1.0 + scatterRms_ * noise_.normal());
}

// Standing: the current is an exact exponential, so the moment at which it reaches the breakaway level is a logarithm.
double Plant::stand(double duration_s) {
  const LinearMotor& m = motor_[1];
  const double rate = m.resistance_ohm / m.inductance_H;
  const double target = open_ ? 0.0 : windingVoltage() / m.resistance_ohm;
  const double start = open_ ? 0.0 : current_;
  const double end = open_ ? 0.0 : target + (start - target) * std::exp(-rate * duration_s);
  const Local here = localAt(angle_rad_, 1);
  const double free = here.position_Nm + outsideTorque(duration_s);
  for (int way = 0; way < 2; ++way) {
    const double limit = threshold(way);
    if (blocked_ || signOf(way) * (here.torqueConstant * end + free) <= limit) continue;
    double used = 0.0;
    const double level = (signOf(way) * limit - free) / here.torqueConstant;  // current at which it lets go
    if (signOf(way) * (level - start) > 0.0)
      used = std::clamp(-std::log((level - target) / (start - target)) / rate, 0.0, duration_s);
    current_ = open_ ? 0.0 : target + (start - target) * std::exp(-rate * used);
    time_s_ += used;
    moveLoad(used);
    moving_ = true;
    way_ = way;
    if (restShare_ != 0.0)
      scatter_[way] *= 1.0 + restShare_ * (1.0 - std::exp(-(time_s_ - restStart_s_) / restTime_s_));
    return used;
  }
  current_ = end;
  time_s_ += duration_s;
  moveLoad(duration_s);
  return duration_s;
}

Propagator Plant::propagatorFor(int way, double duration_s) const {
  if (duration_s == substep_s_) return open_ ? opened_[way] : closed_[way];
  return open_ ? breakaway::openWindings(motor_[way], duration_s) : closedWindings(motor_[way], duration_s);
}

double Plant::slide(double duration_s) {
  const double sign = signOf(way_), half = 0.5 * duration_s;
  double middle = velocity_ + half * acceleration_;  // mid-step speed, for what changes slowly
  if (middle * sign < 0.0) middle = 0.0;
  const Local here = localAt(angle_rad_ + half * velocity_, way_);
  const double x = middle / stribeckVelocity_;
  const double excess =
      std::abs(x) < 6.0 ? (here.static_Nm * scatter_[way_] - here.coulomb_Nm) * std::exp(-x * x) : 0.0;
  const LinearMotor& m = motor_[way_];
  double torque = here.position_Nm + outsideTorque(duration_s) - sign * warmth() * (here.coulomb_Nm + excess);
  torque -= (here.viscous - m.viscous) * middle + dragCoefficient_ * middle * std::abs(middle);
  if (!open_) torque += (here.torqueConstant - m.torqueConstant) * current_;
  const double drive = open_ ? 0.0 : windingVoltage() / m.inductance_H, push = torque / m.inertia;
  const double i0 = open_ ? 0.0 : current_, w0 = velocity_;
  const auto speedAfter = [&](const Propagator& p) {
    return p.phi[1][0] * i0 + p.phi[1][1] * w0 + p.gamma[1][0] * drive + p.gamma[1][1] * push;
  };
  Propagator p = propagatorFor(way_, duration_s);
  double w1 = speedAfter(p), used = duration_s;
  const bool rests = w1 * sign <= 0.0;
  if (rests && w0 * sign > 0.0) {
    // Zero of the exact solution by the Illinois method; the speed changes its sign once within so short a step.
    double low = 0.0, high = duration_s, atLow = w0, atHigh = w1;
    bool wasBefore = false, first = true;
    for (int k = 0; k < 60 && high - low > 1e-13 * duration_s + 1e-18; ++k) {
      used = (low * atHigh - high * atLow) / (atHigh - atLow);
      p = propagatorFor(way_, used);
      w1 = speedAfter(p);
      if (w1 == 0.0) break;
      const bool before = w1 * sign > 0.0;
      (before ? low : high) = used;
      (before ? atLow : atHigh) = w1;
      if (!first && before == wasBefore) (before ? atHigh : atLow) *= 0.5;
      wasBefore = before;
      first = false;
    }
  }
  current_ = p.phi[0][0] * i0 + p.phi[0][1] * w0 + p.gamma[0][0] * drive + p.gamma[0][1] * push;
  angle_rad_ += 0.5 * (w0 + (rests ? 0.0 : w1)) * used;
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
  const double elapsed = time_s_ - heatDone_s_;
  if (elapsed < heatStep_s) return;
  const double load = open_ ? 0.0 : current_ * current_ / (heatCurrent_A_ * heatCurrent_A_);
  heat_ += (load - heat_) * -std::expm1(-elapsed / heatTime_s_);
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
    double left = substep_s_;
    // Rest and breakaway can follow each other within a step; what eight events leave over is less than a step.
    for (int events = 0; events < 8 && left > 0.0; ++events) left -= moving_ ? slide(left) : stand(left);
    if (heatShare_ != 0.0) heat();
  }
}

double coarsestStep_s(const Rig& rig) {
  constexpr double coarsest_s = 50e-6;
  constexpr double phase_rad = 0.045;  // of the swing in a step: the frequency is off by its square over 24
  const double resonance = rig.coupling.resonance_rad_per_s(rig.inertia_kg_m2);
  return resonance > 0.0 ? std::min(coarsest_s, phase_rad / resonance) : coarsest_s;
}

}  // namespace breakaway
