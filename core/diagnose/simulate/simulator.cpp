#include "diagnose/simulate/simulator.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers.h"
#include "diagnose/simulate/followed_load.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr double margin_s = 0.25;
// Of a load that swings: periods that a restart looks back, and the doubt about its place when it has followed the
// encoder, in readings' noise. Behind a gap it takes its time, and readings that jump make it rattle.
constexpr double periodsSeen = 1.5, periodsSeenInPlay = 4.5, longestHorizon_s = 0.2;
// A load that friction holds stays where it came to rest.
constexpr double followedFor_s = 0.3, followedIfHeld_s = 3.0, loadDoubt = 10.0, doubtInPlay = 30.0, noIdea = 1e3;

constexpr int mostUnknowns = 7;  // of a restart: three, and two for each load that swings
constexpr size_t mostLoads = (mostUnknowns - 3) / 2;
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, mostUnknowns, 1>;
using Normal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostUnknowns, mostUnknowns>;

struct Line {
  double value = 0.0;  ///< at the first row
  double slope = 0.0;
};

Line lineThrough(const Track& track, size_t first, size_t last) {
  double n = 0, st = 0, sx = 0, stt = 0, stx = 0;
  for (size_t k = first; k <= last; ++k) {
    if (!track.seen[k]) continue;
    const double t = track.time[k] - track.time[first], x = track.reading(k) - track.reading(first);
    n += 1;
    st += t;
    sx += x;
    stt += t * t;
    stx += t * x;
  }
  const double determinant = n * stt - st * st;
  if (n < 2 || determinant <= 0.0) return {track.reading(first), 0.0};
  const double slope = (n * stx - st * sx) / determinant;
  return {track.reading(first) + (sx - slope * st) / n, slope};
}

/// Standard deviation of one reading, from third differences of rows [first, last] alone, whose variance is 20 times a
/// reading's: what is measured later must not reach a restart.
double restartNoise(const Track& track, size_t first, size_t last) {
  double squares = 0.0;
  for (size_t k = first; k + 3 <= last; ++k) {
    const double d = track.reading(k + 3) - 3.0 * (track.reading(k + 2) - track.reading(k + 1)) - track.reading(k);
    squares += d * d;
  }
  return std::sqrt(squares / (20.0 * std::max(1.0, static_cast<double>(last) - static_cast<double>(first) - 2.0)));
}

}  // namespace

Simulator::Simulator(const Model& model, const Track& track, size_t from, size_t to)
    : Simulator(physicsOf(model), *termsOf(model, track.name), model.restartHorizon_s, track, from, to,
                ServoDrive::of(model)) {
}

Simulator::Simulator(const Physics& physics, std::vector<CompiledTerm> terms, double horizon_s, const Track& track,
                     size_t from, size_t to, std::optional<ServoDrive> servo)
    : stepper_(physics, std::move(terms)), servo_(servo), track_(track), horizon_(horizon_s) {
  size_t memory = 0;
  for (const CompiledTerm& term : stepper_.terms()) {
    const HiddenState* hidden = term.effect->hidden();
    const size_t own = hidden != nullptr ? hidden->size() : 0;
    const LoadPart* load = term.effect->load();
    if (load != nullptr && loads_.size() < mostLoads)
      loads_.push_back({term, load->loadOf(term.parameters), memory, own});
    memory += own;
  }
  for (const SwingingLoad& one : loads_) {
    const double periods = one.load.play() > 0.0 ? periodsSeenInPlay : periodsSeen;
    horizon_ = std::max(horizon_, std::min(periods * one.load.period_s(), longestHorizon_s));
  }
  if (!servo_) shapeInput(from, to);
}

void Simulator::shapeInput(size_t from, size_t to) {
  double late_s = physics().driveLate_s.value_or(0.0);
  std::vector<std::pair<const InputPart*, std::span<const double>>> parts;
  for (const CompiledTerm& term : stepper_.terms()) {
    const InputPart* part = term.effect->input(track_.drive);
    if (part == nullptr) continue;
    parts.emplace_back(part, term.parameters);
    if (const auto rows = part->otherwiseLate_rows(); rows && physics().driveLate_s)
      late_s = *rows * track_.usualStep_s;
  }
  if (parts.empty() && late_s == 0.0) return;
  const std::vector<double>& time = track_.time;
  const auto rowAt = [&time](double t) {
    return static_cast<size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
  };
  shapedFrom_ = rowAt(time[from] - horizon_ - margin_s);
  const size_t end = rowAt(time[to] + margin_s);
  const DriveReading reading(track_, late_s);
  shaped_ = reading.means(shapedFrom_, end - shapedFrom_);
  if (late_s != 0.0) reading_.emplace(reading);
  for (const auto& [part, parameters] : parts) {
    part->shape(parameters, std::span(time).subspan(shapedFrom_, shaped_.size()), shaped_);
    delay_s_ = part->delay_s(parameters);
  }
  const bool rowsWillDo = parts.size() > 1 || late_s != 0.0 || !physics().electrical || physics().inductance <= 0.0;
  if (rowsWillDo) delay_s_ = 0.0;
}

double Simulator::shown(double position) const {
  for (const CompiledTerm& term : stepper_.terms()) {
    if (const EncoderPart* encoder = term.effect->encoder()) position = encoder->shown(term.parameters, position);
  }
  return position;
}

double Simulator::truePosition(double shownPosition) const {
  double position = shownPosition;
  for (int k = 0; k < 2 && !stepper_.terms().empty(); ++k) position += shownPosition - shown(position);
  return position;
}

double Simulator::sensed(double current, double slope) const {
  for (const CompiledTerm& term : stepper_.terms()) {
    if (const auto* sensor = term.effect->currentSensor()) current = sensor->sensed(term.parameters, current, slope);
  }
  return current;
}

double Simulator::sensorLag_s() const {
  double lag = 0.0;
  for (const CompiledTerm& term : stepper_.terms()) {
    if (const auto* sensor = term.effect->currentSensor()) lag += sensor->lag_s(term.parameters);
  }
  return lag;
}

double Simulator::settledCurrent(size_t row, double velocity) const {
  if (!physics().electrical || !track_.connected[row]) return 0.0;
  return (input(row, track_.position[row], velocity) - physics().backEmf * velocity) / physics().resistance;
}

void Simulator::run(MotionState& state, size_t from, size_t to) {
  for (size_t k = from; k < to; ++k) {
    stepper_.setSupply(track_.supplyAt(k));
    if (servo_) {
      runServo(state, k);
      continue;
    }
    if (delay_s_ > 0.0) {
      runLate(state, k);
      continue;
    }
    const double dt = track_.time[k + 1] - track_.time[k];
    stepper_.advance(state, shaped_.empty() ? track_.input[k] : shaped_[k - shapedFrom_], dt, track_.time[k],
                     track_.connected[k] != 0);
    if (reading_ && state.velocity != 0.0 && track_.connected[k] != 0)
      state.position -= physics().torquePerInput() / physics().inertia * reading_->lag(k);
  }
}

double Simulator::input(size_t row, double position, double velocity) const {
  if (!servo_) return shaped_.empty() ? track_.input[row] : shaped_[row - shapedFrom_];
  const double from = track_.time[row], to = row + 1 < track_.rows() ? track_.time[row + 1] : from;
  return servo_->input(track_, row, from, to, position - servo_->late_s() * velocity, velocity);
}

/// The motion at t, at `now_s` or earlier: simulated, or, before the run began, recorded.
PastMotion Simulator::motionAt(double t, const MotionState& state, double now_s, size_t row) const {
  PastMotion after{now_s, state.position, state.velocity};
  for (auto before = state.past.rbegin(); before != state.past.rend(); after = *before++) {
    if (before->time_s > t) continue;
    const double part = (t - before->time_s) / (after.time_s - before->time_s);
    return {t, before->position + part * (after.position - before->position),
            before->velocity + part * (after.velocity - before->velocity)};
  }
  while (row > 0 && track_.time[row] > t) --row;
  const size_t next = std::min(row + 1, track_.rows() - 1);
  if (next == row || track_.time[row] > t || t >= after.time_s) return after;
  const double slope = (track_.position[next] - track_.position[row]) / (track_.time[next] - track_.time[row]);
  return {t, truePosition(track_.position[row]) + (t - track_.time[row]) * slope, slope};
}

/// One row in the steps of a servo's law.
void Simulator::runServo(MotionState& state, size_t row) {
  const double from = track_.time[row], dt = track_.time[row + 1] - from;
  const size_t times = servo_->times(dt, physics().inertia, physics().torquePerInput());
  const double step = dt / static_cast<double>(times);
  for (size_t k = 0; k < times; ++k) {
    const double now = from + static_cast<double>(k) * step;
    const double seen_s = now + 0.5 * step - servo_->late_s();
    PastMotion seen{now, state.position, state.velocity};  // half a step late at least: looking ahead may swing
    if (seen_s < now) {
      while (state.past.size() > 1 && state.past[1].time_s < seen_s) state.past.erase(state.past.begin());
      seen = motionAt(seen_s, state, now, row);
      state.past.push_back({now, state.position, state.velocity});
    }
    stepper_.advance(state, servo_->input(track_, row, now, now + step, seen.position, seen.velocity), step, now,
                     track_.connected[row] != 0);
  }
}

/// One row in pieces, as the late input changes within it.
void Simulator::runLate(MotionState& state, size_t row) {
  const std::vector<double>& time = track_.time;
  const double end = time[row + 1];
  size_t acting = row;
  while (acting > 0 && time[acting] + delay_s_ > time[row]) --acting;
  for (double now = time[row]; now < end;) {
    const bool changes = acting < row && time[acting + 1] + delay_s_ < end;
    const double next = changes ? time[acting + 1] + delay_s_ : end;
    if (next > now) stepper_.advance(state, track_.input[acting], next - now, now, track_.connected[row] != 0);
    now = next;
    acting += changes ? 1 : 0;
  }
}

MotionState Simulator::restart(size_t row, const MotionState& carried) {
  // Where the model can't follow the last stretch (it turned, or held on), a shorter one says more.
  MotionState best;
  double least = 1e300;
  const double enough = 3.0 * std::max(restartNoise(track_, horizonBegin(horizon_, row), row),
                                       track_.speedAlone() ? track_.speedNoise : track_.quantisation);
  const bool play =
      std::any_of(loads_.begin(), loads_.end(), [](const SwingingLoad& one) { return one.load.play() > 0.0; });
  const double shortest = loads_.empty() ? 0.1 : 0.4;
  for (double horizon = horizon_; horizon > shortest * horizon_; horizon *= 0.5) {
    for (const Side side : {Side::followed, Side::middle, Side::low, Side::high}) {
      if (side != Side::followed && !play) continue;
      double error = 0.0;
      const MotionState state = restartOver(horizon, row, carried, side, error);
      if (error < (side == Side::followed ? 0.7 : 1.0) * least) {
        best = state;
        least = error;
      }
    }
    if (least <= enough || play) break;
  }
  return best;
}

size_t Simulator::horizonBegin(double horizon_s, size_t row) const {
  size_t first = row;
  while (first > 0 && track_.time[row] - track_.time[first - 1] <= horizon_s) --first;
  return first;
}

Eigen::Vector2d Simulator::followed(const SwingingLoad& load, size_t row) const {
  const size_t from = horizonBegin(load.load.friction > 0.0 ? followedIfHeld_s : followedFor_s, row);
  if (row < from + 4 || row + 2 >= track_.rows()) return Eigen::Vector2d::Zero();
  FollowedLoad one(*load.term.effect, load.term.parameters, track_, from);
  while (one.row() + 1 < row) one.advance();
  return {one.place(), one.speed()};
}

void Simulator::place(const SwingingLoad& load, double place, double speed, double time_s, MotionState& state) {
  load.term.effect->load()->place(place, speed, state.velocity, time_s,
                                  std::span(state.memory).subspan(load.memory, load.size));
}

MotionState Simulator::restartOver(double horizon_s, size_t row, const MotionState& carried, Side side, double& error) {
  error = 0.0;
  const size_t first = std::min(horizonBegin(horizon_s, row), row > 3 ? row - 3 : 0);
  const auto from = [&carried](double position, double velocity, double current) {
    MotionState state = carried;
    state.position = position;
    state.velocity = velocity;
    state.current = current;
    state.acceleration = 0.0;
    state.past.clear();
    return state;
  };
  if (row - first < 3) {
    const double velocity = track_.speedAlone() ? track_.speed[row] : 0.0;
    return from(truePosition(track_.position[row]), velocity, settledCurrent(row, velocity));
  }

  const size_t early = first + std::max<size_t>(2, (row - first) / 3);
  const Line line = lineThrough(track_, first, early);
  const double length = track_.time[row] - track_.time[first];
  const double small = std::max(restartNoise(track_, first, row), 1e-9);
  // Position, velocity, load; of each load that swings place and speed.
  const auto n = static_cast<Eigen::Index>(3 + 2 * loads_.size());
  Unknowns unknown = Unknowns::Zero(n), nudge(n), doubt = Unknowns::Constant(n, 1e9);  // doubt in nudges
  if (track_.speedAlone()) {
    unknown.head(3) << track_.position[first], line.value, 0.0;
    nudge.head(3) << small * length, small, physics().inertia * small / length;
  } else {
    unknown.head(3) << truePosition(line.value), line.slope, 0.0;
    nudge.head(3) << small, small / length, physics().inertia * small / (length * length);
  }
  for (size_t k = 0; k < loads_.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(3 + 2 * k);
    const bool follows = side == Side::followed;
    if (follows) unknown.segment<2>(at) = followed(loads_[k], first);
    if (side == Side::low || side == Side::high) unknown[at] = (side == Side::low ? -0.5 : 0.5) * loads_[k].load.play();
    nudge[at] = small;
    nudge[at + 1] = small / std::min(length, loads_[k].load.period_s());
    doubt[at] = !follows ? noIdea : loads_[k].load.play() > 0.0 ? doubtInPlay : loadDoubt;
    doubt[at + 1] = doubt[at] * std::max(1.0, turn_rad * length / loads_[k].load.period_s());
  }
  const Unknowns expected = unknown;
  const double ownLoad = physics().load;
  const auto measured = [this](const MotionState& state) {
    return track_.speedAlone() ? state.velocity : state.position;
  };
  const auto beginAt = [&](const Unknowns& at) {
    MotionState state = from(at[0], at[1], settledCurrent(first, at[1]));
    for (size_t k = 0; k < loads_.size(); ++k) {
      const auto of = static_cast<Eigen::Index>(3 + 2 * k);
      place(loads_[k], at[of], at[of + 1], track_.time[first], state);
    }
    return state;
  };
  for (int iteration = 0; iteration < (side == Side::followed && !loads_.empty() ? 3 : 2); ++iteration) {
    std::vector<Unknowns> at(static_cast<size_t>(n) + 1, unknown);
    std::vector<MotionState> states;
    states.reserve(at.size());
    for (Eigen::Index k = 0; k <= n; ++k) {
      if (k > 0) at[static_cast<size_t>(k)][k - 1] += nudge[k - 1];
      states.push_back(beginAt(at[static_cast<size_t>(k)]));
    }
    Normal normal = Normal::Zero(n, n);
    Unknowns right = Unknowns::Zero(n), slope(n);
    for (size_t k = first; k <= row; ++k) {
      if (track_.seen[k]) {  // slopes of the position by each unknown, in units of its nudge
        for (Eigen::Index j = 0; j < n; ++j)
          slope[j] = measured(states[static_cast<size_t>(j) + 1]) - measured(states[0]);
        normal += slope * slope.transpose();
        right += slope * (track_.reading(k) - reading(states[0]));
      }
      if (k == row) break;
      for (size_t j = 0; j < states.size(); ++j) {
        stepper_.setLoad(ownLoad + at[j][2]);
        run(states[j], k, k + 1);
      }
    }
    // Speeds say nothing of where the axis is.
    if (track_.speedAlone()) normal(0, 0) += 1e6 * normal.diagonal().maxCoeff();
    // Where friction swallows a nudge at once, the ridge keeps its step at zero.
    normal.diagonal().array() += 1e-9 * normal.diagonal().maxCoeff() + 1e-300;
    for (Eigen::Index k = 3; k < n; ++k) {  // a load keeps near to where it was expected
      const double hold = small * small / (doubt[k] * doubt[k]);
      normal(k, k) += hold;
      right[k] += hold * (expected[k] - unknown[k]) / nudge[k];
    }
    unknown += nudge.cwiseProduct(normal.ldlt().solve(right));
  }
  MotionState state = beginAt(unknown);
  stepper_.setLoad(ownLoad + unknown[2]);
  double seen = 0.0;
  for (size_t k = first; k <= row; ++k) {
    if (track_.seen[k]) {
      error += std::pow(reading(state) - track_.reading(k), 2);
      seen += 1.0;
    }
    if (k < row) run(state, k, k + 1);
  }
  error = std::sqrt(error / std::max(seen, 1.0));
  stepper_.setLoad(ownLoad);
  const MotionState now = state;
  state.memory = carried.memory;
  for (const SwingingLoad& load : loads_) {
    place(load, now.memory[load.memory], now.memory[load.memory + 1], track_.time[row], state);
  }
  if (stepper_.elastic()) {
    // What held the axis besides the model's drive sits in the bristles.
    const double friction =
        stepper_.forcesAt(state, state.position, state.velocity, state.way, 0.0, track_.time[row]).friction;
    state.slip = std::clamp(carried.slip + unknown[2] / std::max(friction, 1e-300), -1.0, 1.0);
  }
  if (state.velocity == 0.0 && carried.velocity == 0.0) state.rest_s = std::max(state.rest_s, carried.rest_s);
  return state;
}

double restartVelocityNoise(const Track& track, double horizon_s) {
  const double step = track.time.back() / static_cast<double>(track.rows() - 1);
  const double rows = std::max(4.0, horizon_s / step + 1.0);
  if (track.speedAlone()) return 2.0 * track.speedNoise / std::sqrt(rows);
  return track.noise * std::sqrt(192.0 / rows) / (step * (rows - 1.0));
}

std::vector<size_t> restartRows(const Track& track, double window_s) {
  std::vector<size_t> rows{0};
  if (window_s <= 0.0) return rows;
  double k = 1.0;
  for (size_t row = 1; row < track.rows(); ++row) {
    if (track.time[row] < k * window_s - 1e-9) continue;
    rows.push_back(row);
    k = std::max(k, std::floor(track.time[row] / window_s) - 1.0);  // at once over a pause of days
    while (k < 1e15 && track.time[row] >= k * window_s - 1e-9) k += 1.0;
  }
  return rows;
}

}  // namespace breakaway
