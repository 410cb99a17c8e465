// The line over the speeds that each harmonic of a way's torque follows: Coulomb friction and its slope.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <limits>
#include <vector>

#include "identify/harmonic_evidence.h"
#include "identify/run_spectrum.h"

namespace breakaway {

/// What a way's runs are fitted with.
struct WayRuns {
  std::vector<RunSpectrum> spectra;  ///< by growing speed
  std::vector<double> fall;          ///< per run, exp(−(ω/ω_s)²); zero where friction doesn't fall any more
  std::vector<std::complex<double>> static_Nm;  ///< harmonics of the breakaway map; empty: not known
  std::vector<double> widened_Nm2;              ///< per run, on top of order 0's variance
  /// Harmonics of the position torque in this way's direction as breakaways show it, and their variance in each part;
  /// empty: not known.
  std::vector<std::complex<double>> position_Nm;
  std::vector<double> positionVariance_Nm2;
};

/// One harmonic's Coulomb and viscous value; variances of the real and of the imaginary part each, infinite where no
/// run shows them.
struct FrictionLine {
  std::complex<double> coulomb = 0.0, viscous = 0.0;
  double coulombVariance = std::numeric_limits<double>::infinity(),
         viscousVariance = std::numeric_limits<double>::infinity(), covariance = 0.0;
  double lean = 0.0;     ///< by how much of a viscous value that isn't fitted the Coulomb value is off
  double squares = 0.0;  ///< of the residuals, each over its variance
  /// By how much these grow per variance that the runs have in truth beyond their own, in both parts.
  double squaresPerExtra = 0.0;

  /// What the runs say of the Coulomb value once the viscous one is known otherwise.
  HarmonicEvidence coulombGiven(const WeighedHarmonic& known) const;
};

/// A run as the line through an order meets it.
struct LineRow {
  Eigen::Vector2d regressors = Eigen::Vector2d::Zero();  ///< of C and of B
  std::complex<double> torque_Nm;
  double speed_rad_per_s = 0.0, weight = 0.0;
};

/// The runs that show this order. Where friction still falls, S·g is taken off and the row is (1 − g, ω); the fall's
/// doubt then counts as noise, measured by the Coulomb value `guess`.
std::vector<LineRow> lineRows(const WayRuns& runs, size_t order, std::complex<double> guess);

/// C + B·|ω| through the runs' harmonics of this order, weighted by their variances; without slope C alone. Where
/// friction still falls with speed, S·g is taken off and the row is (1 − g, ω), a third of that fall counting as noise.
FrictionLine fitOrder(const WayRuns& runs, size_t order, bool withSlope);

/// Sets the runs' fall for friction that falls over this speed; 0: it doesn't.
void setFall(WayRuns& runs, double speed_rad_per_s);

/// The speed over which friction falls, the same both ways, by the means of all runs; 0 when they show no fall.
double findFall(std::array<WayRuns, 2> ways);

/// Widens the means' variances to what the residuals over the speeds say: runs differ by more than their own scatter.
void widen(WayRuns& runs);

/// The same of the harmonics, whose variances hold it then: what a run's blocks have in common (a converter's steps, an
/// inertia that is off) isn't in their scatter, but differs from speed to speed. Told by each order's residuals, or
/// those of its neighbours, where they are beyond chance. Orders above `highestSlope` have no slope.
void widenHarmonics(WayRuns& runs, size_t highestSlope);

/// Leaves out the slowest speeds while they lie off the line through the faster ones; returns how many.
size_t leaveOutStribeck(WayRuns& runs);

}  // namespace breakaway
