#include "experiment/position_step.h"

#include <algorithm>
#include <numbers>

namespace breakaway {

namespace {
constexpr double leastFollowed = 0.1;  // of the step: less is no step
constexpr double recordedLead = 0.1;   // of what is recorded after the step, before it
}  // namespace

VelocityStepOptions PositionStep::asVelocityStep(const PositionStepOptions& options) {
  VelocityStepOptions step;
  step.from_rad_per_s = 0.0;
  step.to_rad_per_s = options.by_rad;
  step.before_s = options.before_s;
  step.after_s = options.after_s;
  step.settleBand = options.settleBand;
  step.current_limit_A = options.current_limit_A;
  step.axis = options.axis;
  return step;
}

Command PositionStep::run(const Sample& sample) {
  if (isFirst()) start_rad_ = sample.angle_rad;
  elapsed_s_ = elapsed_s(sample);
  const double after_s = elapsed_s_ - options_.before_s;
  const double wanted_rad = after_s >= 0.0 ? options_.by_rad : 0.0, gone_rad = sample.angle_rad - start_rad_;
  if (after_s >= -recordedLead * options_.after_s) {
    curve_.time_s.push_back(after_s);
    curve_.velocity_rad_per_s.push_back(gone_rad);
    curve_.reference_rad_per_s.push_back(wanted_rad);
    curve_.current_A.push_back(sample.current_A);
  }
  if (after_s >= 0.0) farthestPart_ = std::max(farthestPart_, gone_rad / options_.by_rad);
  if (after_s >= options_.after_s) {
    if (farthestPart_ < leastFollowed) failStill();
    finish();
  }
  return {Command::Mode::position, start_rad_ + wanted_rad, options_.current_limit_A, false};
}

void PositionStep::failStill() {
  constexpr double degree = std::numbers::pi / 180.0;
  fail(
      options_.axis == Axis::linear
          ? message("the axis does not follow a step of {:.3g} mm; is it held, the current limit too low, or the step "
                    "too small for its friction?",
                    1e3 * options_.by_rad)
          : message("the rotor does not follow a step of {:.3g}°; is the shaft held, the current limit too low, or the "
                    "step too small for its friction?",
                    options_.by_rad / degree));
}

}  // namespace breakaway
