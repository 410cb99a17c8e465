#include "dense/dense_solve.h"

#include <Eigen/Dense>

namespace breakaway {

Eigen::VectorXd leastSquares(const MatrixView& A, const VectorView& y) {
  return A.colPivHouseholderQr().solve(y);
}

Eigen::VectorXd leftByLeastSquares(const MatrixView& A, const VectorView& y) {
  return y - A * leastSquares(A, y);
}

Eigen::VectorXd leastNorm(const MatrixView& A, const VectorView& y) {
  return leastNorms(A, y);
}

Eigen::MatrixXd leastNorms(const MatrixView& A, const MatrixView& Y) {
  return A.completeOrthogonalDecomposition().solve(Y);
}

Eigen::MatrixXd pseudoInverse(const MatrixView& A) {
  return A.completeOrthogonalDecomposition().pseudoInverse();
}

static Eigen::MatrixXd basisFrom(const Eigen::HouseholderQR<Eigen::MatrixXd>& qr) {
  return qr.householderQ() * Eigen::MatrixXd::Identity(qr.rows(), qr.cols());
}

Eigen::MatrixXd basisOf(const MatrixView& A) {
  return basisFrom(Eigen::HouseholderQR<Eigen::MatrixXd>(A));
}

Eigen::MatrixXd basisOfRank(const MatrixView& A) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  return qr.householderQ() * Eigen::MatrixXd::Identity(A.rows(), qr.rank());
}

SpannedFit spannedFit(const MatrixView& A, const VectorView& y) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(A);
  return {basisFrom(qr), qr.solve(y)};
}

double leftOfLastColumn(const MatrixView& A) {
  const Eigen::Index last = A.cols() - 1;
  return Eigen::HouseholderQR<Eigen::MatrixXd>(A).matrixQR()(last, last);
}

Eigen::MatrixXd inverseOf(const MatrixView& A) {
  return A.inverse();
}

Eigen::VectorXd solveSymmetric(const MatrixView& A, const VectorView& y) {
  return A.ldlt().solve(y);
}

Eigen::MatrixXd inverseOfSymmetric(const MatrixView& A) {
  return A.ldlt().solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
}

}  // namespace breakaway
