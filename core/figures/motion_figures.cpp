#include "figures/motion_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double rampSpeed_rad_per_s = 100.0 * turn_rad / 60.0;
constexpr double ramp_s = 3.0;

double rampAt(double time_s) {
  return rampSpeed_rad_per_s * std::clamp(time_s / ramp_s, 0.0, 1.0);
}

void addStepNumbers(BenchFigure& figure, double step_rad) {
  const auto& time_s = columnOf(figure, "time_s");
  const auto& angle = columnOf(figure, "angle_rad");
  double tenth_s = -1.0, ninetieth_s = -1.0, outside_s = 0.0, most = 0.0;
  for (size_t k = 0; k < time_s.size(); ++k) {
    if (tenth_s < 0.0 && angle[k] >= 0.1 * step_rad) tenth_s = time_s[k];
    if (ninetieth_s < 0.0 && angle[k] >= 0.9 * step_rad) ninetieth_s = time_s[k];
    if (std::abs(angle[k] - step_rad) > 0.5 * degree) outside_s = time_s[k];
    most = std::max(most, angle[k]);
  }
  figure.keyNumbers = {{"rise_s", ninetieth_s - tenth_s},
                       {"overshoot_deg", std::max(0.0, most - step_rad) / degree},
                       {"settling_s", outside_s},
                       {"error_at_end_deg", (angle.back() - step_rad) / degree}};
}

Result<RanCourse> ramp(CommissionedBench& bench) {
  CourseOptions course;
  course.activity = "100 rpm with a 3 s ramp";
  course.before = {Command::Mode::velocity, 0.0, 0.0, false};
  course.before_s = 0.5;
  course.duration_s = ramp_s + 2.0;
  course.command = [](double time_s, const Sample&) {
    return Command{Command::Mode::velocity, rampAt(time_s), 0.0, false};
  };
  return runCourse(bench, course, CompensatedFriction::none);
}

std::vector<double> velocitiesOf(const RanCourse& ran) {
  std::vector<double> velocity;
  for (const Sample& sample : ran.samples) velocity.push_back(sample.velocity_rad_per_s);
  return velocity;
}

/// Rms of the velocity's error while ramping and afterwards.
void addRampNumbers(BenchFigure& figure, const std::string& column, const std::string& name) {
  const auto& time_s = columnOf(figure, "time_s");
  const auto& velocity = columnOf(figure, column);
  std::vector<double> rising, held;
  for (size_t k = 0; k < time_s.size(); ++k)
    (time_s[k] < ramp_s ? rising : held).push_back(velocity[k] - rampAt(time_s[k]));
  figure.keyNumbers.emplace_back(name + "_error_on_ramp_rad_per_s", rms(rising));
  figure.keyNumbers.emplace_back(name + "_error_after_ramp_rad_per_s", rms(held));
}

}  // namespace

Result<BenchFigure> positionStepFigure(CommissionedBench& bench) {
  constexpr double step_rad = std::numbers::pi;
  CourseOptions course;
  course.activity = "a 180° step";
  course.before = {Command::Mode::velocity, 0.0, 0.0, false};
  course.before_s = 0.5;
  course.duration_s = 0.6;
  course.command = [](double, const Sample& start) {
    return Command{Command::Mode::position, start.angle_rad + step_rad, 0.0, false};
  };
  const auto ran = runCourse(bench, course, CompensatedFriction::none);
  if (!ran) return ran.error();
  BenchFigure figure{
      "position-step",
      "The position controller with disturbance feedback, critically damped, takes a 180° step; the "
      "current limit bounds how fast.",
      {"180° step with disturbance feedback", "time / ms", "angle / °"},
      {{"time_s", {}}, {"reference_rad", {}}, {"angle_rad", {}}, {"velocity_rad_per_s", {}}, {"current_A", {}}}};
  for (const Sample& sample : ran->samples) {
    const double row[] = {sample.time_s, step_rad, sample.angle_rad - ran->samples.front().angle_rad,
                          sample.velocity_rad_per_s, sample.current_A};
    for (size_t k = 0; k < figure.columns.size(); ++k) figure.columns[k].values.push_back(row[k]);
  }
  figure.figure.curves = {drawn(figure, "reference", "time_s", "reference_rad", 1.0 / degree, 1e3),
                          drawn(figure, "angle", "time_s", "angle_rad", 1.0 / degree, 1e3)};
  figure.figure.curves[0].style = Curve::Style::dashed;
  addStepNumbers(figure, step_rad);
  return figure;
}

Result<BenchFigure> velocityRampFigure(CommissionedBench& bench) {
  const auto observed = ramp(bench);
  if (!observed) return observed.error();
  const ControllerSettings tuned = bench.drive->settings();
  ControllerSettings alone = tuned;
  alone.observer_cutoff_rad_per_s = 0.0;
  if (const auto taken = bench.drive->configure(alone); !taken) return taken.error();
  const auto unobserved = ramp(bench);
  if (const auto taken = bench.drive->configure(tuned); !taken) return taken.error();
  if (!unobserved) return unobserved.error();
  if (unobserved->samples.size() != observed->samples.size()) return Error{"velocity-ramp", "runs differ in length"};
  BenchFigure figure{"velocity-ramp",
                     "From standstill to 100 rpm in 3 s. Proportional control alone leaves the error that overcomes "
                     "friction; disturbance feedback takes it away.",
                     {"100 rpm with a 3 s ramp", "time / s", "speed / rad/s"},
                     {{"time_s", {}},
                      {"reference_rad_per_s", {}},
                      {"observed_rad_per_s", velocitiesOf(*observed)},
                      {"alone_rad_per_s", velocitiesOf(*unobserved)}}};
  for (const Sample& sample : observed->samples) {
    figure.columns[0].values.push_back(sample.time_s);
    figure.columns[1].values.push_back(rampAt(sample.time_s));
  }
  figure.figure.curves = {drawn(figure, "proportional alone", "time_s", "alone_rad_per_s"),
                          drawn(figure, "with disturbance feedback", "time_s", "observed_rad_per_s"),
                          drawn(figure, "reference", "time_s", "reference_rad_per_s")};
  figure.figure.curves[2].style = Curve::Style::dashed;
  figure.figure.curves[2].colour = 6;
  addRampNumbers(figure, "observed_rad_per_s", "with_feedback");
  addRampNumbers(figure, "alone_rad_per_s", "alone");
  return figure;
}

}  // namespace breakaway
