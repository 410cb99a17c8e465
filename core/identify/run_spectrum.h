// The torque of a run at constant speed, by harmonic order of the rotor's angle.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "friction/measurements.h"
#include "identify/velocity_friction.h"

namespace breakaway {

/// τ(θ) = Re Σ τ_k·e^{jkθ}, in the way's direction.
struct RunSpectrum {
  double speed_rad_per_s = 0.0;
  std::vector<std::complex<double>> torque_Nm;
  std::vector<std::complex<double>> ripple_rad_per_s;         ///< of the speed, from order 1 on
  std::vector<std::complex<double>> acceleration_rad_per_s2;  ///< that the inertia's share was taken off by
  std::vector<double> variance_Nm2;  ///< of real and imaginary part each; of the mean for order 0; infinite: not seen
};

/// Whether the torque of this order was seen.
bool shows(const RunSpectrum& run, size_t order);

/// Kt·i_k − J·(½ω²)'_k from the bin means of current and speed. The variances are the scatter between the run's blocks
/// of whole turns, averaged over neighbouring orders, and at least what the sensor's noise leaves. `parts`: at one
/// speed, each counts by its turns; the blocks of all of them scatter around their common mean.
RunSpectrum spectrumOf(std::span<const VelocityRun> parts, const VelocityFrictionOptions& options);

/// The runs at each speed: what was broken off, and what went on with it.
std::vector<std::vector<VelocityRun>> bySpeed(const std::vector<VelocityRun>& runs);

/// Mean over the turn of the bin means of `sum`; an empty bin takes the mean of its filled neighbours.
double meanAround(const std::vector<AngleBinSums>& bins, double AngleBinSums::*sum);

/// Harmonic of values at the centres of equal bins around the turn, each a mean over its bin.
std::complex<double> harmonicOf(const std::vector<double>& binMeans, size_t order);

}  // namespace breakaway
