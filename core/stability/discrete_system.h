// A linear system in sampled time: its poles, its answer to a frequency, and the noise that it lets through.
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// x[k+1] = A·x[k] + B·u[k], y[k] = C·x[k] + D·u[k]; A is n×n, B n×m, C p×n, D p×m, one step every `tick_s`.
struct DiscreteSystem {
  Eigen::MatrixXd A, B, C, D;
  double tick_s = 0.0;
};

/// The eigenvalues of A, largest magnitude first.
std::vector<std::complex<double>> poles(const DiscreteSystem& system);

/// The largest magnitude of an eigenvalue of A; the system is asymptotically stable below 1.
double spectralRadius(const DiscreteSystem& system);

/// The smallest damping ratio ζ = −Re s/|s| with s = ln(z)/T over the poles z that last longer than a tick (|z| >
/// 1/e); 1 when all of them are real and positive, negative when one grows. Source: Franklin, Powell, Workman, "Digital
/// Control of Dynamic Systems", 3rd ed., section 4.3 (ζ lines in the z plane).
double damping(const std::vector<std::complex<double>>& poles);

/// H(e^{jωT}) = C·(zI − A)⁻¹·B + D from input `from` to output `to`, frequency by frequency. A is brought to Hessenberg
/// form once, so that each frequency is solved in n² steps. Source: Laub, "Efficient multivariable frequency response
/// computations", IEEE Trans. Automatic Control 26(2), 1981.
class FrequencyResponse {
 public:
  FrequencyResponse(const DiscreteSystem& system, Eigen::Index from, Eigen::Index to);
  /// In rad/s, up to π/T.
  std::complex<double> operator()(double frequency_rad_per_s);

 private:
  double tick_s_, direct_;
  Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> start_, pencil_;
  Eigen::VectorXcd b_, x_;
  Eigen::RowVectorXcd c_;
};

/// FrequencyResponse at each frequency, in rad/s up to π/T.
std::vector<std::complex<double>> response(const DiscreteSystem& system, Eigen::Index from, Eigen::Index to,
                                           const std::vector<double>& frequencies_rad_per_s);

/// The stationary covariance P of the state driven by white inputs of the given variances (one per input):
/// P = A·P·Aᵀ + B·Q·Bᵀ, summed by doubling (Smith, "Matrix equation XA + BX = C", SIAM J. Appl. Math. 16(1), 1968).
/// Errors: the system is not stable.
Result<Eigen::MatrixXd> stationaryCovariance(const DiscreteSystem& system, const Eigen::VectorXd& variances);

/// The rms of each output, C·P·Cᵀ + D·Q·Dᵀ, under the same inputs: the H2 norm scaled by them.
Result<Eigen::VectorXd> stationaryRms(const DiscreteSystem& system, const Eigen::VectorXd& variances);

}  // namespace breakaway
