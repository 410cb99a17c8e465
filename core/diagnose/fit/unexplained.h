// What a recording shows of the torque and the voltage that a model can't explain, along the recorded motion.
#pragma once

#include <vector>

#include "diagnose/fit/inverse_rows.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// One track on an even grid; all vectors have the same length but `voltage`, which may be empty. On a linear axis read
/// m for rad and N for Nm.
struct Unexplained {
  double step_s = 0.0;
  double inertia = 0.0;              ///< of the motor's side, kg m²
  std::vector<double> time;          ///< s since the first row
  std::vector<double> position;      ///< behind what the encoder shows, rad
  std::vector<double> velocity;      ///< rad/s
  std::vector<double> acceleration;  ///< that the model expects of its drive, rad/s²: free of the encoder's noise
  std::vector<double> drive;         ///< the model's motor torque, Nm
  std::vector<double> current;       ///< the model's, A; 0 where torque drives
  std::vector<double> speedingUp;    ///< mean acceleration along the motion over the last 0.3 s or so, rad/s²
  std::vector<double> travel;        ///< since the last reversal, rad
  std::vector<double> torque;        ///< that the drive gives beyond what the model needs, Nm; 0 where not `usable`
  std::vector<double> voltage;       ///< that the drive loses beyond the model, V; empty: no current was recorded
  std::vector<char> usable, driven;  ///< in motion; windings connected
  std::vector<size_t> row;           ///< the track's row at or before `time`
};

/// Runs the model's terms, with their hidden states, along the motion that the track shows. Precondition: as for
/// Simulator.
Unexplained unexplainedAlong(const Model& model, const Track& track);

/// The torque alone, in every row of the track's even grid: what is no clear motion is for the caller to leave out. For
/// models that change neither what the encoder shows nor what drives.
std::vector<double> torqueAlong(const Model& model, const Track& track, const InverseRows& rows);

}  // namespace breakaway
