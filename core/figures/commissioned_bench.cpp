#include "figures/commissioned_bench.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace breakaway {

double CommissionedBench::highestSpeed_rad_per_s() const {
  double highest = 0.0;
  for (const VelocityRun& run : measured.runs) highest = std::max(highest, std::abs(run.target_rad_per_s));
  return highest;
}

Result<CommissionedBench> commissionBench(std::unique_ptr<Drive> drive, const CommissionOptions& options) {
  auto measured = commission(*drive, options);
  if (!measured) return measured.error();
  return CommissionedBench{std::move(drive), std::move(*measured)};
}

Result<RanCourse> runCourse(CommissionedBench& bench, const CourseOptions& options, CompensatedFriction part) {
  constexpr double slice_s = 0.1;
  const auto friction = compensationOf(bench.measured.map, part, bench.measured.indexAngle_rad.value);
  if (const auto taken = bench.drive->compensate(friction); !taken) return taken.error();
  const auto course = std::make_shared<Course>(options);
  std::vector<Sample> samples;
  bench.drive->start(course);
  while (course->state() == Procedure::State::running) {
    samples.clear();
    if (const auto advanced = bench.drive->advance(slice_s, samples); !advanced) return advanced.error();
  }
  bench.drive->stop("the course is over");
  if (const auto ended = bench.drive->compensate({}); !ended) return ended.error();
  const auto status = course->status();
  if (status.state != Procedure::State::finished) return Error{options.activity, status.failure};
  return RanCourse{course->samples(), course->velocityBefore_rad_per_s()};
}

Result<double> angleNow(CommissionedBench& bench) {
  CourseOptions course;
  course.activity = "looking where it stands";
  course.before = {Command::Mode::velocity, 0.0, 0.0, false};
  course.before_s = 0.5;
  course.duration_s = 0.1;
  course.command = [](double, const Sample&) { return Command{Command::Mode::velocity, 0.0, 0.0, false}; };
  const auto ran = runCourse(bench, course, CompensatedFriction::none);
  if (!ran) return ran.error();
  return ran->samples.back().angle_rad;
}

}  // namespace breakaway
