#include <QTest>
#include <cmath>
#include <limits>

#include "base/random.h"
#include "identify/harmonic_evidence.h"

using namespace breakaway;

class TestHarmonicEvidence : public QObject {
  Q_OBJECT
 private slots:
  void aClearHarmonic_isTakenWhole();
  void noise_isTakenForNothing();
  void anUnseenOrder_keepsTheExpectationAndItsDoubt();
  void thePriorLearnsHowTheCurveVaries();
  void standardErrorsHoldTheTruth();
};

namespace {

constexpr double unseen = std::numeric_limits<double>::infinity();
constexpr HarmonicPrior tenPercent{0.25, 0.005};

HarmonicPrior typical() {
  return {0.25, 0.5 * 0.08 * 0.08};
}

}  // namespace

void TestHarmonicEvidence::aClearHarmonic_isTakenWhole() {
  const auto one = weighed({{0.1, -0.05}, 1e-6}, tenPercent);
  QVERIFY(std::abs(one.value - std::complex<double>(0.1, -0.05)) < 1e-4);
  QVERIFY(std::abs(one.variance / 1e-6 - 1.0) < 0.01);
}

void TestHarmonicEvidence::noise_isTakenForNothing() {
  const auto one = weighed({{0.001, 0.0005}, 1e-6}, tenPercent);
  QVERIFY(std::abs(one.value) < 1e-5);
  QVERIFY(one.variance < 1e-8);
}

void TestHarmonicEvidence::anUnseenOrder_keepsTheExpectationAndItsDoubt() {
  const auto one = weighed({0.0, unseen, {0.2, 0.1}, 1e-4}, tenPercent);
  QCOMPARE(one.value, std::complex<double>(0.2, 0.1));
  QVERIFY(std::abs(one.variance - (1e-4 + 0.25 * 0.005)) < 1e-12);
}

void TestHarmonicEvidence::thePriorLearnsHowTheCurveVaries() {
  std::vector<HarmonicEvidence> orders(12, HarmonicEvidence{0.0, 1e-8});
  for (size_t k = 0; k < 6; ++k) orders[k].value = {0.3, 0.3};
  const HarmonicPrior prior = learnt(orders, typical(), 3.0);
  QVERIFY2(prior.share > 0.4 && prior.share < 0.5, qPrintable(QString::number(prior.share)));
  QVERIFY2(prior.variance > 0.07 && prior.variance < 0.09, qPrintable(QString::number(prior.variance)));
}

/// Over curves of which a quarter of the orders are there, at every noise from far below to far above them.
void TestHarmonicEvidence::standardErrorsHoldTheTruth() {
  Noise noise(11);
  for (const double error : {0.002, 0.02, 0.06, 0.3}) {
    double covered = 0.0, squares = 0.0, plainSquares = 0.0, count = 0.0;
    for (int curve = 0; curve < 400; ++curve) {
      std::vector<HarmonicEvidence> orders;
      std::vector<std::complex<double>> truth;
      for (int k = 0; k < 12; ++k) {
        const bool there = noise.uniform() < 0.25;
        truth.emplace_back(there ? 0.06 * noise.normal() : 0.0, there ? 0.06 * noise.normal() : 0.0);
        orders.push_back(
            {truth.back() + std::complex<double>(error * noise.normal(), error * noise.normal()), error * error});
      }
      const HarmonicPrior prior = learnt(orders, typical(), 3.0);
      double off = 0.0, variance = 0.0;
      for (size_t k = 0; k < orders.size(); ++k) {
        const auto one = weighed(orders[k], prior);
        off += (one.value - truth[k]).real();
        variance += one.variance;
        squares += std::norm(one.value - truth[k]);
        plainSquares += std::norm(orders[k].value - truth[k]);
      }
      covered += std::abs(off) <= 1.96 * std::sqrt(variance) ? 1.0 : 0.0;
      count += 1.0;
    }
    const QString said = QString("error %1: %2 covered, %3 of the plain error")
                             .arg(error)
                             .arg(covered / count)
                             .arg(std::sqrt(squares / plainSquares));
    QVERIFY2(covered / count > 0.89 && covered / count < 0.99, qPrintable(said));
    QVERIFY2(squares < 0.75 * plainSquares, qPrintable(said));
  }
}

QTEST_APPLESS_MAIN(TestHarmonicEvidence)
#include "tst_harmonic_evidence.moc"
