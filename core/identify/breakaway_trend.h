// The curve around the rotor that breakaways follow, and how well it is known where none was measured.
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

#include "friction/measurements.h"

namespace breakaway {

/// By harmonics, each as large as the breakaways say that it is: every order's size is learnt with the curve, by
/// expectation and maximisation (M. E. Tipping, "Sparse Bayesian Learning and the Relevance Vector Machine", J. Mach.
/// Learn. Res. 1, 2001). So a stretch of the turn without breakaways is bridged by the waves that show elsewhere, and
/// what those leave open there is in its error; least squares would swing in it as they like.
class BreakawayTrend {
 public:
  /// Of all turns of the way; as many orders as an eighth of the breakaways, 30 at most, and of finer ones those few
  /// that stand out of what is left: a stepper's steps, a gear's teeth, a gimbal motor's slots.
  BreakawayTrend(const std::vector<BreakawayEvent>& events, Way way);

  double torqueAt_Nm(double angle_rad) const { return rowAt(angle_rad).dot(x_); }
  double slopeAt_Nm_per_rad(double angle_rad) const;
  /// Standard error of the curve; what single breakaways scatter around it isn't in it.
  double errorAt_Nm(double angle_rad) const;
  /// Mean square of the waves of more than `order` periods a turn, as far as they stand out of the breakaways' scatter:
  /// what bins that end there don't show, for position torque acts on what moves as on what stands.
  double finerThan_Nm2(size_t order) const;

 private:
  struct FineWave {
    size_t order = 0;
    double square_Nm2 = 0.0;  ///< mean, that it takes off
  };
  void fit();
  FineWave finest(size_t first, size_t last, double gain) const;
  Eigen::VectorXd rowAt(double angle_rad) const;
  std::vector<BreakawayEvent> events_;
  std::vector<double> orders_;
  Eigen::VectorXd x_;  ///< mean, then cosine and sine of each order
  Eigen::MatrixXd covariance_;
};

}  // namespace breakaway
