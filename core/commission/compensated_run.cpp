#include "commission/compensated_run.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "base/statistics.h"
#include "experiment/central_difference.h"
#include "experiment/compensation.h"
#include "experiment/course.h"

namespace breakaway {

namespace {

constexpr double approach_s = 8.0;  // to the place where the course begins
constexpr double share = 0.01;      // of the whole job, each run

double reference(double time_s, const CompensatedRunOptions& options) {
  return options.amplitude_rad_per_s * std::sin(2.0 * std::numbers::pi * time_s / options.period_s);
}

CourseOptions courseOf(const CompensatedRunOptions& options) {
  CourseOptions course;
  course.activity = "going to and fro slowly";
  course.before = {Command::Mode::velocity, 0.0, 0.0, false};
  course.before_s = 0.5;
  if (options.start_rad) {
    course.before = {Command::Mode::position, *options.start_rad, 0.0, false};
    course.before_s = approach_s;
  }
  course.duration_s = options.periods * options.period_s;
  course.command = [options](double time_s, const Sample&) {
    return Command{Command::Mode::velocity, reference(time_s, options), 0.0, false};
  };
  return course;
}

double velocityError(const std::vector<Sample>& samples, const CompensatedRunOptions& options) {
  const SpeedCurve speed = centralDifference(samples, options.halfSpan_s);
  std::vector<double> error;
  for (size_t k = 0; k < speed.time_s.size(); ++k)
    error.push_back(speed.velocity_rad_per_s[k] - reference(speed.time_s[k], options));
  return rms(error);
}

}  // namespace

Result<void> runCompensated(Drive& drive, CommissionSteps& steps, Commission& done,
                            const CompensatedRunOptions& options) {
  const auto map = compensationOf(done.map, CompensatedFriction::map, done.indexAngle_rad.value);
  CompensatedRun result{options.amplitude_rad_per_s, options.period_s};
  for (const bool compensated : {false, true}) {
    const auto taken = drive.compensate(compensated ? map : FrictionCompensation{});
    if (!taken) {
      done.remarks.push_back("The map wasn't tried out: " + taken.error().message() + ".");
      return {};
    }
    const auto course = std::make_shared<Course>(courseOf(options));
    auto ran = steps.run(compensated ? "09-compensated" : "08-uncompensated", course, share);
    if (auto ended = drive.compensate({}); !ended) return ended;
    if (course->state() == Procedure::State::stopped) return ran;
    if (!ran) {
      done.remarks.push_back("The map wasn't tried out: " + ran.error().message() + ".");
      return {};
    }
    (compensated ? result.with_rad_per_s : result.without_rad_per_s) = velocityError(course->samples(), options);
  }
  done.compensatedRun = result;
  return {};
}

}  // namespace breakaway
