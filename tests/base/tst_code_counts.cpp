#include <QTest>
#include <cmath>

#include "base/code_counts.h"
#include "base/random.h"

using namespace breakaway;

class TestCodeCounts : public QObject {
  Q_OBJECT
 private slots:
  void noiseBelowAStep_hidesTheMeanWithinItsInterval();
  void noiseOfAStep_leavesTheMeanAsItIs();
  void oneValueOnly_leavesMostOfAStepOpen();
  void smallestStep_isTheConvertersAcrossANewZero();
};

namespace {

CodeCounts shown(double signal, double noise, double step, unsigned seed) {
  Noise random(seed);
  CodeCounts counts;
  for (int k = 0; k < 4000; ++k) counts.add(step * std::round((signal + noise * random.normal()) / step));
  return counts;
}

}  // namespace

/// Signals anywhere within a step, noise of an eighth to half of it: the plain mean is far off, and says nothing of it.
void TestCodeCounts::noiseBelowAStep_hidesTheMeanWithinItsInterval() {
  constexpr double step = 0.074;
  double plain = 0.0, better = 0.0, normal = 0.0;
  int inside = 0;
  constexpr int trials = 200;
  Random random(7);
  for (unsigned k = 0; k < trials; ++k) {
    const double signal = step * (random.uniform() - 0.5), noise = step / (2.0 + 6.0 * random.uniform());
    const CodeCounts counts = shown(signal, noise, step, k);
    const Estimate beyond = counts.beyondMean(step);
    const double off = counts.shownMean() - signal, left = off + beyond.value;
    plain += off * off / trials, better += left * left / trials;
    inside += std::abs(left) < normal95 * std::hypot(beyond.standardError, 0.5 * step / std::sqrt(4000.0)) ? 1 : 0;
    normal += left * left / (beyond.standardError * beyond.standardError + 1e-8) / trials;
  }
  QVERIFY2(better < 0.2 * plain, qPrintable(QString("%1 of %2").arg(std::sqrt(better)).arg(std::sqrt(plain))));
  QVERIFY2(inside >= 0.88 * trials, qPrintable(QString::number(inside)));
  QVERIFY2(normal > 0.2, qPrintable(QString::number(normal)));
}

void TestCodeCounts::noiseOfAStep_leavesTheMeanAsItIs() {
  QCOMPARE(shown(0.013, 0.1, 0.1, 3).beyondMean(0.1), Estimate{});
  QCOMPARE(shown(0.013, 0.01, 0.1, 3).beyondMean(0.0), Estimate{});
}

void TestCodeCounts::oneValueOnly_leavesMostOfAStepOpen() {
  const Estimate beyond = shown(0.0, 0.005, 0.1, 3).beyondMean(0.1);
  QVERIFY(std::abs(beyond.value) < 0.005);
  QVERIFY2(beyond.standardError > 0.01 && beyond.standardError < 0.03,
           qPrintable(QString::number(beyond.standardError)));
}

void TestCodeCounts::smallestStep_isTheConvertersAcrossANewZero() {
  SmallestStep steps;
  QCOMPARE(steps.step(), 0.0);
  for (const double one : {0.0, 0.2, 0.3, 0.1}) steps.add(one);
  steps.interrupt();
  for (const double one : {0.13, 0.23, 0.23 + 1e-9, 0.43}) steps.add(one);
  QVERIFY(std::abs(steps.step() - 0.1) < 1e-9);
}

QTEST_APPLESS_MAIN(TestCodeCounts)
#include "tst_code_counts.moc"
