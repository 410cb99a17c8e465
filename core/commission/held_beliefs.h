// What bench file and board say of the rig, held against what the bench job measures, each as soon as it is known.
#pragma once

#include "base/result.h"
#include "commission/commission.h"

namespace breakaway {

// All of them: a contradiction (motor/beliefs.h) is an error at contradictionPlace with both values, their ratio and
// what it suggests; where the job goes on anyway, it is a remark, and stands in Commission::contradictions.

inline constexpr const char* contradictionPlace = "contradiction";

/// Before anything is energised: the bench's counts and supply against the board's.
Result<void> holdDeclarations(const CommissionOptions& options, Commission& known);
/// After the wiring check, by what its few pulses tell: the supply's reading, and the motor as the bench or an
/// interrupted job knew it.
Result<void> holdWiring(const CommissionOptions& options, Commission& known);
/// At the end, `now` against the wiring check at the beginning.
Result<void> holdWiringStill(const WiringFit& now, const CommissionOptions& options, Commission& known);
/// The same of a job that ended early, whatever goes on in spite of it: what contradicts, empty where nothing does.
Message wiringChange(const WiringFit& now, Commission& known);
/// After the first test that moves the motor, whose `motor` carries the current as the sensor shows it.
Result<void> holdMotor(const IdentifiedMotor& motor, const CommissionOptions& options, Commission& known);

/// Before a map becomes one: what doesn't repeat or contradicts itself isn't (identify/map_soundness.h).
Result<void> holdMap(const FrictionMap& map, const CommissionOptions& options, Commission& known);

}  // namespace breakaway
