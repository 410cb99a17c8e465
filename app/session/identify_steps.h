// The steps in which a motor is identified, as the bench job makes them: what each will move, how far it is, and what
// came of it.
#pragma once

#include <QString>
#include <vector>

#include "commission/known.h"
#include "session/run.h"

namespace breakaway {

/// A quantity that a step measured.
struct Measured {
  QString name;
  Estimate value;
  double scale = 1.0;  ///< shown = scale · SI
  QString unit;
};

struct IdentifyStep {
  enum class State { open, running, passed, failed };
  Known fact = Known::sensorZero;  ///< that it leaves
  QString title;
  QString moves;  ///< what it will do with the motor, and how long
  State state = State::open;
  std::vector<Measured> results;
  QString trouble;  ///< why it failed
};

/// In the order in which they are made. `run`: what runs or ran last.
std::vector<IdentifyStep> identifySteps(const Commission& known, const RunSnapshot& run);

}  // namespace breakaway
