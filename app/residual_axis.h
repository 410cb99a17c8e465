// The axes over which a residual can be looked at, one value per row of the recording.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "diagnose/simulation.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

/// Names as in Place::axis: time, angle, velocity, acceleration, current, reversal.
QStringList residualAxes();

/// "velocity (rad/s)"; on a linear axis with its own units.
QString axisLabel(const QString& axis, bool linear);

/// time_s and the drive input as recorded; position as measured; velocity, acceleration and travel since the last reversal from
/// the simulation, which has no noise. Empty for an axis that is not in residualAxes().
std::vector<double> residualAxis(const QString& axis, const Bench& bench, const Recording& recording, const Trace& trace);

}  // namespace breakaway
