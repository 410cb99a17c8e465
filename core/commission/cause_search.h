// Whether a wire is the cause of what ended a step: a jump, a lost index and a speed that runs away are symptoms, which
// a fault shows by the chance of where the motion was.
#pragma once

#include <memory>

#include "commission/step.h"
#include "experiment/wiring_check.h"

namespace breakaway {

/// How a step ended early.
struct EarlyEnd {
  Procedure::State state = Procedure::State::failed;
  Trip trip = Trip::none;  ///< of the board's watch
  Error failure;
};

/// Whether small pulses may tell more: not after a stop by a person, link, supply or heat, nor where beliefs
/// contradict, and only once the wiring was found in order.
bool leavesCauseOpen(const EarlyEnd& end, const Commission& known);

/// The wiring check once more, as soon as the shaft stands, held against the one at the beginning.
class CauseSearch {
 public:
  CauseSearch(EarlyEnd end, const OnBench& on);
  StepRun run() const;
  /// The step's failure, with the cause before the symptom where the check names one. `trip` ended the check, if any.
  Error conclude(Trip trip, Commission& known) const;
  const EarlyEnd& end() const { return end_; }

 private:
  EarlyEnd end_;
  std::shared_ptr<WiringCheck> check_;
};

}  // namespace breakaway
