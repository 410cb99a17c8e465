// From a measured friction map to what the board's controller takes off the shaft.
#pragma once

#include "experiment/drive.h"
#include "friction/friction_map.h"

namespace breakaway {

/// Which part of the friction is compensated.
enum class CompensatedFriction {
  none,
  coulomb,            ///< F of each way, the mean around the rotor
  coulombAndViscous,  ///< F + B·ω, means around the rotor
  map                 ///< Coulomb and viscous friction and position torque at each angle
};

/// The map's friction as the board takes it; the index as the encoder counts it, from homing. A map with more than
/// `mostBins` bins is averaged over neighbours. A linear axis' table begins where its map does.
FrictionCompensation compensationOf(const FrictionMap& map, CompensatedFriction part, double indexAngle_rad,
                                    size_t mostBins = 256);

}  // namespace breakaway
