#include "commission/steps.h"

#include <algorithm>

namespace breakaway {

namespace {

std::vector<StepPtr> stepsOfRotor(const Identity& board) {
  std::vector<StepPtr> steps;
  steps.push_back(currentZeroStep());
  steps.push_back(wiringStep());
  steps.push_back(windingStep());
  steps.push_back(spinStep());
  steps.push_back(carefulGainsStep(Axis::rotary));
  steps.push_back(reversalStep());
  steps.push_back(bridgeStep());
  steps.push_back(straightenStep());
  steps.push_back(currentScaleStep());
  steps.push_back(homingStep(board));
  steps.push_back(velocitySweepStep());
  steps.push_back(breakawaySweepStep(Axis::rotary));
  steps.push_back(mapStep());
  steps.push_back(slowTurnsStep());
  steps.push_back(tuneForUseStep());
  steps.push_back(compensatedRunStep());
  return steps;
}

std::vector<StepPtr> stepsOfAxis() {
  std::vector<StepPtr> steps;
  steps.push_back(currentZeroStep());
  steps.push_back(wiringStep());
  steps.push_back(travelEndsStep());
  steps.push_back(windingStep());
  steps.push_back(travelMotorStep());
  steps.push_back(currentScaleStep());
  steps.push_back(straightenStep());
  steps.push_back(carefulGainsStep(Axis::linear));
  steps.push_back(travelHomingStep());
  steps.push_back(travelStrokesStep());
  steps.push_back(breakawaySweepStep(Axis::linear));
  steps.push_back(travelMapStep());
  steps.push_back(tuneForUseStep());
  steps.push_back(compensatedRunStep());
  return steps;
}

}  // namespace

std::vector<StepPtr> stepsOf(const Identity& board) {
  return board.axis == Axis::linear ? stepsOfAxis() : stepsOfRotor(board);
}

std::vector<StepPtr> plan(const Identity& board, const Facts& known, const Facts& wanted) {
  std::vector<StepPtr> steps = stepsOf(board), planned;
  Facts lacking = wanted;
  lacking.remove(known);
  // Backwards: what a step needs is left by those before it.
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    if (!lacking.hasAny((*step)->leaves())) continue;
    lacking.add((*step)->needs());
    lacking.remove(known);
    planned.push_back(std::move(*step));
  }
  std::reverse(planned.begin(), planned.end());
  return planned;
}

}  // namespace breakaway
