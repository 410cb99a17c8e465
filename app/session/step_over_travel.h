// A step on a linear axis, whose room ends: from the lower margin on, as high or as far as the travel allows.
#pragma once

#include <memory>

#include "commission/known.h"
#include "experiment/velocity_step.h"
#include "session/travel_to.h"

namespace breakaway {

/// Goes to the lower margin, then steps.
class StepOverTravel : public Procedure {
 public:
  /// `axis`: homed. `step`: that is made.
  StepOverTravel(const Commission& axis, std::shared_ptr<Procedure> step);

  Command step(const Sample& sample) override;
  Status status() const override;
  void stop(const Saying& reason) override;

 private:
  bool there() const { return way_.state() == State::finished; }

  TravelTo way_;
  std::shared_ptr<Procedure> step_;
};

/// The highest velocity of such a step: as far as it goes and coasts, it stays between the margins.
double highestStep_m_per_s(const Commission& axis, const VelocityStepOptions& options);
/// The longest step in position: so long that it stays between the margins though it overshoots by half.
double longestStep_m(const Commission& axis);

}  // namespace breakaway
