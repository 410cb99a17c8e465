// Torque that wanders at random, as a rig's friction does, and how it shows in rows of twice integrated torque.
#pragma once

#include <Eigen/Core>

#include "diagnose/model/criteria.h"

namespace breakaway {

/// An Ornstein-Uhlenbeck process beside white noise of each row.
struct TorqueNoise {
  double ratio = 0.0;   ///< rms torque, integrated twice over one second, in units of one reading's noise; 0: none
  double time_s = 0.1;  ///< correlation time
  double rms = 0.0;     ///< Nm or N
};

/// The rms that a torque that lasts as long as friction's at least would need to move a rotor as far in the long run:
/// what comes and goes faster pushes as far by the root of how long it lasts. Nm or N.
double lastingRms(const TorqueNoise& noise);

/// How much torque may wander on a sound rig, Nm or N: a part of the friction, or of the drive's peak where there
/// is no friction.
double mostWander(double coulomb, double peakTorque, const Criteria& criteria);

/// Makes rows of one stretch, at `times` in s, independent and of equal variance: the innovations of a Kalman filter
/// for torque, momentum and its integral, each over its standard deviation (B. D. O. Anderson and J. B. Moore, 'Optimal
/// filtering', 1979, chapter 9). Where the stretch begins, momentum and its integral are taken as known: free lines are
/// for the caller. `impulses`: variances of momentum that comes in before each row besides, in squared units of one
/// reading's noise per second; empty: none. Returns the sum of the logarithms of the standard deviations.
double whiten(const TorqueNoise& noise, const Eigen::VectorXd& times, Eigen::Ref<Eigen::MatrixXd> rows,
              const Eigen::VectorXd& impulses = {});

}  // namespace breakaway
