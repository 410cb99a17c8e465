#include "diagnose/simulate/stepper.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "diagnose/simulate/false_position.h"

namespace breakaway {

namespace {

constexpr double shortestStep_s = 2e-5;
constexpr double leastLeft = 0.02;  ///< of the base inertia and friction: what a detached load leaves, at least
constexpr int mostEventsPerStep = 8;

/// Differences of recorded times are equal only up to their last digits.
bool sameStep(double a, double b) {
  return std::abs(a - b) <= 5e-10 * b;
}

}  // namespace

Stepper::Stepper(const Physics& physics, std::vector<CompiledTerm> terms)
    : physics_(physics), terms_(std::move(terms)), stateDependent_(!terms_.empty() || physics.gravity != 0.0) {
  double inertia = 0.0, friction = 0.0;  // detached
  for (const CompiledTerm& term : terms_) {
    const HiddenState* hidden = term.effect->hidden();
    own_.push_back({memorySize_, hidden != nullptr ? hidden->size() : 0, hidden, term.effect->losesVoltage()});
    memorySize_ += own_.back().size;
    losesVoltage_ = losesVoltage_ || (physics_.electrical && own_.back().losesVoltage);
    longestStep_ = std::min(longestStep_, term.effect->longestStep_s(term.parameters));
    if (const LoadPart* load = term.effect->load()) {
      const TwoMass detached = load->loadOf(term.parameters);
      inertia += detached.inertia;
      friction += detached.friction;
      swings_ = true;
    } else if (hidden != nullptr) {
      remembersLong_ = true;
    }
    if (const ElasticFriction* elastic = term.effect->elastic()) {
      stiffness_ += elastic->stiffness(term.parameters);
      dampingRatio_ += elastic->dampingRatio(term.parameters);
    }
  }
  physics_.inertia = std::max(physics_.inertia - inertia, leastLeft * physics_.inertia);
  physics_.coulomb = std::max(physics_.coulomb - friction, leastLeft * physics_.coulomb);
  if (stiffness_ > 0.0) longestStep_ = std::min(longestStep_, 0.3 * std::sqrt(physics_.inertia / stiffness_));
  longestStep_ = std::max(longestStep_, shortestStep_s);
}

Situation Stepper::situationAt(const MotionState& state, double position, double velocity, double direction,
                               double drive, double time_s) const {
  // At once, for this is asked several times in every step: what is filled with zeros first costs as much as a term.
  return {.axis = physics_.axis,
          .time_s = time_s,
          .position = position,
          .velocity = velocity,
          .acceleration = state.acceleration,
          .driveTorque = drive,
          .knownLoad = physics_.knownLoad(position),
          .direction = direction,
          .current = physics_.torqueConstant > 0.0 ? drive / physics_.torqueConstant : 0.0,
          .input = 0.0,
          .supply_V = supply_,
          .resistance_ohm = physics_.electrical ? physics_.resistance : 0.0,
          .rest_s = state.rest_s,
          .travel = std::abs(position - state.turned),
          .span = 0.0,
          .memory = {}};
}

/// `act` gets each term, with its own memory in `at`, and its number.
template <typename Act>
void Stepper::eachTerm(const MotionState& state, Situation& at, Act act) const {
  for (size_t k = 0; k < terms_.size(); ++k) {
    at.memory = std::span(state.memory).subspan(own_[k].memory, own_[k].size);
    act(terms_[k], k);
  }
}

Stepper::Forces Stepper::forcesAt(const MotionState& state, double position, double velocity, double direction,
                                  double drive, double time_s, double span) const {
  Forces forces{physics_.load, physics_.coulomb};
  if (!stateDependent_) return forces;
  Situation at = situationAt(state, position, velocity, direction, drive, time_s);
  at.span = span;
  forces.load += at.knownLoad;
  eachTerm(state, at, [&](const CompiledTerm& term, size_t) {
    const Term part = term.effect->term(term.parameters, at);
    forces.load += part.load_Nm;
    forces.friction += part.friction_Nm;
  });
  forces.friction = std::max(forces.friction, 0.0);
  return forces;
}

void Stepper::partsAt(const MotionState& state, double position, double velocity, double direction, double drive,
                      double time_s, double span, std::span<const char> wanted, std::span<Term> parts) const {
  Situation at = situationAt(state, position, velocity, direction, drive, time_s);
  at.span = span;
  eachTerm(state, at, [&](const CompiledTerm& term, size_t k) {
    if (wanted[k] != 0) parts[k] = term.effect->term(term.parameters, at);
  });
}

Stepper::Forces Stepper::forcesOf(double position, std::span<const Term> parts) const {
  Forces forces{physics_.load, physics_.coulomb};
  forces.load += physics_.knownLoad(position);
  for (const Term& part : parts) {
    forces.load += part.load_Nm;
    forces.friction += part.friction_Nm;
  }
  forces.friction = std::max(forces.friction, 0.0);
  return forces;
}

double Stepper::lostVoltage(const MotionState& state, double u, double position, double velocity, double time_s) const {
  const double available = u - physics_.backEmf * velocity;
  const auto lossAt = [&](double current) {
    Situation at = situationAt(state, position, velocity, signOf(velocity), physics_.torqueConstant * current, time_s);
    at.input = u;
    double loss = 0.0;
    eachTerm(state, at, [&](const CompiledTerm& term, size_t k) {
      if (own_[k].losesVoltage) loss += term.effect->term(term.parameters, at).voltage_V;
    });
    return loss;
  };
  // R i + loss(i) = u − Ke ω by false position between hardly any current and the current without loss. What doesn't
  // depend on the current may lie beyond either.
  const double free = available / physics_.resistance;
  const double least = 1e-6 * free, atLeast = lossAt(least) - available;
  double loss = lossAt(free);
  if (atLeast * loss > 0.0) return lossAt(free - loss / physics_.resistance);
  FalsePosition root(least, atLeast, free, loss);
  for (int k = 0; k < 12 && !root.flat(); ++k) {
    const double current = root.next();
    loss = lossAt(current);
    const double g = physics_.resistance * current + loss - available;
    if (std::abs(g) < 1e-4 * std::abs(available)) break;
    root.narrow(current, g);
  }
  return loss;
}

Stepper::Forces Stepper::forcesDuring(const MotionState& state, double direction, double drive, double damping,
                                      double dt, double time_s) const {
  if (!stateDependent_) return {physics_.load, physics_.coulomb};
  const double backEmf = damping - physics_.viscous;  // without inductance the back-EMF acts as damping
  double middle = state.velocity + 0.5 * dt * state.acceleration;
  if (middle * direction < 0.0) middle = 0.0;
  Forces forces = forcesAt(state, state.position + 0.25 * dt * (state.velocity + middle), middle, direction,
                           drive - backEmf * middle, time_s + 0.5 * dt, middle * dt);
  if (stiffness_ > 0.0) {
    const double slip = slipAfter(state.slip, 0.5 * dt * state.velocity, stiffness_, forces.friction);
    // LuGre's σ₁ dz/dt (C. Canudas de Wit et al., 'A new model for control of systems with friction', IEEE Trans.
    // Automatic Control 40(3), 1995).
    forces.load += forces.friction * slip + slipDamping() * (middle - std::abs(middle) * slip);
    forces.friction = 0.0;
  }
  return forces;
}

void Stepper::keepHistory(MotionState& state, const MotionState& before, double u, double dt, double time_s) const {
  const double way = signOf(state.velocity);
  if (way != 0.0 && way != state.way) {
    if (before.velocity != 0.0) state.rest_s = 0.0;  // it turned without a rest
    state.way = way;
    state.turned = before.position;
  }
  if (way == 0.0) state.rest_s = before.velocity != 0.0 ? 0.0 : state.rest_s + dt;
  const double drive = physics_.torqueConstant * (physics_.electrical ? state.current : u);
  if (stiffness_ > 0.0) {
    const Forces forces = forcesAt(state, state.position, state.velocity, way, drive, time_s);
    state.slip = slipAfter(state.slip, state.position - before.position, stiffness_, forces.friction);
  }
  if (memorySize_ == 0) return;
  Situation at = situationAt(state, state.position, state.velocity, way, drive, time_s);
  at.input = u;
  for (size_t k = 0; k < terms_.size(); ++k) {
    const Own& own = own_[k];
    if (own.hidden == nullptr) continue;
    const std::array<double, 8> old = state.memory;
    at.memory = std::span(old).subspan(own.memory, own.size);
    own.hidden->remember(terms_[k].parameters, at, dt, std::span(state.memory).subspan(own.memory, own.size));
  }
}

Stepper::Decay Stepper::decayOver(double dt, double damping) const {
  Decay decay;
  decay.dt = dt;
  decay.damping = damping;
  const double z = damping * dt / physics_.inertia;
  decay.velocity = std::exp(-z);
  // φ₁(z) = (1 − e^{−z})/z and φ₂(z) = (1 − φ₁)/z, by series where the quotients cancel.
  const double phi1 = std::abs(z) > 1e-5 ? -std::expm1(-z) / z : 1.0 - z / 2.0 + z * z / 6.0;
  const double phi2 = std::abs(z) > 1e-3 ? (1.0 - phi1) / z : 0.5 - z / 6.0 + z * z / 24.0 - z * z * z / 120.0;
  decay.gainVelocity = dt * phi1;
  decay.gainPosition = dt * dt * phi2;
  return decay;
}

void Stepper::advance(MotionState& state, double u, double dt, double time_s, bool connected) {
  const int parts = stateDependent_ ? std::max(1, static_cast<int>(std::ceil(dt / longestStep_ - 1e-9))) : 1;
  const double step = dt / parts;
  const Physics& p = physics_;
  for (int part = 0; part < parts; ++part) {
    const double now = time_s + part * step;
    const MotionState before = stateDependent_ ? state : MotionState{};
    double volts = u;
    if (losesVoltage_ && connected) {
      double middle = state.velocity + 0.5 * step * state.acceleration;
      if (middle * state.velocity <= 0.0) middle = state.velocity;
      const double place = state.position + 0.25 * step * (state.velocity + middle);
      volts -= lostVoltage(state, u, place, middle, now + 0.5 * step);
    }
    if (!p.electrical) {
      mechanical(state, connected ? p.torqueConstant * u : 0.0, p.viscous, step, now);
    } else if (!connected) {
      state.current = 0.0;
      mechanical(state, 0.0, p.viscous, step, now);
    } else if (p.inductance > 0.0) {
      inductive(state, volts, step, now);
    } else {
      mechanical(state, p.torqueConstant * volts / p.resistance,
                 p.viscous + p.torqueConstant * p.backEmf / p.resistance, step, now);
      state.current = (volts - p.backEmf * state.velocity) / p.resistance;
    }
    if (stateDependent_) keepHistory(state, before, u, step, now + step);
  }
}

void Stepper::mechanical(MotionState& state, double drive, double damping, double dt, double time_s) {
  if (!sameStep(decay_.dt, dt) || decay_.damping != damping) decay_ = decayOver(dt, damping);
  if (stiffness_ > 0.0) {  // nothing ever stands quite still
    const double a = (drive - forcesDuring(state, state.way, drive, damping, dt, time_s).load) / physics_.inertia;
    const double v = state.velocity * decay_.velocity + a * decay_.gainVelocity;
    state.position += state.velocity * decay_.gainVelocity + a * decay_.gainPosition;
    state.acceleration = (v - state.velocity) / dt;
    state.velocity = v;
    return;
  }
  double remaining = dt;
  for (int event = 0; event < mostEventsPerStep && remaining > 0.0; ++event) {
    const double now = time_s + dt - remaining;
    double direction = signOf(state.velocity);
    if (direction == 0.0) {
      const double push = drive - forcesAt(state, state.position, 0.0, 0.0, drive, now).load;
      direction = signOf(push);
      if (direction == 0.0 || std::abs(push) <= forcesAt(state, state.position, 0.0, direction, drive, now).friction)
        return;
    }
    const Forces forces = forcesDuring(state, direction, drive, damping, remaining, now);
    const double a = (drive - forces.load - direction * forces.friction) / physics_.inertia;
    const Decay decay = remaining == dt ? decay_ : decayOver(remaining, damping);
    const double v = state.velocity * decay.velocity + a * decay.gainVelocity;
    if (v * direction >= 0.0) {
      if (v == 0.0 && state.velocity == 0.0) return;
      state.position += state.velocity * decay.gainVelocity + a * decay.gainPosition;
      state.acceleration = (v - state.velocity) / remaining;
      state.velocity = v;
      return;
    }
    if (state.velocity == 0.0) return;  // the push fades within the step: it does not start
    // v(t) = 0: e^{z} = 1 − v₀ d/(J a) in closed form; without damping t = −v₀/a.
    const double rate = damping / physics_.inertia;
    double stop = rate > 1e-12 ? std::log1p(-state.velocity * rate / a) / rate : -state.velocity / a;
    stop = std::clamp(stop, 0.0, remaining);
    const Decay until = decayOver(stop, damping);
    state.position += state.velocity * until.gainVelocity + a * until.gainPosition;
    state.velocity = 0.0;
    state.acceleration = 0.0;
    remaining -= stop;
  }
}

Stepper::Coupled Stepper::coupledOver(double dt) const {
  // exp(A t) of A = [[−R/L, −Ke/L], [Kt/J, −B/J]] by its mean m and half discriminant q: e^{mt}(c I + s (A − m I)).
  const Physics& p = physics_;
  const double a = -p.resistance / p.inductance, b = -p.backEmf / p.inductance;
  const double c = p.torqueConstant / p.inertia, d = -p.viscous / p.inertia;
  const double mean = 0.5 * (a + d), half = 0.5 * (a - d);
  const double q = half * half + b * c;
  const double root = std::sqrt(std::abs(q)), decay = std::exp(mean * dt), z = root * dt;
  double even = decay, odd = decay * dt;
  if (q > 0.0 && z > 1e-6) {
    even = 0.5 * (std::exp((mean + root) * dt) + std::exp((mean - root) * dt));
    odd = 0.5 * (std::exp((mean + root) * dt) - std::exp((mean - root) * dt)) / root;
  } else if (q < 0.0 && z > 1e-6) {
    even = decay * std::cos(z);
    odd = decay * std::sin(z) / root;
  }
  Coupled out;
  out.dt = dt;
  out.ii = even + odd * half;
  out.iv = odd * b;
  out.vi = odd * c;
  out.vv = even - odd * half;
  // ∫ exp = A⁻¹(exp − I); only the velocity's row is needed.
  const double determinant = a * d - b * c;
  out.xi = (-c * (out.ii - 1.0) + a * out.vi) / determinant;
  out.xv = (-c * out.iv + a * (out.vv - 1.0)) / determinant;
  return out;
}

double Stepper::breakawayTime(const MotionState& state, double u, double dt, double time_s, double& direction) const {
  const Physics& p = physics_;
  const double drive = p.torqueConstant * state.current;
  const double load = forcesAt(state, state.position, 0.0, 0.0, drive, time_s).load;
  direction = signOf(drive - load);
  if (direction != 0.0 &&
      std::abs(drive - load) > forcesAt(state, state.position, 0.0, direction, drive, time_s).friction)
    return 0.0;
  const double rate = p.resistance / p.inductance, final = u / p.resistance;
  const double end = final + (state.current - final) * std::exp(-rate * dt);
  direction = signOf(p.torqueConstant * end - load);
  if (direction == 0.0) return dt;
  const double friction = forcesAt(state, state.position, 0.0, direction, p.torqueConstant * end, time_s).friction;
  if (direction * (p.torqueConstant * end - load) <= friction) return dt;
  const double needed = (load + direction * friction) / p.torqueConstant;
  const double ratio = (needed - final) / (state.current - final);
  return std::clamp(-std::log(std::max(ratio, 1e-300)) / rate, 0.0, dt);
}

double Stepper::reversalTime(const MotionState& state, double iEnd, double vEnd, double dt, double vAfter) const {
  FalsePosition root(0.0, state.velocity, dt, vAfter);
  const double i0 = state.current - iEnd, v0 = state.velocity - vEnd;
  for (int k = 0; k < 60 && root.width() > 1e-12 * dt; ++k) {
    const double t = root.next();
    const Coupled at = coupledOver(t);
    const double v = vEnd + at.vi * i0 + at.vv * v0;
    if (v == 0.0) return t;
    root.narrow(t, v);
  }
  return root.middle();
}

void Stepper::inductive(MotionState& state, double u, double dt, double time_s) {
  const Physics& p = physics_;
  if (!sameStep(coupled_.dt, dt)) coupled_ = coupledOver(dt);
  double remaining = dt;
  for (int event = 0; event < mostEventsPerStep && remaining > 0.0; ++event) {
    const double now = time_s + dt - remaining;
    double direction = stiffness_ > 0.0 ? state.way : signOf(state.velocity);
    if (direction == 0.0 && stiffness_ == 0.0) {
      const double wait = breakawayTime(state, u, remaining, now, direction);
      const double final = u / p.resistance;
      state.current = final + (state.current - final) * std::exp(-p.resistance / p.inductance * wait);
      remaining -= wait;
      if (remaining <= 1e-12 * dt) return;
    }
    const Forces forces = forcesDuring(state, direction, p.torqueConstant * state.current, p.viscous, remaining, now);
    // Steady state of (i, v) under u and the frozen forces.
    const double resisting = forces.load + direction * forces.friction;
    const double vEnd =
        (p.torqueConstant * u / p.resistance - resisting) / (p.viscous + p.torqueConstant * p.backEmf / p.resistance);
    const double iEnd = (u - p.backEmf * vEnd) / p.resistance;
    const auto moveOver = [&](const Coupled& over) {
      const double i0 = state.current - iEnd, v0 = state.velocity - vEnd;
      state.position += vEnd * over.dt + over.xi * i0 + over.xv * v0;
      state.current = iEnd + over.ii * i0 + over.iv * v0;
      state.velocity = vEnd + over.vi * i0 + over.vv * v0;
    };
    const Coupled over = remaining == dt ? coupled_ : coupledOver(remaining);
    const double v = vEnd + over.vi * (state.current - iEnd) + over.vv * (state.velocity - vEnd);
    if (v * direction >= 0.0 || stiffness_ > 0.0) {
      state.acceleration = (v - state.velocity) / remaining;
      moveOver(over);
      return;
    }
    if (state.velocity == 0.0) {  // the push fades within the step: only the current moves on
      const double final = u / p.resistance;
      state.current = final + (state.current - final) * std::exp(-p.resistance / p.inductance * remaining);
      return;
    }
    const double stop = reversalTime(state, iEnd, vEnd, remaining, v);
    moveOver(coupledOver(stop));
    state.velocity = 0.0;
    state.acceleration = 0.0;
    remaining -= stop;
  }
}

}  // namespace breakaway
