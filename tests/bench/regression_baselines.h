// Two baselines that answer with names only, over the same columns: what regression alone would say.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnose/fit/preparation.h"
#include "diagnose/model/effect.h"

namespace breakaway::test {

/// The linear torque regressors of a recording: drive torque = J a + B ω + F s + amplitudes · shapes, filtered as the
/// inverse method does. Columns have unit length; the first three are the base model's. Effects without a term along
/// the motion, and those whose term hangs on hidden state, have no columns.
struct TorqueColumns {
  Eigen::MatrixXd gram;   ///< columns × columns
  Eigen::VectorXd right;  ///< columns · response
  double squares = 0.0;   ///< of the response, Nm² or N²
  Eigen::Index rows = 0;
  struct Group {
    const Effect* effect = nullptr;
    std::vector<Eigen::Index> columns;  ///< of one shape
  };
  std::vector<Group> groups;
  std::vector<Eigen::Index> base;
};

TorqueColumns torqueColumns(const Preparation& prepared);

/// Stepwise least squares, forwards and backwards, with the Bayesian information criterion (G. Schwarz, Annals of
/// Statistics 6(2), 1978): names in order of entry.
std::vector<std::string> stepwiseNames(const TorqueColumns& columns);

/// Sequentially thresholded least squares, SINDy's solver (S. Brunton, J. Proctor, N. Kutz, PNAS 113(15), 2016), with a
/// little ridge, its threshold chosen by the information criterion (N. Mangan et al., Proc. R. Soc. A 473, 2017): names
/// by the size of their coefficients.
std::vector<std::string> thresholdedNames(const TorqueColumns& columns);

}  // namespace breakaway::test
