#include "experiment/course.h"

#include <algorithm>
#include <utility>

namespace breakaway {

Course::Course(CourseOptions options) : options_(std::move(options)) {
  if (!options_.command || !(options_.duration_s > 0.0)) fail(message("no course is given"));
}

Command Course::run(const Sample& sample) {
  elapsed_s_ = elapsed_s(sample);
  if (elapsed_s_ < options_.zeroing_s) {
    Command command;
    command.zeroCurrentSensor = elapsed_s_ > 0.1 * options_.zeroing_s;
    return command;
  }
  const double inBefore_s = elapsed_s_ - options_.zeroing_s;
  if (inBefore_s < options_.before_s) {
    if (beforeStart_s_ < 0.0 && inBefore_s > 0.95 * options_.before_s) {
      beforeStart_s_ = elapsed_s_;
      beforeStart_rad_ = sample.angle_rad;
    }
    beforeEnd_s_ = elapsed_s_;
    beforeEnd_rad_ = sample.angle_rad;
    return options_.before;
  }
  if (samples_.empty()) start_ = sample;
  const double time_s = sample.time_s - start_.time_s;
  samples_.push_back(sample);
  samples_.back().time_s = time_s;
  if (time_s >= options_.duration_s - 0.5 * tick_s()) finish();  // else rounding would decide about the last tick
  return options_.command(time_s, start_);
}

double Course::velocityBefore_rad_per_s() const {
  const double span_s = beforeEnd_s_ - beforeStart_s_;
  return beforeStart_s_ < 0.0 || span_s <= 0.0 ? 0.0 : (beforeEnd_rad_ - beforeStart_rad_) / span_s;
}

}  // namespace breakaway
