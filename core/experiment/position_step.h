// A step of the position reference and what the loop makes of it.
#pragma once

#include "experiment/velocity_step.h"

namespace breakaway {

struct PositionStepOptions {
  double by_rad = 0.1;       ///< from where it stands; its sign is the way; not 0
  double before_s = 0.8;     ///< held where it stands
  double after_s = 0.6;      ///< recorded after the step
  double settleBand = 0.05;  ///< of the step, for the settling time
  double current_limit_A = 0.0;
  Axis axis = Axis::rotary;  ///< linear: read m for rad
};

/// Holds the shaft where it stands, then asks for a place beside it. Its curve counts the angle from there, in rad, in
/// the place of the velocity. Fails in words when the shaft stays where it was.
class PositionStep : public TimedProcedure {
 public:
  explicit PositionStep(const PositionStepOptions& options) : options_(options) {}
  const StepCurve& curve() const { return curve_; }
  StepFigures figures() const { return figuresOf(curve_, asVelocityStep(options_)); }

  /// The options as those of a step from 0, for figuresOf().
  static VelocityStepOptions asVelocityStep(const PositionStepOptions& options);

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override {
    return timed(elapsed_s_, options_.before_s + options_.after_s, message("measuring a position step"));
  }

 private:
  void failStill();

  PositionStepOptions options_;
  StepCurve curve_;
  double elapsed_s_ = 0.0, start_rad_ = 0.0;
  double farthestPart_ = 0.0;  ///< of the step
};

}  // namespace breakaway
