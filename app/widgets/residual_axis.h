// The axes over which a residual can be looked at, one value per row of the recording.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "diagnose/model/model.h"
#include "diagnose/simulate/simulation.h"
#include "recording/recording.h"

namespace breakaway {

/// Names as in Place::axis: time, angle, velocity, acceleration, current, reversal.
QStringList residualAxes();

/// An axis as people read it.
struct ShownAxis {
  QString name, unit;
  double scale = 1.0;  ///< shown = scale · SI

  /// "motor torque (mNm)".
  QString label() const;
};

/// Of residualAxes(), and of temperature; any other keeps its name, without a unit.
ShownAxis shownAxis(const QString& axis, bool linear);

/// time_s as recorded; position as measured, taken into one turn where a rotor makes more than one; the motor's torque
/// or force from the drive; velocity, acceleration and travel since the last reversal from the simulation, which has no
/// noise. Empty for an axis that is not in residualAxes().
std::vector<double> residualAxis(const QString& axis, const Model& model, const Recording& recording,
                                 const Trace& trace);

}  // namespace breakaway
