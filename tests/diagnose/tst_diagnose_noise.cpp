#include <QTest>
#include <algorithm>

#include "diagnose/diagnosed.h"

using namespace breakaway;
using namespace breakaway::test;

/// Recordings of the simulated rig's plant that lack nothing, or whose torque wanders at random.
class TestDiagnoseNoise : public QObject {
  Q_OBJECT
 private slots:
  void cleanRigWithNoise_lacksNothing();
  void torqueThatWandersALittle_isNotMissing();
  void effectUnderATorqueThatWanders_isNamed();
};

void TestDiagnoseNoise::cleanRigWithNoise_lacksNothing() {
  for (unsigned seed = 1; seed <= (thorough() ? 3 : 1); ++seed) {
    const Diagnosis diagnosis = diagnosed({.seconds = 20.0, .seed = seed});
    if (sanitized) return;
    QVERIFY2(diagnosis.findings.empty(), diagnosis.findings.empty() ? "" : diagnosis.findings.front().sentence.c_str());
    QCOMPARE(nameOf(diagnosis.verdict), std::string("nothing_missing"));
    QVERIFY(diagnosis.nextSeparates.empty());
    QCOMPARE(diagnosis.unexplainedShare, 0.0);
    const FitScore& fit = diagnosis.fit;
    QCOMPARE(fit.heldoutAfter, fit.heldoutBefore);
    QCOMPARE(fit.improvementLow95, 0.0);
    QCOMPARE(fit.improvementHigh95, 0.0);
    // One count is 0.44 mrad.
    QVERIFY2(fit.heldoutBefore > 1e-4 && fit.heldoutBefore < 3e-3, qPrintable(QString::number(fit.heldoutBefore)));
  }
}

void TestDiagnoseNoise::torqueThatWandersALittle_isNotMissing() {
  if (sanitized) QSKIP(likeOthers);
  const Diagnosis diagnosis = diagnosed({.seconds = 20.0, .wander_Nm = 0.008 * 0.012});
  QCOMPARE(nameOf(diagnosis.verdict), std::string("nothing_missing"));
  QVERIFY2(diagnosis.fit.heldoutAfter > 2.5 * diagnosis.fit.floor, qPrintable(QString::number(diagnosis.fit.floor)));
  QVERIFY2(within(diagnosis.wander.rms, gauge * 0.008 * 0.012, 0.3), qPrintable(QString::number(diagnosis.wander.rms)));
  const bool said = std::any_of(diagnosis.remarks.begin(), diagnosis.remarks.end(), [](const std::string& remark) {
    return remark.find("changes at random by") != std::string::npos;
  });
  QVERIFY2(said, inWords(diagnosis).c_str());
}

void TestDiagnoseNoise::effectUnderATorqueThatWanders_isNamed() {
  if (sanitized) QSKIP(likeOthers);
  const Diagnosis diagnosis = diagnosed({.positionTorque = "[[9, 0.0012, 0.4]]", .wander_Nm = 0.015 * 0.012});
  QVERIFY(!diagnosis.findings.empty());
  const Finding& finding = diagnosis.findings.front();
  QCOMPARE(finding.effect, std::string("cogging"));
  QCOMPARE(parameter(finding, "order"), 9.0);
  QVERIFY2(within(parameter(finding, "amplitude_Nm"), gauge * 0.0012, 0.1),
           qPrintable(QString::number(parameter(finding, "amplitude_Nm"))));
}

QTEST_APPLESS_MAIN(TestDiagnoseNoise)
#include "tst_diagnose_noise.moc"
