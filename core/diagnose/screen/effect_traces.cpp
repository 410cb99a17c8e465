#include "diagnose/screen/effect_traces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnose/simulate/followed_load.h"

namespace breakaway {

namespace {

/// For so long a steady motion changes no torque, and half of it no memory: a first guess needs no finer steps.
constexpr double sameTorque_s = 4e-3;
constexpr double longerSteps = 5.0;  ///< than the effect's own longest

}  // namespace

RecordedMotion::RecordedMotion(const Track& track, const Physics& physics) {
  const size_t n = track.rows();
  const Motion& motion = track.motion;
  at_.resize(n);
  slope_.assign(n, 0.0);
  usable_.assign(n, 0);
  double current = 0.0;
  for (size_t k = 0; k < n; ++k) {
    Situation& at = at_[k];
    at.axis = physics.axis;
    at.time_s = track.time[k];
    at.position = track.position[k];
    at.velocity = motion.velocity[k];
    at.acceleration = motion.acceleration[k];
    at.direction = motion.way[k];
    at.knownLoad = physics.knownLoad(at.position);
    at.input = track.input[k];
    at.supply_V = track.supplyAt(k);
    at.rest_s = motion.rest_s[k];
    at.travel = std::abs(track.position[k] - motion.turned[k]);
    if (physics.electrical) {
      // The model's current along the recorded speed.
      const double dt = k + 1 < n ? track.time[k + 1] - track.time[k] : 0.0;
      const double settled =
          track.connected[k] ? (track.input[k] - physics.backEmf * at.velocity) / physics.resistance : 0.0;
      const double keep = physics.inductance > 0.0 ? std::exp(-dt * physics.resistance / physics.inductance) : 0.0;
      const double next = settled + (current - settled) * keep;
      at.current = physics.inductance > 0.0 ? 0.5 * (current + next) : settled;
      slope_[k] = dt > 0.0 ? (next - current) / dt : 0.0;
      current = next;
      at.driveTorque = physics.torqueConstant * at.current;
    } else {
      at.driveTorque = track.connected[k] ? physics.torqueConstant * track.input[k] : 0.0;
      at.current = track.drive == DriveInput::current ? track.input[k] : 0.0;
    }
    usable_[k] =
        !motion.resting[k] && track.placed(k) && motion.way[k] != 0.0 && motion.velocity[k] * motion.way[k] > 0.0;
  }
  divide(track.time.back() / std::max(1.0, static_cast<double>(n) - 1.0));
}

void RecordedMotion::divide(double step_s) {
  const size_t n = at_.size();
  const auto most = std::max<size_t>(1, static_cast<size_t>(sameTorque_s / std::max(step_s, 1e-9)));
  for (size_t k = 0; k < n;) {
    const size_t last = std::min(k + most, n) - 1;
    const bool steady = usable_[k] && usable_[last] && at_[k].direction == at_[last].direction;
    const size_t rows = steady ? last - k + 1 : 1;
    blocks_.push_back({at_[k + rows / 2], k, rows, usable_[k] != 0});
    const size_t end = std::min(k + rows, n - 1);
    Situation& middle = blocks_.back().at;
    middle.position = 0.5 * (at_[k + rows / 2].position + at_[std::min(k + (rows + 1) / 2, n - 1)].position);
    middle.span = at_[end].position - at_[k].position;
    k += rows;
  }
}

EffectTraces::EffectTraces(const Effect& effect, const std::vector<double>& p, const Track& track,
                           const RecordedMotion& motion, const Physics& physics,
                           const std::vector<RecordedStart>& starts) {
  const size_t n = track.rows();
  const bool remembers = effect.hidden() != nullptr || effect.elastic() != nullptr;
  torque.assign(n, 0.0);
  voltage.assign(effect.losesVoltage() && physics.electrical ? n : 0, 0.0);
  if (effect.load() != nullptr) {
    follow(effect, p, track);
  } else if (remembers) {
    remember(effect, p, track, motion, physics.coulomb);
  } else {
    forget(effect, p, motion);
  }
  if (std::all_of(torque.begin(), torque.end(), [](double value) { return value == 0.0; })) torque.clear();
  const double torquePerVolt = physics.electrical ? physics.torqueConstant / physics.resistance : 0.0;
  for (const RecordedStart& start : starts) {
    Situation at = motion.at(start.row);
    at.velocity = 0.0;
    at.direction = start.direction;
    const Term term = remembers ? Term{} : effect.term(p, at);
    starting.push_back(term.load_Nm + start.direction * term.friction_Nm + torquePerVolt * term.voltage_V);
  }
  if (const InputPart* acting = effect.input(track.drive)) {
    input = track.input;
    acting->shape(p, track.time, input);
    for (size_t k = 0; k < n; ++k) input[k] -= track.input[k];
  }
  if (const EncoderPart* encoder = effect.encoder()) {
    shown.resize(n);
    for (size_t k = 0; k < n; ++k) shown[k] = encoder->shown(p, track.position[k]) - track.position[k];
  }
  if (const CurrentSensorPart* sensor = effect.currentSensor(); sensor != nullptr && physics.electrical) {
    sensed.resize(n);
    for (size_t k = 0; k < n; ++k)
      sensed[k] = sensor->sensed(p, motion.at(k).current, motion.slope_[k]) - motion.at(k).current;
  }
}

void EffectTraces::forget(const Effect& effect, const std::vector<double>& p, const RecordedMotion& motion) {
  for (const RecordedMotion::Block& block : motion.blocks_) {
    if (!block.usable && voltage.empty()) continue;
    const Term term = effect.term(p, block.at);
    const auto first = static_cast<std::ptrdiff_t>(block.first);
    std::fill_n(torque.begin() + first, block.rows, term.load_Nm + block.at.direction * term.friction_Nm);
    if (!voltage.empty()) std::fill_n(voltage.begin() + first, block.rows, term.voltage_V);
  }
}

void EffectTraces::follow(const Effect& effect, const std::vector<double>& p, const Track& track) {
  if (track.rows() < 4) return;
  const TwoMass detached = effect.load()->loadOf(p);
  FollowedLoad load(effect, p, track, 0);
  double before = load.motorSpeed(), now = before;
  for (size_t k = 0; k + 2 < track.rows(); ++k) {
    const double pull = load.torque();
    load.advance();
    const double after = load.motorSpeed();
    torque[k] = pull - detached.inertia * 0.5 * (after - before) / (track.time[k + 1] - track.time[k]) -
                (now != 0.0 ? std::copysign(detached.friction, now) : 0.0);
    before = now;
    now = after;
  }
}

void EffectTraces::remember(const Effect& effect, const std::vector<double>& p, const Track& track,
                            const RecordedMotion& motion, double coulomb) {
  const HiddenState* hidden = effect.hidden();
  const ElasticFriction* elastic = effect.elastic();
  const size_t n = track.rows(), size = hidden != nullptr ? hidden->size() : 0;
  const double stiffness = elastic != nullptr ? elastic->stiffness(p) : 0.0,
               longest_s = longerSteps * effect.longestStep_s(p);
  const double step_s = track.time.back() / std::max(1.0, static_cast<double>(n) - 1.0);
  const auto most = std::max<size_t>(1, static_cast<size_t>(0.5 * sameTorque_s / std::max(step_s, 1e-9)));
  std::array<double, 8> memory{}, before{};
  double slip = 0.0;
  for (size_t k = 0; k < n; k += most) {
    Situation at = motion.at(k);
    at.memory = std::span(memory).first(size);
    const Term term = effect.term(p, at);
    double value = term.load_Nm + at.direction * term.friction_Nm;
    if (stiffness > 0.0) value += coulomb * (slip - at.direction);
    const size_t next = k + most, rows = std::min(next, n) - k;
    const auto first = static_cast<std::ptrdiff_t>(k);
    std::fill_n(torque.begin() + first, rows, value);
    if (!voltage.empty()) std::fill_n(voltage.begin() + first, rows, term.voltage_V);
    if (next >= n) break;
    if (stiffness > 0.0) slip = slipAfter(slip, track.position[next] - track.position[k], stiffness, coulomb);
    if (hidden == nullptr) continue;
    const double from = at.velocity, to = motion.at(next).velocity, dt = track.time[next] - track.time[k];
    const auto parts = std::clamp(static_cast<int>(std::ceil(dt / longest_s)), 1, 50);
    at = motion.at(next);
    for (int part = 0; part < parts; ++part) {
      const double share = (part + 1.0) / parts;
      at.time_s = track.time[k] + share * dt;
      at.velocity = (1.0 - share) * from + share * to;
      before = memory;
      at.memory = std::span(before).first(size);
      hidden->remember(p, at, dt / parts, std::span(memory).first(size));
    }
  }
}

}  // namespace breakaway
