#include <QTest>
#include <cmath>
#include <utility>

#include "base/distributions.h"

using namespace breakaway;

/// Against published tables (M. Abramowitz, I. A. Stegun, 'Handbook of Mathematical Functions', tables 26.8 and 26.10)
/// and what can be written down.
class TestDistributions : public QObject {
  Q_OBJECT
 private slots:
  void student_isExactFromOneDegreeOn();
  void deviations_areTheNormalsBothWays();
  void bound_isClopperAndPearsons();
  void chiSquare_isExactInItsTail();
};

static bool near(double value, double wanted, double part) {
  return std::abs(value - wanted) <= part * wanted;
}

void TestDistributions::student_isExactFromOneDegreeOn() {
  for (const auto& [freedom, wanted] : {std::pair{1.0, 12.7062047},
                                        {2.0, 4.30265273},
                                        {3.0, 3.18244631},
                                        {5.0, 2.57058184},
                                        {10.0, 2.22813885},
                                        {30.0, 2.04227246},
                                        {1e9, 1.95996399}}) {
    QVERIFY2(near(student95(freedom), wanted, 1e-8), qPrintable(QString::number(student95(freedom), 'g', 12)));
  }
  QCOMPARE(student95(0.0), student95(1.0));
}

void TestDistributions::deviations_areTheNormalsBothWays() {
  QVERIFY(near(deviationsOf(0.05), 1.95996398, 1e-8));
  QVERIFY(near(deviationsOf(0.0027), 2.99997699, 1e-6));
  QVERIFY(near(deviationsOf(1e-6), 4.89163848, 1e-8));
}

void TestDistributions::bound_isClopperAndPearsons() {
  QVERIFY(near(upperBound95(0, 300), 1.0 - std::pow(0.05, 1.0 / 300.0), 1e-9));
  QVERIFY(near(upperBound95(1, 20), 0.21611, 1e-4));
  QVERIFY(near(upperBound95(5, 10), 0.77756, 1e-4));
  QCOMPARE(upperBound95(20, 20), 1.0);
  QCOMPARE(upperBound95(0, 0), 1.0);
}

void TestDistributions::chiSquare_isExactInItsTail() {
  QVERIFY(near(chiSquareTail(3.841458821, 1.0), 0.05, 1e-8));
  QVERIFY(near(chiSquareTail(18.30703805, 10.0), 0.05, 1e-8));
  QVERIFY(near(chiSquareTail(29.58829845, 10.0), 0.001, 1e-8));
  QVERIFY(near(chiSquareTail(2.0, 2.0), std::exp(-1.0), 1e-14));
  QCOMPARE(chiSquareTail(0.0, 4.0), 1.0);
}

QTEST_APPLESS_MAIN(TestDistributions)
#include "tst_distributions.moc"
