#include "figures/external_torque_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "base/statistics.h"
#include "draw/html_report.h"

namespace breakaway {

namespace {

constexpr auto& torqueParts = fromNoneToMap;
constexpr double zeroing_s = 0.5, before_s = 1.5;

/// The pulse in a course's time.
struct Push {
  double torque_Nm = 0.0, start_s = 0.0, duration_s = 0.0;

  /// Its time integral up to then, in Nm s.
  double impulse(double time_s) const { return torque_Nm * std::clamp(time_s - start_s, 0.0, duration_s); }
  double at_Nm(double time_s) const { return time_s >= start_s && time_s < start_s + duration_s ? torque_Nm : 0.0; }
  double course_s() const { return start_s + 2.5 * duration_s; }
};

Push pushFor(const CommissionedBench& bench, const ExternalTorqueOptions& options) {
  Push push;
  push.torque_Nm = options.torque * bench.measured.map.coulombAverage_Nm.value;
  push.duration_s = std::min(options.step_rad_per_s * bench.inertia_kg_m2() / push.torque_Nm, options.mostPulse_s);
  push.start_s = 0.5 * push.duration_s;
  return push;
}

/// The same board, powered up anew and set as commissioning left it, under one pulse.
Result<RanCourse> underPush(const CommissionedBench& bench, const OpenPushed& pushed, const Push& push,
                            const Command& command, double speed_rad_per_s, double cutoff_rad_per_s,
                            CompensatedFriction part) {
  auto drive = pushed({push.torque_Nm, zeroing_s + before_s + push.start_s, push.duration_s});
  if (!drive) return drive.error();
  ControllerSettings settings = bench.drive->settings();
  settings.observer_cutoff_rad_per_s = cutoff_rad_per_s;
  if (const auto taken = (*drive)->configure(settings); !taken) return taken.error();
  if (bench.measured.linearised) {
    if (const auto taken = (*drive)->linearise(bench.measured.motor.dutyCurve); !taken) return taken.error();
  }
  CommissionedBench again{std::move(*drive), bench.measured};
  CourseOptions course;
  course.activity = "a torque from outside";
  course.zeroing_s = zeroing_s;
  course.before = {Command::Mode::velocity, speed_rad_per_s, 0.0, false};
  course.before_s = before_s;
  course.duration_s = push.course_s();
  course.command = [command](double, const Sample&) { return command; };
  return runCourse(again, course, part);
}

std::vector<double> velocities(const RanCourse& ran) {
  std::vector<double> values;
  values.reserve(ran.samples.size());
  for (const Sample& sample : ran.samples) values.push_back(sample.velocity_rad_per_s);
  return values;
}

double rmsApart(const std::vector<double>& one, const std::vector<double>& other) {
  std::vector<double> off;
  off.reserve(one.size());
  for (size_t k = 0; k < one.size(); ++k) off.push_back(one[k] - other[k]);
  return rms(off);
}

std::string pushWords(const Push& push) {
  return "A torque of " + numberText(1e3 * push.torque_Nm, 3) + " mNm on the shaft from outside, for " +
         numberText(1e3 * push.duration_s, 3) + " ms";
}

Channel timesOf(const RanCourse& ran) {
  Channel time{"time_s", {}};
  for (const Sample& sample : ran.samples) time.values.push_back(sample.time_s);
  return time;
}

/// Whole motor torque that the map has at the sample's angle and speed, towards growing angle.
double measuredFriction_Nm(const Commission& measured, const Sample& sample) {
  const auto& bins = measured.map.bins;
  const double turns = (sample.angle_rad - measured.indexAngle_rad.value) / turn_rad;
  const double part = turns - std::floor(turns), speed = sample.velocity_rad_per_s;
  const size_t bin = std::min(bins.size() - 1, static_cast<size_t>(part * static_cast<double>(bins.size())));
  const WayBin& way = bins[bin].way[static_cast<size_t>(speed < 0.0 ? Way::cw : Way::ccw)];
  return std::copysign(way.coulomb_Nm.value, speed) + way.viscous_Nm_s_per_rad.value * speed;
}

/// The pulse, and the observed load less the measured friction: while the velocity controller holds the speed.
BenchFigure pulseFigure(const CommissionedBench& bench, const Push& push, const RanCourse& held) {
  BenchFigure figure{"external-torque",
                     pushWords(push) +
                         ", and what the board sees of it: the disturbance observer's torque less that of the measured "
                         "friction at that angle.",
                     {"Torque from outside", "time / ms", "torque / mNm"},
                     {timesOf(held), {"pulse_Nm", {}}, {"observed_Nm", {}}}};
  std::vector<double> during, before;
  const double cutoff = bench.measured.settings.observer_cutoff_rad_per_s;
  for (const Sample& sample : held.samples) {
    const double friction = measuredFriction_Nm(bench.measured, sample);
    const double observed = friction - sample.disturbance_estimate_Nm;  // loads count against growing angle
    figure.columns[1].values.push_back(push.at_Nm(sample.time_s));
    figure.columns[2].values.push_back(observed);
    if (sample.time_s < push.start_s) before.push_back(observed);
    // Four time constants of the observer after its beginning.
    if (sample.time_s > push.start_s + std::min(4.0 / cutoff, 0.7 * push.duration_s) &&
        sample.time_s < push.start_s + push.duration_s)
      during.push_back(observed);
  }
  figure.figure.curves = {drawn(figure, "pulse", "time_s", "pulse_Nm", 1e3, 1e3),
                          drawn(figure, "observed", "time_s", "observed_Nm", 1e3, 1e3)};
  figure.figure.curves[0].colour = 6;
  figure.figure.curves[0].style = Curve::Style::dashed;
  figure.keyNumbers = {{"pulse_Nm", push.torque_Nm},
                       {"pulse_s", push.duration_s},
                       {"observed_Nm", mean(during)},
                       {"observed_before_Nm", mean(before)}};
  return figure;
}

Result<BenchFigure> freeFigure(const CommissionedBench& bench, const OpenPushed& pushed, const Push& push,
                               double speed_rad_per_s) {
  BenchFigure figure{"external-torque-response",
                     pushWords(push) +
                         ", on a rotor whose current is commanded zero: the board adds the torque of the measured "
                         "friction alone. The dashed line is the rotor without friction, ω₀ + ∫τ dt/J.",
                     {"Response to a torque from outside", "time / ms", "speed / rad/s"},
                     {}};
  for (const Compensated& one : torqueParts) {
    const auto ran = underPush(bench, pushed, push, {Command::Mode::current, 0.0, 0.0, false}, speed_rad_per_s,
                               bench.measured.settings.observer_cutoff_rad_per_s, one.part);
    if (!ran) return ran.error();
    std::vector<double> ideal;
    for (const Sample& sample : ran->samples)
      ideal.push_back(ran->velocityBefore_rad_per_s + push.impulse(sample.time_s) / bench.inertia_kg_m2());
    const auto velocity = velocities(*ran);
    figure.keyNumbers.emplace_back(std::string("velocity_error_") + one.column + "_rad_per_s",
                                   rmsApart(velocity, ideal));
    if (figure.columns.empty()) {
      figure.columns.push_back(timesOf(*ran));
      figure.columns.push_back({"without_friction_rad_per_s", ideal});
    }
    figure.columns.push_back({std::string(one.column) + "_rad_per_s", velocity});
  }
  figure.figure.curves.push_back(drawn(figure, "without friction", "time_s", "without_friction_rad_per_s", 1.0, 1e3));
  figure.figure.curves.back().style = Curve::Style::dashed;
  figure.figure.curves.back().colour = 6;
  for (size_t k = 0; k < torqueParts.size(); ++k) {
    figure.figure.curves.push_back(
        drawn(figure, torqueParts[k].label, "time_s", std::string(torqueParts[k].column) + "_rad_per_s", 1.0, 1e3));
    figure.figure.curves.back().colour = static_cast<int>(k);
  }
  figure.figure.highlights = {{1e3 * push.start_s, 1e3 * (push.start_s + push.duration_s), "pulse"}};
  return figure;
}

BenchFigure heldFigure(const Push& push, const RanCourse& with, const RanCourse& alone, double speed_rad_per_s) {
  BenchFigure figure{
      "external-torque-held",
      pushWords(push) + ", against the velocity controller with and without disturbance feedback.",
      {"A speed held against a torque from outside", "time / ms", "speed / rad/s"},
      {timesOf(with), {"with_feedback_rad_per_s", velocities(with)}, {"alone_rad_per_s", velocities(alone)}}};
  figure.figure.curves = {drawn(figure, "with disturbance feedback", "time_s", "with_feedback_rad_per_s", 1.0, 1e3),
                          drawn(figure, "proportional alone", "time_s", "alone_rad_per_s", 1.0, 1e3)};
  figure.figure.highlights = {{1e3 * push.start_s, 1e3 * (push.start_s + push.duration_s), "pulse"}};
  const auto& time_s = figure.columns[0].values;
  for (size_t k = 1; k < 3; ++k) {
    const auto& velocity = figure.columns[k].values;
    const std::string name = k == 1 ? "with_feedback" : "alone";
    double most = 0.0, last = 0.0;
    const double from = mean({velocity.begin(), velocity.begin() + 20});
    for (size_t n = 0; n < velocity.size(); ++n) {
      most = std::max(most, std::abs(velocity[n] - from));
      if (time_s[n] < push.start_s + push.duration_s) last = velocity[n] - from;
    }
    figure.keyNumbers.emplace_back(name + "_most_rad_per_s", most);
    figure.keyNumbers.emplace_back(name + "_at_its_end_rad_per_s", last);
  }
  figure.keyNumbers.emplace_back("speed_rad_per_s", speed_rad_per_s);
  return figure;
}

}  // namespace

Result<std::vector<BenchFigure>> externalTorqueFigures(const CommissionedBench& bench, const OpenPushed& pushed,
                                                       const ExternalTorqueOptions& options) {
  const Push push = pushFor(bench, options);
  const double speed = options.speed * bench.highestSpeed_rad_per_s();
  const Command hold{Command::Mode::velocity, speed, 0.0, false};
  const auto with = underPush(bench, pushed, push, hold, speed, bench.measured.settings.observer_cutoff_rad_per_s,
                              CompensatedFriction::none);
  if (!with) return with.error();
  const auto alone = underPush(bench, pushed, push, hold, speed, 0.0, CompensatedFriction::none);
  if (!alone) return alone.error();
  auto response = freeFigure(bench, pushed, push, speed);
  if (!response) return response.error();
  if (with->samples.size() != alone->samples.size()) return Error{"external-torque", "runs differ in length"};
  return std::vector<BenchFigure>{pulseFigure(bench, push, *with), std::move(*response),
                                  heldFigure(push, *with, *alone, speed)};
}

}  // namespace breakaway
