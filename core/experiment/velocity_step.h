// A step of the velocity reference and what the loop makes of it.
#pragma once

#include <vector>

#include "experiment/timed_procedure.h"

namespace breakaway {

struct VelocityStepOptions {
  double from_rad_per_s = 0.0;
  double to_rad_per_s = 20.0;
  double before_s = 0.8;     ///< at the first speed
  double after_s = 0.6;      ///< recorded after the step
  double settleBand = 0.05;  ///< of the step, for the settling time
  double current_limit_A = 0.0;
  double stall_s = 0.4;      ///< without any motion while it should turn
  Axis axis = Axis::rotary;  ///< linear: read m for rad
};

struct StepFigures {
  double rise_s = 0.0;      ///< from 10 % to 90 %; NaN when not reached
  double overshoot = 0.0;   ///< beyond the final speed, part of the step
  double settling_s = 0.0;  ///< until it stays in the band; NaN when it doesn't
  double peakCurrent_A = 0.0;
};

/// The recorded part; times from the step, the first samples lie before it.
struct StepCurve {
  std::vector<double> time_s, velocity_rad_per_s, reference_rad_per_s, current_A;
};

/// Of a curve that holds the step: measured, or foretold.
StepFigures figuresOf(const StepCurve& curve, const VelocityStepOptions& options);

/// Fails in words when the rotor or the axis doesn't move, or stands at the end though it should.
class VelocityStep : public TimedProcedure {
 public:
  explicit VelocityStep(const VelocityStepOptions& options = {}) : options_(options) {}
  const StepCurve& curve() const { return curve_; }
  StepFigures figures() const { return figuresOf(curve_, options_); }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override {
    return timed(elapsed_s_, options_.before_s + options_.after_s, message("measuring a velocity step"));
  }

 private:
  VelocityStepOptions options_;
  void watchMotion(const Sample& sample, double target_rad_per_s);

  StepCurve curve_;
  double elapsed_s_ = 0.0, movedAngle_rad_ = 0.0, stalled_s_ = 0.0;
};

}  // namespace breakaway
