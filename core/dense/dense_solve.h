// Dense systems of real equations, by Eigen's decompositions. A source that uses one itself takes ten seconds more to
// compile: here each is compiled once. Sources have their own where numbers are complex, where a factor serves several
// right-hand sides, and in the innermost loops.
#pragma once

#include <Eigen/Core>

namespace breakaway {

using MatrixView = Eigen::Ref<const Eigen::MatrixXd>;
using VectorView = Eigen::Ref<const Eigen::VectorXd>;

/// The x with the least |A·x − y|.
Eigen::VectorXd leastSquares(const MatrixView& A, const VectorView& y);
/// y − A·x of that x.
Eigen::VectorXd leftByLeastSquares(const MatrixView& A, const VectorView& y);
/// Of all with the least |A·x − y|, the shortest x: also where columns hang together.
Eigen::VectorXd leastNorm(const MatrixView& A, const VectorView& y);
/// The same for each column of Y.
Eigen::MatrixXd leastNorms(const MatrixView& A, const MatrixView& Y);
Eigen::MatrixXd pseudoInverse(const MatrixView& A);

/// Orthonormal columns that span what A's do, as many as A has.
Eigen::MatrixXd basisOf(const MatrixView& A);
/// The same, as many as A has rank: also where columns hang together.
Eigen::MatrixXd basisOfRank(const MatrixView& A);
/// A tall A that has its full rank: its basis and the x with the least |A·x − y|.
struct SpannedFit {
  Eigen::MatrixXd basis;
  Eigen::VectorXd x;
};
SpannedFit spannedFit(const MatrixView& A, const VectorView& y);
/// The length of what the other columns of A leave of its last one, with a sign that says nothing.
double leftOfLastColumn(const MatrixView& A);

/// Of a square A that has an inverse.
Eigen::MatrixXd inverseOf(const MatrixView& A);
/// x of A·x = y with a symmetric A that isn't negative.
Eigen::VectorXd solveSymmetric(const MatrixView& A, const VectorView& y);
/// The inverse of such an A.
Eigen::MatrixXd inverseOfSymmetric(const MatrixView& A);

}  // namespace breakaway
