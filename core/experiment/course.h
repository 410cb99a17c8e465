// A course of commands over time and all that the board answers: pulses, steps, ramps.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/message.h"
#include "experiment/timed_procedure.h"

namespace breakaway {

struct CourseOptions {
  Saying activity = message("running a course");
  double zeroing_s = 0.5;  ///< the current sensor is zeroed first, windings open; 0: never
  Command before;          ///< held for before_s, to come to a speed or an angle
  double before_s = 1.0;
  double duration_s = 1.0;  ///< of the course itself
  /// The command at `time_s` since the course began; `start` is the sample with which it began.
  std::function<Command(double time_s, const Sample& start)> command;
};

/// Zeroes the sensor, holds one command, and then runs the course. Fails when no course is given or it takes no time.
class Course : public TimedProcedure {
 public:
  explicit Course(CourseOptions options);
  /// The course's own samples, every tick, times from its beginning.
  const std::vector<Sample>& samples() const { return samples_; }
  /// Mean speed over the last twentieth of the time before.
  double velocityBefore_rad_per_s() const;

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override {
    return timed(elapsed_s_, options_.zeroing_s + options_.before_s + options_.duration_s, options_.activity);
  }

 private:
  CourseOptions options_;
  std::vector<Sample> samples_;
  Sample start_;
  double elapsed_s_ = 0.0, beforeStart_rad_ = 0.0, beforeStart_s_ = -1.0, beforeEnd_rad_ = 0.0, beforeEnd_s_ = 0.0;
};

}  // namespace breakaway
