#include "figures/commissioned_bench.h"

#include <utility>

namespace breakaway {

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

}  // namespace breakaway
