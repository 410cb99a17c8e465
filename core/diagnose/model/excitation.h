// What recordings have seen of a rig: the ranges that decide which effects they can show.
#pragma once

#include <algorithm>

#include "motor/bench.h"

namespace breakaway {

/// What the search needs to know of the data to offer shapes: ranges seen in the recordings.
struct Excitation {
  Axis axis = Axis::rotary;
  bool byReference = false;       ///< a servo's own law drives: its limit and delay are the base's
  bool electrical = false;        ///< voltage or duty drives
  bool currentDrive = false;      ///< current drives
  bool driveMeasured = false;     ///< what drives was measured where it acts, not commanded
  double followsWithin_s = 0.0;   ///< what the drive's own loop takes to follow a command, s; 0 where voltage drives
  bool currentSeen = false;       ///< voltage or duty drives, and the current was recorded, too
  bool supplySeen = false;        ///< the bridge's supply is known
  double supply_V = 0.0;          ///< of the bench, or the recorded one at the first row; 0: not known
  bool bothWays = false;          ///< at least 10 % of the motion goes each way
  double step_s = 0.0;            ///< median time from row to row
  double duration_s = 0.0;        ///< of the longest recording
  double lowSpeed = 0.0;          ///< 10 % quantile of |velocity| while moving, rad/s
  double highSpeed = 0.0;         ///< its 95 % quantile
  double lowest = 0.0;            ///< smallest position, rad
  double highest = 0.0;           ///< largest position, rad
  double travel = 0.0;            ///< their difference
  double count = 0.0;             ///< one encoder count, rad
  double peakTorque = 0.0;        ///< of the drive, 99 % quantile while moving, Nm
  double knownLoad = 0.0;         ///< largest torque of the load that the bench declares, Nm; 0: none
  double peakCurrent = 0.0;       ///< the same of the current, A; 0 where torque drives
  double usualCurrent = 0.0;      ///< its root mean square, A
  double peakInput = 0.0;         ///< largest |drive input|: V, A or Nm
  double peakAcceleration = 0.0;  ///< 99 % quantile, rad/s²
  double longestRest_s = 0.0;     ///< standstill
  int starts = 0;                 ///< from standstill
  int reversals = 0;
  double inertia = 0.0;                                                ///< of the base model, kg m²
  double coulomb = 0.0;                                                ///< of the base model, Nm
  double immaterial = 0.01, soundPart = 0.05, immaterialDrive = 5e-4;  ///< of friction, of it and of the drive's peak:
                                                                       ///< as Criteria has them

  /// Any rig's friction may wander by this, Nm.
  double usualWander() const { return soundPart * coulomb; }
  /// A smaller torque matters to nobody, Nm.
  double immaterialTorque() const { return std::max(immaterialDrive * peakTorque, immaterial * coulomb); }
};

}  // namespace breakaway
