// All steps of the bench job. Each stands in a file of its own in steps/, with what it needs and leaves.
#pragma once

#include <memory>
#include <vector>

#include "commission/step.h"

namespace breakaway {

using StepPtr = std::unique_ptr<Step>;

StepPtr currentZeroStep();
StepPtr wiringStep();
StepPtr windingStep();
StepPtr spinStep();         ///< of a rotor: what strokes are to an axis
StepPtr travelEndsStep();   ///< of a linear axis
StepPtr travelMotorStep();  ///< likewise: strokes by voltage
StepPtr carefulGainsStep(Axis axis);
StepPtr reversalStep();
StepPtr bridgeStep();
StepPtr straightenStep();
StepPtr currentScaleStep();
StepPtr homingStep(const Identity& board);
StepPtr travelHomingStep();
StepPtr velocitySweepStep();
StepPtr travelStrokesStep();
StepPtr breakawaySweepStep(Axis axis);
StepPtr mapStep();
StepPtr travelMapStep();
StepPtr slowTurnsStep();
StepPtr tuneForUseStep();
StepPtr compensatedRunStep();

/// The steps of a board's axis in the order in which they are made.
std::vector<StepPtr> stepsOf(const Identity& board);

/// Those that have to be made for what is wanted, in order: every step that leaves something wanted which isn't known,
/// and likewise for what it needs.
std::vector<StepPtr> plan(const Identity& board, const Facts& known, const Facts& wanted);

}  // namespace breakaway
