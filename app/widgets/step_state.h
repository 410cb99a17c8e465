// How far a step of the job is, for its row in the rail and its card.
#pragma once

#include <QString>

namespace breakaway {

enum class StepMark { open, done, running, paused, trouble };

struct StepState {
  StepMark mark = StepMark::open;
  QString words;  ///< what came of it, how far it is, or why not yet
  bool operator==(const StepState&) const = default;
};

}  // namespace breakaway
