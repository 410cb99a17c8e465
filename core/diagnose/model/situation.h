// What a term of the dynamics may depend on at one instant, and what it adds there.
#pragma once

#include <span>

#include "motor/bench.h"

namespace breakaway {

/// What a term may depend on, at one instant. On a linear axis read m for rad and N for Nm.
struct Situation {
  Axis axis = Axis::rotary;
  double time_s = 0.0;             ///< since the recording's first row
  double position = 0.0;           ///< rad
  double velocity = 0.0;           ///< rad/s
  double acceleration = 0.0;       ///< rad/s²
  double driveTorque = 0.0;        ///< the model's motor torque, never a measured one, Nm
  double knownLoad = 0.0;          ///< torque of the load that the bench declares, Nm; sign as in Term
  double direction = 0.0;          ///< ±1: of motion, or of the motion that is about to start
  double current = 0.0;            ///< the model's motor current, A; 0 where torque drives
  double input = 0.0;              ///< the drive input: V, A or Nm
  double supply_V = 0.0;           ///< of the bridge; 0: not known
  double resistance_ohm = 0.0;     ///< of the winding without the effect; 0: not known
  double rest_s = 0.0;             ///< how long the standstill lasted that ended last, or lasts by now
  double travel = 0.0;             ///< since the last reversal, rad
  double span = 0.0;               ///< how far it moves while this stands for all of a step, rad
  std::span<const double> memory;  ///< the effect's own hidden state, as remember() left it
};

/// What an effect adds to the base physics at one instant.
struct Term {
  double load_Nm = 0.0;      ///< opposes growing position whatever the direction: drive = J a + … + load
  double friction_Nm = 0.0;  ///< opposes motion in `direction`; it also holds at standstill
  double voltage_V = 0.0;    ///< lost before the windings; only where voltage or duty drives
};

}  // namespace breakaway
