#include <QTest>
#include <cmath>

#include "dense/dense_solve.h"

using namespace breakaway;

/// Each solution by what it must do, on systems that have an answer, too many equations, or columns that hang together.
class TestDenseSolve : public QObject {
  Q_OBJECT
 private slots:
  void leastSquares_leavesNothingAlongTheColumns();
  void columnsThatHangTogether_getTheShortestAnswer();
  void pseudoInverse_ofAnInvertibleIsItsInverse();
  void symmetricSystem_isSolved();
  void bases_areOrthonormalAndSpanTheColumns();
  void lastColumn_leavesWhatAFitLeaves();
};

static Eigen::MatrixXd tall() {
  Eigen::MatrixXd A(6, 3);
  A << 1, 0, 2, 1, 1, -1, 1, 2, 0.5, 1, 3, 0, 1, 4, 3, 1, 5, -2;
  return A;
}

static Eigen::VectorXd seen() {
  Eigen::VectorXd y(6);
  y << 1, -2, 0.5, 3, 4, 7;
  return y;
}

static bool near(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a - b).norm() < 1e-12 * std::max(1.0, b.norm());
}

void TestDenseSolve::leastSquares_leavesNothingAlongTheColumns() {
  const Eigen::MatrixXd A = tall();
  const Eigen::VectorXd left = leftByLeastSquares(A, seen());
  QVERIFY(left.norm() > 0.1);
  QVERIFY(near(A.transpose() * left, Eigen::VectorXd::Zero(3)));
  QVERIFY(near(seen() - A * leastSquares(A, seen()), left));
  const SpannedFit fit = spannedFit(A, seen());
  QVERIFY(near(fit.x, leastSquares(A, seen())));
  QVERIFY(near(fit.basis, basisOf(A)));
}

void TestDenseSolve::columnsThatHangTogether_getTheShortestAnswer() {
  Eigen::MatrixXd A(6, 2);
  A << tall().col(1), tall().col(1);
  const Eigen::VectorXd x = leastNorm(A, seen());
  QVERIFY(std::abs(x[0] - x[1]) < 1e-12);
  QVERIFY(near(pseudoInverse(A) * seen(), x));
  Eigen::MatrixXd both(6, 2);
  both << seen(), 2.0 * seen();
  QVERIFY(near(leastNorms(A, both).col(1), 2.0 * x));
  QCOMPARE(basisOfRank(A).cols(), Eigen::Index(1));
}

void TestDenseSolve::pseudoInverse_ofAnInvertibleIsItsInverse() {
  const Eigen::MatrixXd normal = tall().transpose() * tall();
  QVERIFY(near(pseudoInverse(normal), inverseOf(normal)));
  QVERIFY(near(inverseOf(normal) * normal, Eigen::MatrixXd::Identity(3, 3)));
}

void TestDenseSolve::symmetricSystem_isSolved() {
  const Eigen::MatrixXd normal = tall().transpose() * tall();
  const Eigen::VectorXd right = tall().transpose() * seen();
  QVERIFY(near(solveSymmetric(normal, right), leastSquares(tall(), seen())));
  QVERIFY(near(inverseOfSymmetric(normal), inverseOf(normal)));
}

void TestDenseSolve::bases_areOrthonormalAndSpanTheColumns() {
  const Eigen::MatrixXd A = tall();
  for (const Eigen::MatrixXd& basis : {basisOf(A), basisOfRank(A)}) {
    QVERIFY(near(basis.transpose() * basis, Eigen::MatrixXd::Identity(3, 3)));
    QVERIFY(near(basis * (basis.transpose() * A), A));
  }
}

void TestDenseSolve::lastColumn_leavesWhatAFitLeaves() {
  Eigen::MatrixXd all(6, 4);
  all << tall(), seen();
  QVERIFY(std::abs(std::abs(leftOfLastColumn(all)) - leftByLeastSquares(tall(), seen()).norm()) < 1e-12);
}

QTEST_APPLESS_MAIN(TestDenseSolve)
#include "tst_dense_solve.moc"
