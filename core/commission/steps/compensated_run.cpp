// The same slow to and fro with and without the measured friction compensated: what the map is good for on this bench.
// Then the wiring once more.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/statistics.h"
#include "commission/held_beliefs.h"
#include "commission/steps.h"
#include "commission/steps/wiring_pulses.h"
#include "experiment/central_difference.h"
#include "experiment/compensation.h"
#include "experiment/course.h"

namespace breakaway {

namespace {

constexpr double period_s = 4.0, periods = 1.5;  // of a sine of speed, so slow that the loop follows it
constexpr double rotorsAmplitude_rad_per_s = 5.0;
constexpr double partOfPace = 0.1, partOfTravel = 0.25;  // that a linear axis takes of either, at most
constexpr double approach_s = 8.0;                       // to the place where the course begins
constexpr double halfSpan_s = 0.005;                     // of the central differences that speeds are

double reference(double time_s, double amplitude_rad_per_s) {
  return amplitude_rad_per_s * std::sin(turn_rad * time_s / period_s);
}

double amplitudeOn(const Commission& known) {
  if (!known.linear()) return rotorsAmplitude_rad_per_s;
  const double reach_m = partOfTravel * known.counted.usable_m();
  return std::min(partOfPace * known.pace.speed_m_per_s, turn_rad * reach_m / period_s);
}

CourseOptions courseOn(const Commission& known, double amplitude_rad_per_s) {
  CourseOptions course;
  course.activity = message("going to and fro slowly");
  course.before = {Command::Mode::velocity, 0.0, 0.0, false};
  course.before_s = 0.5;
  if (known.linear()) {
    const double start_m = known.counted.middle_m() - 0.5 * amplitude_rad_per_s * period_s / std::numbers::pi;
    course.before = {Command::Mode::position, start_m, 0.0, false};
    course.before_s = approach_s;
  }
  course.duration_s = periods * period_s;
  course.command = [amplitude_rad_per_s](double time_s, const Sample&) {
    return Command{Command::Mode::velocity, reference(time_s, amplitude_rad_per_s), 0.0, false};
  };
  return course;
}

double velocityError(const std::vector<Sample>& samples, double amplitude_rad_per_s) {
  const SpeedCurve speed = centralDifference(samples, halfSpan_s);
  std::vector<double> error;
  error.reserve(speed.time_s.size());
  for (size_t k = 0; k < speed.time_s.size(); ++k)
    error.push_back(speed.velocity_rad_per_s[k] - reference(speed.time_s[k], amplitude_rad_per_s));
  return rms(error);
}

class Compensated : public Step {
 public:
  Compensated()
      : Step("run with and without the map",
             {Known::wiring, Known::map, Known::stribeck, Known::index, Known::gainsInUse}, {Known::comparison}) {}
  double expected_s(const SweepSettings&) const override { return 26.0; }

  Result<StepRun> begin(OnBench& on) override {
    if (closing_) {
      check_ = wiringCheckOn(on);
      return StepRun{"10-wiring", check_};
    }
    result_.amplitude_rad_per_s = amplitudeOn(on.known);
    result_.period_s = period_s;
    const auto map = compensationOf(on.known.map, CompensatedFriction::map, on.known.indexAngle_rad.value);
    taken_ = on.drive.compensate(withMap_ ? map : FrictionCompensation{});
    if (!taken_) return StepRun{};
    course_ = std::make_shared<Course>(courseOn(on.known, result_.amplitude_rad_per_s));
    return StepRun{withMap_ ? "09-compensated" : "08-uncompensated", course_};
  }

  Result<void> leave(Drive& drive) override { return taken_ ? drive.compensate({}) : Result<void>(); }

  /// A board that takes no compensation, or a run that fails, leaves a remark. What failed in the last parts and lasts
  /// is told by the wiring check, before anything becomes a result.
  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (closing_) {
      if (!ran) return ran.error();
      if (auto held = holdWiringStill(fitWiring(*check_), on.options, on.known); !held) return held.error();
      return StepEnd::over;
    }
    if (const Result<void>& failed = taken_ ? ran : taken_; !failed) {
      on.known.remark(message("The map wasn't tried out: {}.", failed.error().said()));
      closing_ = true;
      return StepEnd::again;
    }
    (withMap_ ? result_.with_rad_per_s : result_.without_rad_per_s) =
        velocityError(course_->samples(), result_.amplitude_rad_per_s);
    if (!withMap_) {
      withMap_ = true;
      return StepEnd::again;
    }
    on.known.compensatedRun = result_;
    closing_ = true;
    return StepEnd::again;
  }

 private:
  CompensatedRun result_;
  bool withMap_ = false, closing_ = false;
  Result<void> taken_;
  std::shared_ptr<Course> course_;
  std::shared_ptr<WiringCheck> check_;
};

}  // namespace

StepPtr compensatedRunStep() {
  return std::make_unique<Compensated>();
}

}  // namespace breakaway
