#include "diagnose/fit/noise_floor.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/statistics.h"
#include "diagnose/effects/all.h"
#include "diagnose/fit/motion.h"
#include "diagnose/fit/torque_residual.h"
#include "diagnose/fit/windowed_fit.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/simulator.h"

namespace breakaway {

namespace {

constexpr double quietPart = 0.25;   ///< of the windows: those with the smallest errors
constexpr double clearlyLess = 0.7;  ///< of the squared error
constexpr std::uint64_t replays = 6;

/// What the recording's sensor would have read in these states, and the positions that follow from it.
void readAnew(const std::vector<MotionState>& states, const Simulator& rig, const Track& recorded, double count,
              Random& random, Track& replay) {
  const double left =
      std::sqrt(std::max(0.0, std::pow(recorded.speedNoise, 2) - std::pow(recorded.speedCount, 2) / 12.0));
  for (size_t k = 0; k < replay.rows(); ++k) {
    const double exact = rig.reading(states[k]);
    if (recorded.speedAlone()) {
      const double read = exact + left * random.normal(), step = recorded.speedCount;
      replay.speed[k] = step > 0.0 ? step * std::round(read / step) : read;
    } else {
      replay.position[k] =
          count > 0.0 ? count * std::floor(exact / count) + 0.5 * count : exact + recorded.noise * random.normal();
    }
  }
  replay.seen.assign(replay.rows(), 1);
  if (recorded.speedAlone()) integrateSpeed(replay);
}

/// The model with friction near standstill as it happens to be once.
Model scattered(Model model, const FrictionScatter& scatter, Random& random) {
  if (scatter.relative <= 0.0) return model;
  const double off = scatter.relative * physicsOf(model).coulomb * random.normal();
  model.effects.push_back(frictionNearStandstill(off, scatter.speed, model.axis));
  return model;
}

void addWander(Track& driven, const FrictionScatter& scatter, double gain, Random& random) {
  double wander = scatter.wander * random.normal();
  std::vector<double>& acting = driven.push.empty() ? driven.input : driven.push;
  for (size_t k = 0; k < driven.rows(); ++k) {
    acting[k] += wander / gain;
    const double dt = k + 1 < driven.rows() ? driven.time[k + 1] - driven.time[k] : 0.0;
    const double keep = std::exp(-dt / scatter.wander_s);
    wander = keep * wander + scatter.wander * std::sqrt(1.0 - keep * keep) * random.normal();
  }
}

}  // namespace

FrictionScatter usualScatter(const Excitation& seen, double coulomb, const TorqueNoise& left,
                             const Criteria& criteria) {
  return {.relative = criteria.immaterial,
          .speed = 0.1 * seen.highSpeed,
          .wander = std::min(left.rms, mostWander(coulomb, seen.peakTorque, criteria)),
          .wander_s = left.time_s};
}

namespace {

/// What noise of sensors and drive, and what scatters, change of the torque that is left along a window's motion.
double noisyTorque(const Model& model, const Track& recorded, const Window& window, const FrictionScatter& scatter,
                   Random& random) {
  const TorqueResidual exact(recorded, window);
  const TorqueResidual read = exact.changed([&](Track& track) {
    for (size_t k = 0; k < track.rows(); ++k) {
      track.position[k] += recorded.noise * random.normal();
      track.input[k] += recorded.inputNoise * random.normal();
    }
    if (scatter.wander > 0.0) addWander(track, scatter, physicsOf(model).torquePerInput(), random);
  });
  const Eigen::VectorXd change = read.of(scattered(model, scatter, random)) - exact.of(model);
  return change.squaredNorm() / static_cast<double>(change.size());
}

/// What a recording from row `first` to `last` would have been if the model, as it scatters, were the rig.
struct Replay {
  Replay(const Model& model, const Track& recorded, size_t first, size_t last, const MotionState& hidden,
         const FrictionScatter& scatter, Random& random)
      : track(recorded.rowsFrom(first, last)) {
    Track driven = recorded.rowsFrom(first, last);  // what acted, if what was recorded is a noisy measurement
    if (model.servo) driven.push.assign(driven.rows(), 0.0);
    for (size_t k = 0; k < driven.rows(); ++k) {
      driven.input[k] += recorded.inputNoise * random.normal();
      if (const double missing = driven.missingInput(k); missing > 0.0)
        driven.input[k] += std::sqrt(missing) / (driven.time[k + 1] - driven.time[k]) * random.normal();
    }
    if (scatter.wander > 0.0) addWander(driven, scatter, physicsOf(model).torquePerInput(), random);
    Simulator rig(scattered(model, scatter, random), driven, 0, driven.rows() - 1);
    MotionState state = Simulator(model, recorded, first, last).restart(first, hidden);
    std::vector<MotionState> states{state};
    for (size_t k = 0; k + 1 < track.rows(); ++k) {
      rig.run(state, k, k + 1);
      states.push_back(state);
    }
    readAnew(states, rig, recorded, model.count, random, track);
  }
  Track track;
};

/// The torque that is left along a replay of the window, which also shows what filtering makes of friction that
/// reverses; nothing where the replay hardly moves.
std::optional<double> replayedTorque(const Model& model, const Track& recorded, const Window& window,
                                     const MotionState& hidden, const FrictionScatter& scatter, Random& random) {
  size_t first = window.first, last = window.last;
  const double margin_s = TorqueResidual::margin_s(recorded);
  while (first > 0 && recorded.time[window.first] - recorded.time[first - 1] <= margin_s) --first;
  while (last + 1 < recorded.rows() && recorded.time[last + 1] - recorded.time[window.last] <= margin_s) ++last;
  const Replay replay(model, recorded, first, last, hidden, scatter, random);
  const TorqueResidual residual(replay.track, {0, window.first - first, window.last - first, ErrorIn::torque});
  if (2 * residual.rows() < TorqueResidual(recorded, window).rows()) return std::nullopt;
  return residual.of(model).squaredNorm() / static_cast<double>(residual.rows());
}

std::vector<double> replayedSquares(const Model& model, const std::vector<Track>& tracks,
                                    const std::vector<Window>& windows, std::uint64_t seed,
                                    const FrictionScatter& scatter) {
  const std::vector<MotionState> hidden = hiddenStates(model, tracks, windows);
  Random random(seed);
  std::vector<double> floors;
  for (size_t w = 0; w < windows.size(); ++w) {
    const Window& window = windows[w];
    const Track& recorded = tracks[window.track];
    if (window.errorIn == ErrorIn::torque) {
      const double noisy = noisyTorque(model, recorded, window, scatter, random);
      floors.push_back(
          std::max(noisy, replayedTorque(model, recorded, window, hidden[w], scatter, random).value_or(0.0)));
      continue;
    }
    // From one horizon before the window to its end, as if the model were the rig.
    const double horizon_s = Simulator(model, recorded, window.first, window.last).horizon_s();
    size_t first = window.first;
    while (first > 0 &&
           (recorded.time[window.first] - recorded.time[first - 1] <= horizon_s || window.first - first < 4))
      --first;
    const Replay replay(model, recorded, first, window.last, hidden[w], scatter, random);
    const size_t start = window.first - first;
    Simulator simulator(model, replay.track, 0, replay.track.rows() - 1);
    MotionState predicted = simulator.restart(start, hidden[w]);
    double squares = 0.0, count = 0.0;
    for (size_t k = start; k < replay.track.rows(); ++k) {
      const double error = simulator.reading(predicted) - replay.track.reading(k);
      squares += error * error;
      count += 1.0;
      if (k + 1 < replay.track.rows()) simulator.run(predicted, k, k + 1);
    }
    // A model with too much friction rests where the rig moved: there a reading's noise is the least that it shows.
    const double least = moves(window, tracks) ? std::pow(recorded.readingNoise(), 2) : 0.0;
    floors.push_back(std::max(squares / count, least));
  }
  return floors;
}

}  // namespace

double noiseFloor(const Model& model, const std::vector<Track>& tracks, const std::vector<Window>& windows,
                  std::uint64_t seed, const FrictionScatter& scatter) {
  std::vector<double> floors = replayedSquares(model, tracks, windows, seed, scatter);
  // A controller that answers to an encoder's steps shakes the current for real, which its readings can't tell from the
  // sensor's noise. What the model errs by where it errs least is more than that noise can do.
  double scale = 1.0;
  if (std::any_of(windows.begin(), windows.end(),
                  [&tracks](const Window& window) { return tracks[window.track].inputNoise > 0.0; })) {
    const double ratio = quantile(scoreWindows(model, tracks, windows), quietPart) / quantile(floors, quietPart);
    if (ratio < clearlyLess) scale = ratio;
  }
  // A window that begins at the edge of standstill may go either way: the worst tenth says nothing about the sensors.
  const double worst = quantile(floors, 0.9);
  std::erase_if(floors, [worst](double one) { return one > worst; });
  return std::sqrt(scale * mean(floors));
}

std::vector<double> usualSquares(const Model& model, const std::vector<Track>& tracks,
                                 const std::vector<Window>& windows, std::uint64_t seed,
                                 const FrictionScatter& scatter) {
  std::vector<double> squares(windows.size(), 0.0);
  for (std::uint64_t replay = 1; replay <= replays; ++replay) {
    const auto one = replayedSquares(model, tracks, windows, seed + replay, scatter);
    for (size_t w = 0; w < windows.size(); ++w) squares[w] += one[w] / static_cast<double>(replays);
  }
  return squares;
}

}  // namespace breakaway
