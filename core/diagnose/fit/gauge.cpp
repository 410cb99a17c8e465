#include "diagnose/fit/gauge.h"

#include <algorithm>

#include "diagnose/fit/windowed_fit.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

constexpr double nextToNone = 0.02;  ///< of the damping by the back-EMF

}  // namespace

std::vector<std::string> gauge(const Bench& bench, const std::vector<Track>& tracks) {
  const MotorNames& names = motorNames(bench.axis);
  const auto trusts = [&bench](const char* name) { return bench.trusted.count(name) > 0; };
  const bool scaled = bench.pendulum.has_value() || trusts(names.inertia);
  if (bench.input == DriveInput::torque) return {};
  if (bench.input == DriveInput::current)
    return scaled || trusts(names.torqueConstant) ? std::vector<std::string>{}
                                                  : std::vector<std::string>{names.torqueConstant};
  const bool currentSeen =
      std::all_of(tracks.begin(), tracks.end(), [](const Track& track) { return !track.current.empty(); });
  if (currentSeen) return {};
  // Voltage alone shows ratios: F R/Kt, J R/Kt, and Ke with B only together.
  if (scaled && trusts(names.torqueConstant)) return {};
  if (scaled) return {names.resistance};
  return {names.resistance, names.torqueConstant, names.backEmfConstant};
}

std::vector<Model> starvedOfViscous(const std::vector<Model>& starts, const std::vector<std::string>& held,
                                    const std::vector<Track>& tracks, const Split& split, const Excitation& seen) {
  FitResult best;
  for (const Model& start : starts) {
    const ParameterVector parameters(start, held, std::max(seen.peakTorque, 1e-12), std::max(seen.highSpeed, 1e-9));
    FitResult fit = fitWindows(parameters, tracks, split.train,
                               {.iterations = 8, .tolerance = 1e-3, .windowWeights = {}, .stop = {}});
    if (best.windows.empty() || (fit.usable && fit.rmse < best.rmse)) best = std::move(fit);
  }
  const Physics physics = physicsOf(best.model);
  const double byBackEmf = physics.torqueConstant * physics.backEmf / physics.resistance;
  if (!best.usable || physics.viscous > nextToNone * byBackEmf) return {};
  return {std::move(best.model)};
}

}  // namespace breakaway
