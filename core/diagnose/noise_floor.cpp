#include "diagnose/noise_floor.h"

#include <cmath>

#include "base/statistics.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/restart.h"

namespace breakaway {

double noiseFloor(const Model& model, const std::vector<Track>& tracks, const std::vector<Window>& windows,
                  std::uint64_t seed) {
  const auto terms = termsOf(model);
  Stepper stepper(physicsOf(model), *terms);
  Random random(seed);
  std::vector<double> floors;
  for (const Window& window : windows) {
    const Track& recorded = tracks[window.track];
    // From one horizon before the window to its end, as if the model were the rig.
    size_t first = window.first;
    while (first > 0 && (recorded.time[window.first] - recorded.time[first - 1] <= model.restartHorizon_s ||
                         window.first - first < 4))
      --first;
    Track replay;
    const auto part = [&](const auto& from) {
      return std::remove_cvref_t<decltype(from)>(from.begin() + static_cast<std::ptrdiff_t>(first),
                                                 from.begin() + static_cast<std::ptrdiff_t>(window.last) + 1);
    };
    replay.time = part(recorded.time);
    replay.input = part(recorded.input);
    replay.connected = part(recorded.connected);
    replay.noise = recorded.noise;
    MotionState state = restartState(stepper, recorded, first, model.restartHorizon_s);
    for (size_t k = 0; k < replay.time.size(); ++k) {
      const double exact = state.position;
      replay.position.push_back(model.count > 0.0 ? model.count * std::floor(exact / model.count) + 0.5 * model.count
                                                  : exact + recorded.noise * random.normal());
      if (k + 1 < replay.time.size()) {
        stepper.advance(state, replay.input[k], replay.time[k + 1] - replay.time[k], replay.time[k],
                        replay.connected[k] != 0);
      }
    }
    replay.seen.assign(replay.time.size(), 1);
    const size_t start = window.first - first;
    MotionState predicted = restartState(stepper, replay, start, model.restartHorizon_s);
    double squares = 0.0, count = 0.0;
    for (size_t k = start; k < replay.rows(); ++k) {
      const double error = predicted.position - replay.position[k];
      squares += error * error;
      count += 1.0;
      if (k + 1 < replay.rows()) run(stepper, replay, k, k + 1, predicted);
    }
    floors.push_back(squares / count);
  }
  // A window that begins at the edge of standstill may go either way: the worst tenth says nothing about the sensors.
  const double worst = quantile(floors, 0.9);
  std::erase_if(floors, [worst](double one) { return one > worst; });
  return std::sqrt(mean(floors));
}

}  // namespace breakaway
