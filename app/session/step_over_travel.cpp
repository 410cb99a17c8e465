#include "session/step_over_travel.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

constexpr double partOfPace = 0.3;     // that it goes to its beginning with
constexpr double partOfTravel = 0.9;   // between the margins, that a step takes
constexpr double mostOvershoot = 0.5;  // of a step in position

}  // namespace

StepOverTravel::StepOverTravel(const Commission& axis, std::shared_ptr<Procedure> step)
    : way_(axis.counted.first_m(), 0.5 * axis.counted.margin_m,
           Glide(partOfPace * axis.pace.speed_m_per_s, axis.pace.acceleration_m_per_s2)),
      step_(std::move(step)) {
}

Command StepOverTravel::step(const Sample& sample) {
  return there() ? step_->step(sample) : way_.step(sample);
}

Procedure::Status StepOverTravel::status() const {
  if (there()) return step_->status();
  Status status = way_.status();
  status.progress *= 0.5;
  status.remaining_s += step_->status().remaining_s;
  return status;
}

void StepOverTravel::stop(const Saying& reason) {
  way_.stop(reason);
  if (there()) step_->stop(reason);
}

double highestStep_m_per_s(const Commission& axis, const VelocityStepOptions& options) {
  // v·t + v²·m/(2·C): the friction alone stops it.
  const double coasting = 0.5 * axis.motor.inertia_kg_m2.value / std::max(1e-6, axis.motor.coulomb_Nm.value);
  const double t = options.after_s, room_m = partOfTravel * axis.counted.usable_m();
  const double byRoom = (std::sqrt(t * t + 4.0 * coasting * room_m) - t) / (2.0 * coasting);
  return std::min(axis.pace.speed_m_per_s, byRoom);
}

double longestStep_m(const Commission& axis) {
  return partOfTravel * axis.counted.usable_m() / (1.0 + mostOvershoot);
}

}  // namespace breakaway
