// Noise in the record of a drive: whether it acted, or is only what was read.
#pragma once

#include "diagnose/simulate/track.h"

namespace breakaway {

/// Standard deviation of a reading of the drive's voltage, V; 0 unless the motion shows that the noise in the record
/// didn't act: what moved the axis foretells the change of its speed from row to row better than the same record made
/// smooth.
double voltageReadingNoise(const Track& track);

}  // namespace breakaway
