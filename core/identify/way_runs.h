// From runs at constant speed to what each way is fitted with.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "base/result.h"
#include "identify/friction_line.h"
#include "identify/harmonic_evidence.h"
#include "identify/velocity_friction.h"

namespace breakaway {

/// How many orders the guess about a Coulomb curve counts for, before the curve itself has said how it varies.
inline constexpr double coulombOrders = 3.0;
/// That guess.
HarmonicPrior coulombPrior(std::complex<double> mean);

/// Both ways' spectra by growing speed, freed of what viscous friction makes of their speed's ripple; with the
/// breakaway map how far friction falls, and what position torque is expected. Errors: a way with fewer than two
/// speeds.
Result<std::array<WayRuns, 2>> wayRunsOf(const std::vector<VelocityRun>& runs, const VelocityFrictionOptions& options);

}  // namespace breakaway
