// Linear regression on the inverse model: columns along the smoothed motion of tracks.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "base/result.h"
#include "diagnose/fit/inverse_rows.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// A value at a row.
using Column = std::function<double(const InverseRows&, size_t)>;

double accelerationColumn(const InverseRows& rows, size_t k);
double velocityColumn(const InverseRows& rows, size_t k);
double directionColumn(const InverseRows& rows, size_t k);
/// What a model's declared load asks for: its weight, and its inertia times the acceleration, Nm.
Column knownLoadColumn(const Model& model);

struct Regression {
  Eigen::VectorXd value;       ///< one per column
  Eigen::MatrixXd covariance;  ///< clustered by second
  double fewStretches = 1.0;   ///< by which standard errors are larger, as clusters are few; infinite: unknown
  double relativeError = 0.0;  ///< ‖residual‖/‖response‖
  size_t rows = 0;
};

/// Least squares of `response` on `columns` over all tracks, both sides filtered alike at 50 Hz, a twentieth of the
/// sampling rate at most; with `creeping` rows that move hardly faster than the velocity's noise count, too. Errors:
/// too little motion, columns that can't be told apart.
Result<Regression> regress(const std::vector<Track>& tracks, const std::vector<Column>& columns, const Column& response,
                           bool creeping);

}  // namespace breakaway
