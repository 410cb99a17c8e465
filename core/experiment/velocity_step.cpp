#include "experiment/velocity_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace breakaway {

namespace {
constexpr double rotaryMotion_rad = 0.005, linearMotion_m = 2e-4;  // less travel is no motion
constexpr double endStall = 0.1;                                   // of stall_s, at the end of the step
}  // namespace

Command VelocityStep::run(const Sample& sample) {
  elapsed_s_ = elapsed_s(sample);
  const double after_s = elapsed_s_ - options_.before_s;
  if (after_s >= -0.1 * options_.after_s) {
    curve_.time_s.push_back(after_s);
    curve_.velocity_rad_per_s.push_back(sample.velocity_rad_per_s);
    curve_.reference_rad_per_s.push_back(after_s >= 0.0 ? options_.to_rad_per_s : options_.from_rad_per_s);
    curve_.current_A.push_back(sample.current_A);
  }
  const double target = after_s >= 0.0 ? options_.to_rad_per_s : options_.from_rad_per_s;
  watchMotion(sample, target);
  if (after_s >= options_.after_s) finish();
  return {Command::Mode::velocity, target, options_.current_limit_A, false};
}

/// A rotor that has gone some way at the speed asked for and stands since then is held; a slow one has its time.
void VelocityStep::watchMotion(const Sample& sample, double target_rad_per_s) {
  const double motion_rad = options_.axis == Axis::linear ? linearMotion_m : rotaryMotion_rad;
  const bool moved = std::abs(sample.angle_rad - movedAngle_rad_) > motion_rad;
  if (moved) movedAngle_rad_ = sample.angle_rad;
  stalled_s_ = moved || std::abs(target_rad_per_s) * options_.stall_s < 10.0 * motion_rad ? 0.0 : stalled_s_ + tick_s();
  const bool atEnd = elapsed_s_ >= options_.before_s + options_.after_s;
  if (stalled_s_ <= (atEnd ? endStall * options_.stall_s : options_.stall_s)) return;
  fail(options_.axis == Axis::linear
           ? message("the axis does not move though {:.3f} m/s are asked for; is it held, or the current limit too "
                     "low?",
                     target_rad_per_s)
           : message("the rotor does not move though {:.1f} rad/s are asked for; is the shaft held, or the current "
                     "limit too low?",
                     target_rad_per_s));
}

StepFigures figuresOf(const StepCurve& curve, const VelocityStepOptions& options) {
  const double missing = std::numeric_limits<double>::quiet_NaN();
  const double size = options.to_rad_per_s - options.from_rad_per_s;
  StepFigures figures{missing, 0.0, missing, 0.0};
  double tenth_s = missing, ninetieth_s = missing, outside_s = 0.0;
  for (size_t k = 0; k < curve.time_s.size(); ++k) {
    if (curve.time_s[k] < 0.0) continue;
    const double part = (curve.velocity_rad_per_s[k] - options.from_rad_per_s) / size;
    if (std::isnan(tenth_s) && part >= 0.1) tenth_s = curve.time_s[k];
    if (std::isnan(ninetieth_s) && part >= 0.9) ninetieth_s = curve.time_s[k];
    figures.overshoot = std::max(figures.overshoot, part - 1.0);
    figures.peakCurrent_A = std::max(figures.peakCurrent_A, std::abs(curve.current_A[k]));
    if (std::abs(part - 1.0) > options.settleBand) outside_s = curve.time_s[k];
  }
  figures.rise_s = ninetieth_s - tenth_s;
  if (!curve.time_s.empty() && outside_s < curve.time_s.back()) figures.settling_s = outside_s;
  return figures;
}

}  // namespace breakaway
