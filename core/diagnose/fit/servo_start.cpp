#include "diagnose/fit/servo_start.h"

#include "diagnose/fit/inverse_regression.h"
#include "diagnose/fit/start_models.h"
#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/servo_drive.h"

namespace breakaway {

namespace {

constexpr double earliest_steps = -2.0, latest_steps = 8.0, between_steps = 0.25;  ///< rows

/// The last row at or before t, from `near` downwards.
size_t rowBefore(const Track& track, double t, size_t near) {
  while (near > 0 && track.time[near] > t) --near;
  return near;
}

/// The inverse model beside a law: its parts per kp where that is 1.
Result<Regression> inverseBeside(const Bench& bench, std::vector<Track>& tracks) {
  const Model model = believedDrive(bench);
  for (Track& track : tracks) track.input = reconstructedInput(model, track);
  std::vector<Column> columns{accelerationColumn, velocityColumn, directionColumn,
                              [](const InverseRows&, size_t) { return 1.0; }};
  if (bench.pendulum) {
    columns.push_back([](const InverseRows& rows, size_t k) { return std::sin(rows.position[k]); });
    columns.push_back([](const InverseRows& rows, size_t k) { return std::cos(rows.position[k]); });
  }
  return regress(
      tracks, columns, [](const InverseRows& rows, size_t k) { return rows.input[k]; }, false);
}

}  // namespace

std::vector<double> reconstructedInput(const Model& model, const Track& track) {
  const auto law = ServoDrive::of(model);
  if (!law) return track.input;
  std::vector<double> input(track.rows(), 0.0);
  for (size_t k = 0; k + 1 < track.rows(); ++k) {
    const double from = track.time[k], to = track.time[k + 1];
    const size_t seen = rowBefore(track, 0.5 * (from + to) - law->late_s(), k);
    const double t = 0.5 * (from + to) - law->late_s(),
                 part = (t - track.time[seen]) / (track.time[seen + 1] - track.time[seen]);
    const auto at = [&](const std::vector<double>& values) {
      return values[seen] + part * (values[seen + 1] - values[seen]);
    };
    input[k] = law->input(track, k, from, to, at(track.position), at(track.motion.velocity));
  }
  if (track.rows() > 1) input.back() = input[track.rows() - 2];
  return input;
}

ServoLaw startingLaw(const Bench& bench, const std::vector<Track>& training) {
  Bench tried = bench;
  ServoLaw& law = *tried.servo;
  if (!law.kp) law.kp = 1.0;
  if (!law.kd) law.kd = 0.0;
  std::vector<Track> tracks = training;
  if (!law.delay_s) {
    double least = 1e300, best = 0.0;
    for (double steps = earliest_steps; steps <= latest_steps; steps += between_steps) {
      law.delay_s = steps * training.front().usualStep_s;
      const auto found = inverseBeside(tried, tracks);
      if (!found || found->relativeError >= least || found->value[0] <= 0.0) continue;
      least = found->relativeError;
      best = *law.delay_s;
    }
    law.delay_s = best;
  }
  if (!bench.servo->kp && bench.motor.inertia) {
    const auto found = inverseBeside(tried, tracks);
    const double perUnit = physicsOf(believedDrive(tried)).torquePerInput();
    if (found && found->value[0] > 0.0) law.kp = *bench.motor.inertia / (found->value[0] * perUnit);
  }
  return law;
}

}  // namespace breakaway
