#include <QTest>

#include "diagnose/diagnosed.h"

using namespace breakaway;
using namespace breakaway::test;

/// Effects whose shape (order, Stribeck velocity) the search has to find.
class TestDiagnoseShapes : public QObject {
  Q_OBJECT
 private slots:
  void cogging_isNamedWithOrderAndAmplitude();
  void stribeck_isNamedWithItsVelocity();
};

namespace {

/// What was fitted in the finding's place errs by more on the windows that no fit saw, each with an interval that holds
/// it, the nearest first; the finding is none of them.
void checkRivals(const Diagnosis& diagnosis) {
  const FitScore& fit = diagnosis.fit;
  QVERIFY(fit.after95.low <= fit.heldoutAfter && fit.heldoutAfter <= fit.after95.high);
  QVERIFY(fit.before95.low <= fit.heldoutBefore && fit.heldoutBefore <= fit.before95.high);
  const Finding& finding = diagnosis.findings.front();
  QVERIFY(!finding.rivals.empty());
  double nearest = 0.0;
  for (const RivalScore& rival : finding.rivals) {
    QVERIFY(rival.effect != finding.effect);
    QVERIFY2(rival.low95 <= rival.error && rival.error <= rival.high95, rival.effect.c_str());
    QVERIFY2(within(rival.ratio, rival.error / fit.heldoutAfter, 1e-9), rival.effect.c_str());
    QVERIFY2(rival.ratioLow95 > 1.0 && rival.ratioLow95 <= rival.ratio && rival.ratio <= rival.ratioHigh95,
             rival.effect.c_str());
    QVERIFY(!errsAlike(rival) && rival.error >= nearest);
    nearest = rival.error;
  }
}

}  // namespace

void TestDiagnoseShapes::cogging_isNamedWithOrderAndAmplitude() {
  const Diagnosis diagnosis = diagnosed({.positionTorque = "[[12, 0.003, 1.1]]", .seconds = 20.0});
  if (sanitized) return;
  QCOMPARE(nameOf(diagnosis.verdict), std::string("named"));
  QCOMPARE(diagnosis.findings.size(), size_t(1));
  const Finding& finding = diagnosis.findings.front();
  QCOMPARE(finding.effect, std::string("cogging"));
  QCOMPARE(parameter(finding, "order"), 12.0);
  const double amplitude = std::abs(parameter(finding, "amplitude_Nm"));
  QVERIFY2(within(amplitude, gauge * 0.003, 0.05), qPrintable(QString::number(amplitude)));
  QVERIFY2(finding.share > 0.8 && finding.share <= 1.0, qPrintable(QString::number(finding.share)));
  QVERIFY(isProved(diagnosis.fit));
}

void TestDiagnoseShapes::stribeck_isNamedWithItsVelocity() {
  const Diagnosis diagnosis = diagnosed({.static_Nm = 0.02, .seconds = 20.0, .seed = 3});
  if (sanitized) return;
  QCOMPARE(nameOf(diagnosis.verdict), std::string("named"));
  QCOMPARE(diagnosis.findings.size(), size_t(1));
  const Finding& finding = diagnosis.findings.front();
  QCOMPARE(finding.effect, std::string("stribeck"));
  const double excess = parameter(finding, "excess_Nm"), velocity = parameter(finding, "velocity_rad_per_s");
  QVERIFY2(within(excess, gauge * 0.008, 0.1), qPrintable(QString::number(excess)));
  QVERIFY2(within(velocity, 1.5, 0.1), qPrintable(QString::number(velocity)));
  QVERIFY2(finding.share > 0.8 && finding.share <= 1.0, qPrintable(QString::number(finding.share)));
  QVERIFY(isProved(diagnosis.fit));
  checkRivals(diagnosis);
}

QTEST_APPLESS_MAIN(TestDiagnoseShapes)
#include "tst_diagnose_shapes.moc"
