// Torque that wanders at random, as a rig's friction does, and how it shows in rows of twice integrated torque.
#pragma once

#include <Eigen/Core>

namespace breakaway {

/// An Ornstein-Uhlenbeck process beside white noise of each row.
struct TorqueNoise {
  double ratio = 0.0;   ///< rms torque, integrated twice over one second, in units of one reading's noise; 0: none
  double time_s = 0.1;  ///< correlation time
  double rms = 0.0;     ///< Nm or N

  /// Whether it is no more than any rig's, beside so much Coulomb friction: small, and smaller where it changes slowly,
  /// which moves the axis further and is more likely to have a cause of its own.
  bool usual(double coulomb) const;
};

/// Makes rows of one stretch, `spacing_s` apart, independent and of equal variance: the innovations of a Kalman filter
/// for torque, momentum and its integral, each over its standard deviation (B. D. O. Anderson and J. B. Moore, 'Optimal
/// filtering', 1979, chapter 9). Where the stretch begins, momentum and its integral are taken as known: free lines are
/// for the caller. Returns the sum of the logarithms of the standard deviations.
double whiten(const TorqueNoise& noise, double spacing_s, Eigen::Ref<Eigen::MatrixXd> rows);

}  // namespace breakaway
