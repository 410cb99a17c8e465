#include "figures/pulse_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers.h"
#include "base/statistics.h"
#include "draw/html_report.h"

namespace breakaway {

namespace {

constexpr auto& pulseParts = fromNoneToMap;

struct Pulses {
  double current_A = 0.0, width_s = 0.0;
  size_t pairs = 0;  ///< 0: one pulse one way

  /// A pause as long as a pulse stands before and after each one.
  double duration_s() const { return pairs == 0 ? 6.0 * width_s : (4.0 * static_cast<double>(pairs) + 1.0) * width_s; }
  double at_A(double time_s) const {
    const auto slot = static_cast<size_t>(std::max(0.0, time_s / width_s));
    if (slot % 2 == 0 || time_s >= duration_s() || (pairs == 0 && slot > 1)) return 0.0;
    const size_t pulse = (slot / 2) % 4;  // there, back, the other way there, back: the speed goes to both sides
    return pulse == 0 || pulse == 3 ? current_A : -current_A;
  }
};

Pulses pulsesFor(const CommissionedBench& bench, const PulseFigureOptions& options, size_t pairs) {
  const double friction_A = bench.measured.map.coulombAverage_Nm.value / bench.torqueConstant_Nm_per_A();
  Pulses pulses;
  pulses.current_A = std::min(options.pulseTorque * friction_A, 0.5 * bench.measured.settings.current_limit_A);
  const double acceleration = bench.torqueConstant_Nm_per_A() * pulses.current_A / bench.inertia_kg_m2();
  pulses.width_s = std::min(options.step_rad_per_s / acceleration, options.mostPulse_s);
  pulses.pairs = pairs;
  return pulses;
}

CourseOptions courseOf(const Pulses& pulses, const Command& before) {
  CourseOptions course;
  course.activity = "torque pulses";
  course.before = before;
  course.before_s = before.mode == Command::Mode::position ? 2.0 : 1.5;
  course.duration_s = pulses.duration_s();
  course.command = [pulses](double time_s, const Sample&) {
    return Command{Command::Mode::current, pulses.at_A(time_s), 0.0, false};
  };
  return course;
}

/// Velocity of the rotor without friction at each sample, from the speed before and the pulses alone.
std::vector<double> withoutFriction(const RanCourse& ran, const Pulses& pulses, double torquePerInertia) {
  std::vector<double> velocity;
  double now = ran.velocityBefore_rad_per_s, last_s = 0.0;
  for (const Sample& sample : ran.samples) {
    now += torquePerInertia * pulses.at_A(last_s) * (sample.time_s - last_s);
    last_s = sample.time_s;
    velocity.push_back(now);
  }
  return velocity;
}

struct PulseRun {
  BenchFigure figure;
  std::array<double, pulseParts.size()> error_rad_per_s{};
};

/// What comes before the series: a speed, or one of the places around the rotor, `starts` of them.
struct Beginning {
  double speed_rad_per_s = 0.0;
  size_t starts = 0;  ///< 0: wherever it is

  size_t series() const { return std::max<size_t>(1, starts); }
  /// `angle_rad` is where the rotor was last seen, `index_rad` the index.
  Command command(size_t number, double angle_rad, double index_rad) const {
    if (starts == 0) return {Command::Mode::velocity, speed_rad_per_s, 0.0, false};
    const double place_rad = index_rad + turn_rad * static_cast<double>(number) / static_cast<double>(starts);
    return {Command::Mode::position, angle_rad + std::remainder(place_rad - angle_rad, turn_rad), 0.0, false};
  }
};

Result<PulseRun> pulseRun(CommissionedBench& bench, const Pulses& pulses, const Beginning& beginning) {
  PulseRun run;
  BenchFigure& figure = run.figure;
  const double perInertia = bench.torqueConstant_Nm_per_A() / bench.inertia_kg_m2();
  for (size_t k = 0; k < pulseParts.size(); ++k) {
    std::vector<double> time_s, pulse_A, velocity, ideal, error;
    for (size_t start = 0; start < beginning.series(); ++start) {
      const auto here_rad = beginning.starts > 0 ? angleNow(bench) : Result<double>(0.0);
      if (!here_rad) return here_rad.error();
      const Command before = beginning.command(start, *here_rad, bench.measured.indexAngle_rad.value);
      const auto ran = runCourse(bench, courseOf(pulses, before), pulseParts[k].part);
      if (!ran) return ran.error();
      const auto free = withoutFriction(*ran, pulses, perInertia);
      for (size_t n = 0; n < ran->samples.size(); ++n) error.push_back(ran->samples[n].velocity_rad_per_s - free[n]);
      if (start > 0) continue;
      ideal = free;
      for (const Sample& sample : ran->samples) {
        time_s.push_back(sample.time_s);
        pulse_A.push_back(pulses.at_A(sample.time_s));
        velocity.push_back(sample.velocity_rad_per_s);
      }
    }
    run.error_rad_per_s[k] = rms(error);
    if (k == 0) {
      figure.columns.push_back({"time_s", time_s});
      figure.columns.push_back({"pulse_A", pulse_A});
      figure.columns.push_back({"without_friction_rad_per_s", ideal});
    }
    if (velocity.size() != figure.columns.front().values.size()) return Error{"pulses", "runs differ in length"};
    figure.columns.push_back({std::string(pulseParts[k].column) + "_rad_per_s", velocity});
    figure.keyNumbers.emplace_back(std::string("velocity_error_") + pulseParts[k].column + "_rad_per_s",
                                   run.error_rad_per_s[k]);
    figure.keyNumbers.emplace_back(std::string("mean_error_") + pulseParts[k].column + "_rad_per_s", mean(error));
  }
  figure.figure.xLabel = "time / ms";
  figure.figure.yLabel = "speed / rad/s";
  figure.figure.curves.push_back(drawn(figure, "without friction", "time_s", "without_friction_rad_per_s", 1.0, 1e3));
  figure.figure.curves.back().style = Curve::Style::dashed;
  figure.figure.curves.back().colour = 6;
  for (size_t k = 0; k < pulseParts.size(); ++k) {
    figure.figure.curves.push_back(
        drawn(figure, pulseParts[k].label, "time_s", std::string(pulseParts[k].column) + "_rad_per_s", 1.0, 1e3));
    figure.figure.curves.back().colour = static_cast<int>(k);
  }
  figure.keyNumbers.emplace_back("speed_rad_per_s", beginning.speed_rad_per_s);
  figure.keyNumbers.emplace_back("pulse_A", pulses.current_A);
  figure.keyNumbers.emplace_back("pulse_s", pulses.width_s);
  return run;
}

std::string pulseWords(const Pulses& pulses) {
  return "Pulses of " + numberText(pulses.current_A, 3) + " A for " + numberText(1e3 * pulses.width_s, 3) +
         " ms in current mode; the board adds the torque of the measured friction.";
}

}  // namespace

Result<BenchFigure> onePulseFigure(CommissionedBench& bench, const PulseFigureOptions& options) {
  const Pulses pulses = pulsesFor(bench, options, 0);
  auto run = pulseRun(bench, pulses, {options.onePulseSpeed * bench.highestSpeed_rad_per_s()});
  if (!run) return run.error();
  run->figure.name = "one-pulse";
  run->figure.figure.title = "Response to one torque pulse";
  run->figure.says = pulseWords(pulses) + " What friction is left makes the speed fall away from the dashed line.";
  return std::move(run->figure);
}

Result<std::vector<BenchFigure>> twoWayPulseFigures(CommissionedBench& bench, const PulseFigureOptions& options) {
  const Pulses pulses = pulsesFor(bench, options, std::max<size_t>(1, options.pairs));
  std::vector<BenchFigure> figures;
  BenchFigure summary{"two-way-pulses-error", "", {}, {{"speed_rad_per_s", {}}}};
  for (const Compensated& one : pulseParts) summary.columns.push_back({std::string(one.column) + "_rad_per_s", {}});
  double leastGain = 0.0;
  for (const double part : options.speeds) {
    const double speed = part * bench.highestSpeed_rad_per_s();
    auto run = pulseRun(bench, pulses, {speed, speed == 0.0 ? options.starts : 0});
    if (!run) return run.error();
    run->figure.name = "two-way-pulses-" + std::to_string(figures.size() + 1);
    run->figure.figure.title = "Two-way pulses from " + numberText(speed, 3) + " rad/s";
    run->figure.says = pulseWords(pulses);
    const double gain = run->error_rad_per_s[0] / run->error_rad_per_s[2];
    run->figure.keyNumbers.emplace_back("none_over_f_and_b", gain);
    leastGain = figures.empty() ? gain : std::min(leastGain, gain);
    summary.columns[0].values.push_back(speed);
    for (size_t k = 0; k < pulseParts.size(); ++k) summary.columns[k + 1].values.push_back(run->error_rad_per_s[k]);
    figures.push_back(std::move(run->figure));
  }
  summary.figure.title = "Velocity error of two-way pulses";
  summary.figure.xLabel = "speed before the pulses / rad/s";
  summary.figure.yLabel = "velocity error, rms / rad/s";
  summary.figure.logY = true;
  for (const Compensated& one : pulseParts)
    summary.figure.curves.push_back(
        drawn(summary, one.label, "speed_rad_per_s", std::string(one.column) + "_rad_per_s"));
  summary.says =
      "The rms distance of the speed from that of a rotor without friction, over the whole series; from standstill "
      "over " +
      std::to_string(options.starts) + " series that begin around the rotor.";
  summary.keyNumbers.emplace_back("least_none_over_f_and_b", leastGain);
  figures.push_back(std::move(summary));
  return figures;
}

}  // namespace breakaway
