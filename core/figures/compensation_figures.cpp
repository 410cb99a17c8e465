#include "figures/compensation_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers.h"
#include "base/statistics.h"
#include "experiment/central_difference.h"

namespace breakaway {

namespace {

constexpr std::array<Compensated, 3> parts{{{CompensatedFriction::none, "none", "none"},
                                            {CompensatedFriction::coulombAndViscous, "average", "average, F + Bω"},
                                            {CompensatedFriction::map, "map", "measured map"}}};

CourseOptions slowCourse(const SlowMotionOptions& options) {
  CourseOptions course;
  course.activity = "slow motion";
  const Command command{Command::Mode::velocity, options.speed_rad_per_s, 0.0, false};
  course.zeroing_s = 1.0;
  course.before = command;
  course.before_s = 1.0;
  course.duration_s = options.turns * turn_rad / options.speed_rad_per_s + 2.0 * options.halfSpan_s;
  course.command = [command](double, const Sample&) { return command; };
  return course;
}

/// Rms velocity errors under the present settings, and the runs as columns named with `ending`.
Result<std::array<double, parts.size()>> runAll(CommissionedBench& bench, const SlowMotionOptions& options,
                                                const std::string& ending, BenchFigure& figure) {
  std::array<double, parts.size()> errors{};
  for (size_t k = 0; k < parts.size(); ++k) {
    const auto ran = runCourse(bench, slowCourse(options), parts[k].part);
    if (!ran) return ran.error();
    auto [time_s, velocity] = centralDifference(ran->samples, options.halfSpan_s);
    std::vector<double> error = velocity;
    for (double& value : error) value -= options.speed_rad_per_s;
    errors[k] = rms(error);
    for (double& time : time_s) time -= options.halfSpan_s;
    if (figure.columns.empty()) figure.columns.push_back({"time_s", std::move(time_s)});
    if (velocity.size() != figure.columns[0].values.size()) return Error{figure.name, "runs differ in length"};
    figure.columns.push_back({parts[k].column + ending + "_rad_per_s", std::move(velocity)});
    figure.keyNumbers.emplace_back("velocity_error_" + (parts[k].column + ending) + "_rad_per_s", errors[k]);
  }
  return errors;
}

/// Means over stretches of x as long as `stretch`, so that a line shows the rotor and not the encoder's steps.
Curve averaged(const Curve& curve, double stretch) {
  Curve means = curve;
  means.x.clear();
  means.y.clear();
  for (size_t first = 0; first < curve.x.size();) {
    double x = 0.0, y = 0.0, count = 0.0;
    const double end = curve.x[first] + stretch;
    for (; first < curve.x.size() && (count == 0.0 || curve.x[first] < end); ++first)
      x += curve.x[first], y += curve.y[first], count += 1.0;
    means.x.push_back(x / count);
    means.y.push_back(y / count);
  }
  return means;
}

}  // namespace

Result<BenchFigure> slowMotionFigure(CommissionedBench& bench, const SlowMotionOptions& options) {
  BenchFigure figure{
      "slow-motion",
      "The velocity controller with disturbance feedback at a slow speed, on a rotor with strongly uneven "
      "friction: compensated not at all, on average, and by the map that was measured before. The "
      "columns named alone are proportional control without feedback, under which the rotor may stand.",
      {"Slow motion over uneven friction", "time / s", "speed / rad/s"},
      {}};
  const ControllerSettings tuned = bench.drive->settings();
  ControllerSettings alone = tuned;
  alone.observer_cutoff_rad_per_s = 0.0;
  if (const auto taken = bench.drive->configure(alone); !taken) return taken.error();
  const auto errors = runAll(bench, options, "_alone", figure);
  if (const auto taken = bench.drive->configure(tuned); !taken) return taken.error();
  if (!errors) return errors.error();
  const auto observed = runAll(bench, options, "", figure);
  if (!observed) return observed.error();
  for (const Compensated& one : parts) {
    figure.figure.curves.push_back(
        averaged(drawn(figure, one.label, "time_s", std::string(one.column) + "_rad_per_s"), options.halfSpan_s));
  }
  figure.keyNumbers.emplace_back("average_over_map_alone", (*errors)[1] / (*errors)[2]);
  figure.keyNumbers.emplace_back("average_over_map", (*observed)[1] / (*observed)[2]);
  return figure;
}

}  // namespace breakaway
