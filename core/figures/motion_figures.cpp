#include "figures/motion_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/statistics.h"
#include "control/friction_compensator.h"

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
  velocity.reserve(ran.samples.size());
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

Result<std::vector<BenchFigure>> constantVelocityOverTimeFigures(CommissionedBench& bench) {
  constexpr double settle_s = 0.6, turns = 4.0;
  const Commission& measured = bench.measured;
  // The sweep's speed in the middle, counter-clockwise.
  std::vector<double> speeds;
  for (const VelocityRun& run : measured.runs) {
    if (run.way() == Way::ccw) speeds.push_back(run.target_rad_per_s);
  }
  if (speeds.empty()) return Error{"constant-velocity", "no speed was run counter-clockwise"};
  std::sort(speeds.begin(), speeds.end());
  const double target = speeds[speeds.size() / 2];
  CourseOptions course;
  course.activity = "a constant speed";
  course.before = {Command::Mode::velocity, 0.0, 0.0, false};
  course.before_s = 0.5;
  course.duration_s = settle_s + (turns + 0.5) * turn_rad / target;
  course.command = [target](double, const Sample&) { return Command{Command::Mode::velocity, target, 0.0, false}; };
  const auto ran = runCourse(bench, course, CompensatedFriction::none);
  if (!ran) return ran.error();
  const double Kt = bench.torqueConstant_Nm_per_A();
  const auto& samples = ran->samples;
  const auto settled =
      std::find_if(samples.begin(), samples.end(), [](const Sample& s) { return s.time_s >= settle_s; });
  auto end = settled;
  while (end != samples.end() && end->angle_rad < settled->angle_rad + turns * turn_rad) ++end;
  if (end == samples.end()) return Error{"constant-velocity", "the rotor didn't make the turns to average over"};
  const Highlight averaged{settled->time_s, end->time_s, "averaged: 4 turns"};
  double current = 0.0, load = 0.0;
  for (auto one = settled; one != end; ++one) current += one->current_A, load += one->disturbance_estimate_Nm;
  const auto count = static_cast<double>(end - settled);
  BenchFigure speed{"constant-velocity-speed",
                    "One speed of the constant-velocity test from standstill, as the board's observer has it. Friction "
                    "is averaged over whole turns once it is steady.",
                    {"A constant speed over time", "time / s", "speed / rad/s"},
                    {{"time_s", {}}, {"reference_rad_per_s", {}}, {"observed_rad_per_s", velocitiesOf(*ran)}}};
  BenchFigure torque{
      "constant-velocity-torque",
      "The same motion's torque: of the motor, Kt·i, and the disturbance observer's estimate, which is "
      "friction and position torque. Over the turn it swings with both, so it is averaged over whole turns.",
      {"Torque of a constant speed over time", "time / s", "torque / mNm"},
      {{"time_s", {}}, {"motor_Nm", {}}, {"observed_Nm", {}}}};
  for (const Sample& sample : samples) {
    speed.columns[0].values.push_back(sample.time_s);
    speed.columns[1].values.push_back(target);
    torque.columns[0].values.push_back(sample.time_s);
    torque.columns[1].values.push_back(Kt * sample.current_A);
    torque.columns[2].values.push_back(sample.disturbance_estimate_Nm);
  }
  speed.figure.curves = {drawn(speed, "observed", "time_s", "observed_rad_per_s"),
                         drawn(speed, "reference", "time_s", "reference_rad_per_s")};
  speed.figure.curves[1].style = Curve::Style::dashed;
  speed.figure.curves[1].colour = 6;
  torque.figure.curves = {drawn(torque, "motor, Kt·i", "time_s", "motor_Nm", 1e3),
                          drawn(torque, "disturbance observer", "time_s", "observed_Nm", 1e3)};
  torque.figure.curves[0].colour = 4;
  torque.figure.curves[0].width_px = 1.0;
  torque.figure.curves[1].colour = 1;
  speed.figure.highlights = torque.figure.highlights = {averaged};
  const MovingFriction& moving = measured.moving[static_cast<size_t>(Way::ccw)];
  const double span_s = averaged.to - averaged.from;
  speed.keyNumbers = {{"reference_rad_per_s", target},
                      {"mean_rad_per_s", (end->angle_rad - settled->angle_rad) / span_s},
                      {"averaged_from_s", averaged.from},
                      {"averaged_to_s", averaged.to}};
  torque.keyNumbers = {{"mean_motor_Nm", Kt * current / count},
                       {"mean_observed_Nm", load / count},
                       {"line_Nm", moving.coulombMean_Nm.value + moving.viscousMean_Nm_s_per_rad.value * target},
                       {"averaged_from_s", averaged.from},
                       {"averaged_to_s", averaged.to}};
  return std::vector<BenchFigure>{std::move(speed), std::move(torque)};
}

namespace {

/// What methods A and B make of the samples, in Nm.
template <typename Scalar>
std::array<std::vector<double>, 2> methodsOn(const std::vector<Sample>& samples, const std::vector<double>& friction_Nm,
                                             const typename DisturbanceObserver<Scalar>::Settings& settings,
                                             double tick_s) {
  DifferenceCompensator<Scalar> a;
  FilteredCompensator<Scalar> b;
  a.configure(settings, static_cast<Scalar>(tick_s));
  b.configure(settings.cutoff_rad_per_s, static_cast<Scalar>(tick_s));
  a.reset(static_cast<Scalar>(samples.front().velocity_rad_per_s));
  std::array<std::vector<double>, 2> torques;
  for (size_t k = 0; k < samples.size(); ++k) {
    const auto current = static_cast<Scalar>(samples[k].current_A);
    const auto velocity = static_cast<Scalar>(samples[k].velocity_rad_per_s);
    const auto friction = static_cast<Scalar>(friction_Nm[k]);
    torques[0].push_back(static_cast<double>(a.step(current, velocity, friction)));
    torques[1].push_back(static_cast<double>(b.step(friction)));
  }
  return torques;
}

std::vector<double> difference(const std::array<std::vector<double>, 2>& torques) {
  std::vector<double> off;
  off.reserve(torques[0].size());
  for (size_t k = 0; k < torques[0].size(); ++k) off.push_back(torques[0][k] - torques[1][k]);
  return off;
}

}  // namespace

Result<BenchFigure> methodsFigure(CommissionedBench& bench) {
  constexpr double amplitude_rad_per_s = 20.0, period_s = 0.5, periods = 2.0;
  const Commission& measured = bench.measured;
  const ControllerSettings tuned = bench.drive->settings();
  const double tick_s = 1.0 / measured.identity.loopRate_Hz, cutoff = tuned.observer_cutoff_rad_per_s;
  if (!(cutoff > 0.0)) return Error{"friction-methods", "the observer has no cutoff"};
  CourseOptions course;
  course.activity = "a sine of speed";
  course.before = {Command::Mode::velocity, 0.0, 0.0, false};
  course.before_s = 0.5;
  course.duration_s = periods * period_s;
  course.command = [](double time_s, const Sample&) {
    return Command{Command::Mode::velocity, amplitude_rad_per_s * std::sin(turn_rad * time_s / period_s), 0.0, false};
  };
  const auto ran = runCourse(bench, course, CompensatedFriction::none);
  if (!ran) return ran.error();
  const double F = measured.map.coulombAverage_Nm.value, B = measured.map.viscousAverage_Nm_s_per_rad.value;
  BenchFigure figure{
      "friction-methods",
      "The same samples through both: method A subtracts the reaction torque observer from the disturbance observer, "
      "method B passes the friction model through g/(s+g). Current and speed cancel in A, so both give one curve; what "
      "is left is rounding, more of it in single precision, where A subtracts two large numbers.",
      {"Friction compensation by methods A and B", "time / s", "torque / mNm"},
      {{"time_s", {}}, {"velocity_rad_per_s", velocitiesOf(*ran)}, {"model_Nm", {}}}};
  for (const Sample& sample : ran->samples) {
    figure.columns[0].values.push_back(sample.time_s);
    figure.columns[2].values.push_back(dryAndViscous(F, B, sample.velocity_rad_per_s));
  }
  const std::vector<double> model = figure.columns[2].values;
  const auto exact = methodsOn<double>(
      ran->samples, model, {cutoff, tuned.nominal_inertia_kg_m2, tuned.nominal_torque_constant_Nm_per_A}, tick_s);
  const auto single = methodsOn<float>(ran->samples, model,
                                       {static_cast<float>(cutoff), static_cast<float>(tuned.nominal_inertia_kg_m2),
                                        static_cast<float>(tuned.nominal_torque_constant_Nm_per_A)},
                                       tick_s);
  figure.columns.push_back({"a_Nm", exact[0]});
  figure.columns.push_back({"b_Nm", exact[1]});
  figure.columns.push_back({"difference_Nm", difference(exact)});
  figure.columns.push_back({"difference_single_precision_Nm", difference(single)});
  figure.figure.curves = {drawn(figure, "friction model, F·sgn ω + B·ω", "time_s", "model_Nm", 1e3),
                          drawn(figure, "method A", "time_s", "a_Nm", 1e3),
                          drawn(figure, "method B", "time_s", "b_Nm", 1e3)};
  figure.figure.curves[0].colour = 4;
  figure.figure.curves[0].width_px = 1.0;
  figure.figure.curves[1].colour = 1;
  figure.figure.curves[1].width_px = 4.0;
  figure.figure.curves[2].colour = 6;
  figure.figure.curves[2].style = Curve::Style::dashed;
  const double torque = rms(exact[1]);
  figure.keyNumbers = {{"cutoff_rad_per_s", cutoff},
                       {"torque_rms_Nm", torque},
                       {"difference_rms_Nm", rms(difference(exact))},
                       {"difference_single_precision_rms_Nm", rms(difference(single))},
                       {"difference_part", rms(difference(exact)) / torque},
                       {"difference_single_precision_part", rms(difference(single)) / torque}};
  return figure;
}

}  // namespace breakaway
