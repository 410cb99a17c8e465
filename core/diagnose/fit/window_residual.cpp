#include "diagnose/fit/window_residual.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "base/numbers.h"
#include "dense/dense_solve.h"

namespace breakaway {

namespace {

constexpr double loadFirmness = 0.05;    ///< of a load's place against the motor's own: it is seen through the motor
constexpr double leastRise_per_s = 1.0;  ///< of the drive before a start, relative

/// What the sensor shows of a run's currents at its row k, A; nothing while a late one still shows what was before.
/// Between two rows the current goes towards what the voltage settles at.
std::optional<double> sensedAt(const Simulator& simulator, const std::vector<double>& currents, const Track& track,
                               size_t first, size_t k) {
  const double lag = simulator.sensorLag_s();
  const double* time = track.time.data() + first;
  if (lag <= 0.0) {
    const double slope = lag == 0.0 ? 0.0 : (currents[k] - currents[k - 1]) / (time[k] - time[k - 1]);
    return simulator.sensed(currents[k], slope);
  }
  const double t = time[k] - lag;
  if (t < time[0]) return std::nullopt;
  while (time[k] > t) --k;
  const double dt = time[k + 1] - time[k], rest = t - time[k];
  const Physics& p = simulator.physics();
  const double rate = p.inductance > 0.0 ? p.resistance / p.inductance : 0.0;
  const double part = rate > 0.0 ? std::expm1(-rest * rate) / std::expm1(-dt * rate) : 0.0;
  return simulator.sensed(currents[k] + part * (currents[k + 1] - currents[k]), 0.0);
}

/// Whether a variant's lost voltage is another one: unless it is only in terms that lose none.
bool losesAnew(const Stepper& variant, std::span<const char> changed) {
  bool any = false;
  for (size_t k = 0; k < changed.size(); ++k) {
    if (changed[k] != 0 && variant.terms()[k].effect->losesVoltage()) return true;
    any = any || changed[k] != 0;
  }
  return !any;
}

}  // namespace

WindowResidual::WindowResidual(const Track& track, const Window& window, Weights weights)
    : track_(track), window_(window), weights_(weights), length_(track.time[window.last] - track.time[window.first]) {
  if (window.errorIn == ErrorIn::torque) {
    torque_.emplace(track, window);
    positions_ = torque_->rows();
    return;
  }
  for (size_t k = window.first; k <= window.last; ++k) {
    positions_ += track.seen[k] ? 1 : 0;
    currents_ += weights.current > 0.0 && k > window.first && useCurrent(k) ? 1 : 0;
  }
}

bool WindowResidual::useCurrent(size_t row) const {
  return !track_.current.empty() && track_.connected[row] != 0 && std::isfinite(track_.current[row]);
}

void WindowResidual::simulate(Simulator& simulator, MotionState state, Eigen::VectorXd& out,
                              std::vector<MotionState>* keep) const {
  Eigen::Index position = 0, current = positions_;
  std::vector<double> currents;
  if (currents_ > 0) currents.reserve(window_.last - window_.first + 1);
  for (size_t k = window_.first;; ++k) {
    if (keep != nullptr) keep->push_back(state);
    if (track_.seen[k]) out[position++] = weights_.position * (simulator.reading(state) - track_.reading(k));
    if (currents_ > 0) currents.push_back(state.current);
    if (currents_ > 0 && k > window_.first && useCurrent(k)) {
      const auto shown = sensedAt(simulator, currents, track_, window_.first, k - window_.first);
      out[current++] = shown ? weights_.current * (*shown - track_.current[k]) : 0.0;
    }
    if (k == window_.last) break;
    simulator.run(state, k, k + 1);
  }
}

void WindowResidual::evaluate(Simulator& simulator, const MotionState& from, Eigen::VectorXd& out,
                              std::vector<MotionState>* keep) const {
  if (keep != nullptr) keep->clear();
  simulate(simulator, from, out, keep);
  out.tail(firm_.size()) = firm_.cwiseProduct(startOf(from) - seen_);
}

Eigen::VectorXd WindowResidual::startOf(const MotionState& state) const {
  Eigen::VectorXd start(2 + loadRows_);
  start.head(2) << state.position, state.velocity;
  for (Eigen::Index k = 0; k < loadRows_; ++k) {
    const auto& load = simulator_->loads()[static_cast<size_t>(k / 2)];
    start[2 + k] = state.memory[load.memory + static_cast<size_t>(k % 2)];
  }
  return start;
}

MotionState WindowResidual::startAt(const Eigen::VectorXd& start, const MotionState& hidden) const {
  MotionState state = hidden;
  state.position = start[0];
  state.velocity = start[1];
  state.current = observed_.current;  // what the voltages before the window have left
  state.acceleration = 0.0;
  state.past.clear();
  for (Eigen::Index k = 0; k < loadRows_; k += 2) {
    const auto& load = simulator_->loads()[static_cast<size_t>(k / 2)];
    Simulator::place(load, start[2 + k], start[3 + k], track_.time[window_.first], state);
  }
  return state;
}

Eigen::MatrixXd WindowResidual::startColumns(const MotionState& hidden) {
  Eigen::MatrixXd columns(rows(), start_.size());
  if (loadRows_ == 0) {
    columns.col(0) = respond(1.0, 0.0, nullptr, nullptr);
    columns.col(1) = respond(0.0, 1.0, nullptr, nullptr);
    return columns;
  }
  Eigen::VectorXd moved(rows());
  for (Eigen::Index k = 0; k < start_.size(); ++k) {
    Eigen::VectorXd near = start_;
    const double step = 0.1 / firm_[k];
    near[k] += step;
    evaluate(*simulator_, startAt(near, hidden), moved);
    columns.col(k) = (moved - nominal_) / step;
  }
  return columns;
}

void WindowResidual::fit(const Model& model, const MotionState& hidden) {
  if (torque_) {
    residual_ = weights_.position * torque_->of(model);
    return;
  }
  simulator_.emplace(model, track_, window_.first, window_.last);
  if (!observedYet_) {
    observed_ = simulator_->restart(window_.first, hidden);
    observedYet_ = true;
    loadRows_ = static_cast<Eigen::Index>(2 * simulator_->loads().size());
    // The residuals of a window are correlated: they count as about three independent ones, and the state's doubt is
    // weighed alike.
    const double firmness = std::sqrt(static_cast<double>(positions_) / 3.0);
    firm_.resize(2 + loadRows_);
    firm_.head(2) << firmness / std::max(track_.noise, 1e-12),
        firmness / std::max(restartVelocityNoise(track_, simulator_->horizon_s()), 1e-12);
    for (Eigen::Index k = 0; k < loadRows_; k += 2) {
      const auto& load = simulator_->loads()[static_cast<size_t>(k / 2)];
      firm_[2 + k] = loadFirmness * firm_[0];
      firm_[3 + k] = firm_[2 + k] * load.load.period_s() / turn_rad;
    }
    next_ = seen_ = startOf(observed_);
  }
  nominal_.resize(rows());
  start_ = next_;
  evaluate(*simulator_, startAt(start_, hidden), nominal_, &states_);
  linearise();
  Eigen::MatrixXd byState = startColumns(hidden);
  const Eigen::VectorXd scale = byState.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
  byState = byState * scale.asDiagonal();
  SpannedFit state = spannedFit(byState, -nominal_);
  basis_ = std::move(state.basis);
  residual_ = projected(nominal_);
  const Eigen::VectorXd step = scale.cwiseProduct(state.x);
  // No further than the doubt about the start allows.
  const double reach = 20.0 * track_.noise, speedReach = track_.speedAlone() ? 20.0 * track_.speedNoise : reach / 0.02;
  next_ = start_;
  // What rests keeps resting: the least speed would end its rest, and with it what has grown meanwhile.
  const bool rests = start_[1] == 0.0 && states_[std::min<size_t>(1, states_.size() - 1)].velocity == 0.0;
  for (Eigen::Index k = 0; k < step.size(); ++k) {
    if (k == 1 && rests) continue;
    const double most = k % 2 == 0 ? reach : speedReach;
    next_[k] += std::clamp(step[k], -most, most);
  }
}

WindowResidual::Passage WindowResidual::torquesAt(Simulator& simulator, size_t row, std::span<const char> changed,
                                                  std::span<Term> parts) const {
  const size_t k = row - window_.first;
  const MotionState &from = states_[k], &to = states_[k + 1];
  const double dt = track_.time[row + 1] - track_.time[row], time = track_.time[row] + 0.5 * dt;
  const bool starts = startsAt(k);  // what decides is the balance at standstill
  const double v = starts ? 0.0 : 0.5 * (from.velocity + to.velocity), x = 0.5 * (from.position + to.position);
  const double a = starts ? 0.0 : (to.velocity - from.velocity) / dt;
  const Stepper& stepper = simulator.stepperAt(row);
  const Physics& p = stepper.physics();
  Passage at;
  const double u = simulator.input(row, x, 0.5 * (from.velocity + to.velocity));
  at.input = u;
  at.drive = track_.connected[row] ? p.torqueConstant * u : 0.0;
  if (p.electrical && track_.connected[row]) {
    if (stepper.losesVoltage())
      at.lost = losesAnew(stepper, changed) ? stepper.lostVoltage(from, u, from.position, v, time) : passages_[k].lost;
    at.current = (u - at.lost - p.backEmf * v - p.inductance * (to.current - from.current) / dt) / p.resistance;
    at.drive = p.torqueConstant * at.current;
  } else if (p.electrical) {
    at.drive = 0.0;
  }
  const double way = v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : to.way;
  stepper.partsAt(from, x, v, way, at.drive, time, to.position - from.position, changed, parts);
  const Stepper::Forces forces = stepper.forcesOf(x, parts);
  at.resistance = forces.load + way * forces.friction;
  at.net = at.drive - p.viscous * v - at.resistance - p.inertia * a;
  return at;
}

std::span<const Term> WindowResidual::partsOf(size_t k) const {
  const size_t each = simulator_->stepper().terms().size();
  return std::span(parts_).subspan(k * each, each);
}

std::vector<char> WindowResidual::changedTerms(const Stepper& variant) const {
  const auto &now = variant.terms(), &before = simulator_->stepper().terms();
  std::vector<char> changed(now.size(), 0);
  for (size_t k = 0; k < now.size(); ++k) {
    if (now[k].parameters == before[k].parameters) continue;
    if (now[k].effect->input(track_.drive) != nullptr || now[k].effect->losesVoltage())
      return std::vector<char>(now.size(), 1);
    changed[k] = 1;
  }
  return changed;
}

void WindowResidual::linearise() {
  const Stepper& stepper = simulator_->stepper();
  const Physics& p = stepper.physics();
  const bool varying = !stepper.terms().empty() || p.gravity != 0.0;
  passages_.resize(states_.size() - 1);
  const size_t terms = stepper.terms().size();
  parts_.resize(passages_.size() * terms);
  const std::vector<char> all(terms, 1);
  double decayed = -1.0, keeps = 1.0, gains = 1.0;  // of the row before: most are alike
  for (size_t k = 0; k + 1 < states_.size(); ++k) {
    const size_t row = window_.first + k;
    const double dt = track_.time[row + 1] - track_.time[row];
    Passage& at = passages_[k] = torquesAt(*simulator_, row, all, std::span(parts_).subspan(k * terms, terms));
    double damping = p.viscous;
    if (p.electrical && track_.connected[row]) damping += p.torqueConstant * p.backEmf / p.resistance;
    const MotionState &from = states_[k], &to = states_[k + 1];
    if (varying) {
      const double v = 0.5 * (from.velocity + to.velocity), x = 0.5 * (from.position + to.position);
      const double way = v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : to.way, time = track_.time[row] + 0.5 * dt;
      const double span = to.position - from.position;
      const auto resistance = [&](double dx, double dv) {
        const Stepper::Forces forces = stepper.forcesAt(from, x + dx, v + dv, way, at.drive, time, span);
        return forces.load + way * forces.friction;
      };
      const double now = startsAt(k) ? resistance(0.0, 0.0) : at.resistance;
      const double dv = way * std::max(1e-4 * std::abs(v), 1e-9), dx = std::max(1e-3 * std::abs(x), 1e-6);
      // A negative slope may run away; the linearised motion must not.
      damping += std::max((resistance(0.0, dv) - now) / dv, -0.9 * damping);
      at.stiffness = (resistance(std::min(dx, 1e-4), 0.0) - now) / std::min(dx, 1e-4);
    }
    if (const auto& servo = simulator_->servo(); servo && track_.connected[row]) {
      at.stiffness += p.torquePerInput() * servo->stiffness(track_, row, at.input);
      damping += p.torquePerInput() * servo->damping(track_, row, at.input);
    }
    if (from.velocity == 0.0 && to.velocity == 0.0) {
      at.velocity = at.gain = 0.0;
      continue;
    }
    const double z = damping * dt / p.inertia;
    if (std::abs(z - decayed) > 1e-8 * decayed) {
      decayed = z;
      keeps = std::exp(-z);
      gains = z > 1e-6 ? -std::expm1(-z) / z : 1.0;
    }
    at.velocity = keeps;
    at.gain = gains * dt / p.inertia;
    if (to.velocity == 0.0) at.velocity = at.gain = 0.0;  // came to rest
    if (startsAt(k)) at.gain += startGain(k);
    if (from.velocity * to.velocity < 0.0 && k > 0 && k + 2 < states_.size()) {
      // Friction turns over: a change of velocity passes as the accelerations after and before.
      const double before = from.velocity - states_[k - 1].velocity, after = states_[k + 2].velocity - to.velocity;
      if (before != 0.0) at.velocity *= std::clamp(after / before, 0.0, 1.0);
    }
  }
}

bool WindowResidual::startsAt(size_t k) const {
  return states_[k].velocity == 0.0 && states_[k + 1].velocity != 0.0;
}

double WindowResidual::startGain(size_t k) const {
  if (k == 0 || k + 2 >= states_.size()) return 0.0;
  const size_t row = window_.first + k;
  const Physics& p = simulator_->physics();
  const double way = states_[k + 1].way;
  const double after =
      way * (states_[k + 2].velocity - states_[k + 1].velocity) / (track_.time[row + 2] - track_.time[row + 1]);
  const auto driveAt = [&](size_t j) {
    return p.torqueConstant * (p.electrical
                                   ? states_[j].current
                                   : simulator_->input(window_.first + j, states_[j].position, states_[j].velocity));
  };
  const double slope = way * (driveAt(k + 1) - driveAt(k - 1)) / (track_.time[row + 1] - track_.time[row - 1]);
  // A push that hardly rises may come at any time: no later than this.
  const double leastSlope = leastRise_per_s * std::max({std::abs(driveAt(k)), p.coulomb, 1e-12});
  return std::max(after, 0.0) / std::max(slope, leastSlope);
}

Eigen::VectorXd WindowResidual::respond(double position, double velocity, const std::vector<double>* torque,
                                        const std::vector<double>* current) const {
  Eigen::VectorXd out(rows());
  const Physics& p = simulator_->physics();
  const double byVelocity = p.electrical ? -p.backEmf / p.resistance : 0.0;
  double x = position, v = velocity;
  Eigen::Index at = 0, currentAt = positions_;
  for (size_t k = 0; k < states_.size(); ++k) {
    const size_t row = window_.first + k;
    if (track_.seen[row]) out[at++] = weights_.position * (track_.speedAlone() ? v : x);
    if (currents_ > 0 && k > 0 && useCurrent(row)) {
      const double direct = current != nullptr ? (*current)[k - 1] : 0.0;
      out[currentAt++] = weights_.current * (direct + byVelocity * v);
    }
    if (k + 1 == states_.size()) break;
    const Passage& pass = passages_[k];
    const double push = (torque != nullptr ? (*torque)[k] : 0.0) - pass.stiffness * x;
    const double next = pass.velocity * v + pass.gain * push;
    x += 0.5 * (v + next) * (track_.time[row + 1] - track_.time[row]);
    v = next;
  }
  out.tail(firm_.size()).setZero();
  out[rows() - firm_.size()] = firm_[0] * position;
  out[rows() - firm_.size() + 1] = firm_[1] * velocity;
  return out;
}

Eigen::VectorXd WindowResidual::column(const Model& variant, const MotionState& hidden, double step) const {
  if (torque_) return torqueColumn(variant, step);
  Simulator simulator(variant, track_, window_.first, window_.last);
  Eigen::VectorXd moved(rows());
  evaluate(simulator, startAt(start_, hidden), moved);
  return projected((moved - nominal_) / step);
}

Eigen::VectorXd WindowResidual::linearColumn(const Model& variant, double step) const {
  if (torque_) return torqueColumn(variant, step);
  Simulator simulator(variant, track_, window_.first, window_.last);
  const std::vector<char> changed = changedTerms(simulator.stepper());
  const bool sensors = std::any_of(changed.begin(), changed.end(), [](char one) { return one != 0; });
  std::vector<double> torque(passages_.size()), current(passages_.size());
  std::vector<Term> parts(changed.size());
  for (size_t k = 0; k < passages_.size(); ++k) {
    std::ranges::copy(partsOf(k), parts.begin());
    const Passage at = torquesAt(simulator, window_.first + k, changed, parts);
    torque[k] = (at.net - passages_[k].net) / step;
    current[k] = (at.current - passages_[k].current) / step;
  }
  Eigen::VectorXd change = respond(0.0, 0.0, &torque, &current);
  if (sensors) {  // what sensors show changes at once
    Eigen::Index at = 0, currentAt = positions_;
    std::vector<double> currents;
    currents.reserve(states_.size());
    for (const MotionState& state : states_) currents.push_back(state.current);
    for (size_t k = 0; k < states_.size(); ++k) {
      const MotionState& state = states_[k];
      if (track_.seen[window_.first + k]) {
        const double more = simulator.reading(state) - simulator_->reading(state);
        change[at++] += weights_.position * more / step;
      }
      if (currents_ > 0 && k > 0 && useCurrent(window_.first + k)) {
        const auto now = sensedAt(*simulator_, currents, track_, window_.first, k),
                   moved = sensedAt(simulator, currents, track_, window_.first, k);
        change[currentAt++] += now && moved ? weights_.current * (*moved - *now) / step : 0.0;
      }
    }
  }
  return projected(change);
}

Weights weightsOf(const std::vector<WindowResidual>& residuals, const std::vector<Track>& tracks,
                  const std::vector<Window>& windows) {
  double position = 0.0, current = 0.0, positions = 0.0, currents = 0.0, noise = 1e-12;
  for (size_t w = 0; w < windows.size(); ++w) {
    const WindowResidual& residual = residuals[w];
    position += residual.residual().head(residual.positions()).squaredNorm();
    current += residual.residual().segment(residual.positions(), residual.currents()).squaredNorm();
    positions += static_cast<double>(residual.positions());
    currents += static_cast<double>(residual.currents());
    if (windows[w].errorIn == ErrorIn::motion) noise = std::max(noise, tracks[windows[w].track].readingNoise());
  }
  Weights weights;
  weights.position = 1.0 / std::max(std::sqrt(position / std::max(positions, 1.0)), noise);
  if (currents > 0.0) weights.current = 1.0 / std::max(std::sqrt(current / currents), 1e-9);
  return weights;
}

}  // namespace breakaway
