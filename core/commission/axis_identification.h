// The motor of a linear axis: how its tests are laid out, and what they tell.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "experiment/drive.h"
#include "experiment/travel_search.h"
#include "experiment/travel_strokes.h"
#include "experiment/winding_test.h"
#include "identify/motor_identification.h"
#include "identify/winding_fit.h"

namespace breakaway {

/// Both ends, tried with a current limit that begins at a fiftieth of the controller's.
TravelSearchOptions searchOn(const Identity& board, const ControllerSettings& settings);
WindingTestOptions windingTestOn(const Identity& board);
/// Strokes by three voltages that friction, supply and name plate allow over this travel.
TravelStrokesOptions strokesOn(const Identity& board, const ControllerSettings& settings, const Travel& travel,
                               const WindingFit& winding);

struct AxisTests {
  WindingFit winding;
  std::vector<WindingPoint> standing;  ///< of the winding test
  std::vector<SpinBlock> strokes;
  double block_s = 0.0;  ///< of the strokes
  double supply_V = 0.0;
  std::optional<double> trustedForceConstant_N_per_A;
};

/// Motor, bridge and mass from the tests of one axis, with the current as the sensor shows it; a bridge that can't be
/// told from the motor leaves a remark. Errors: those of identifyMotor() and massByStrokes().
Result<IdentifiedMotor> identifyAxis(const AxisTests& tests, std::vector<std::string>& remarks);

/// setCurrentScale() in a linear axis' words.
void setAxisScale(IdentifiedMotor& motor, const CurrentScaleOptions& options);

}  // namespace breakaway
