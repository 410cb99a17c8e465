#include <QTest>

#include "diagnose/diagnosed.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

/// Recordings without an angle: the speed is what is measured, predicted and scored.
class TestSpeedAlone : public QObject {
  Q_OBJECT
 private slots:
  void completeModel_lacksNothing();
  void stribeckFriction_isNamed();
  void mixedChannels_areOneClearLine();
};

void TestSpeedAlone::completeModel_lacksNothing() {
  const Diagnosis diagnosis = diagnosed({.seconds = 20.0, .speedStep_rad_per_s = 0.02});
  if (sanitized) return;
  QVERIFY2(nameOf(diagnosis.verdict) == "nothing_missing", inWords(diagnosis).c_str());
  QCOMPARE(diagnosis.fit.channel, std::string("velocity_rad_per_s"));
  // Steps of 0.02 rad/s alone make 0.0058.
  QVERIFY2(diagnosis.fit.floor > 0.005 && diagnosis.fit.floor < 0.05, qPrintable(QString::number(diagnosis.fit.floor)));
  QVERIFY2(diagnosis.fit.heldoutAfter < 2.0 * diagnosis.fit.floor,
           qPrintable(QString::number(diagnosis.fit.heldoutAfter)));
}

void TestSpeedAlone::stribeckFriction_isNamed() {
  const Diagnosis diagnosis = diagnosed({.static_Nm = 0.018, .seconds = 20.0, .speedStep_rad_per_s = 0.02});
  if (sanitized) return;
  QVERIFY2(nameOf(diagnosis.verdict) == "named", inWords(diagnosis).c_str());
  QCOMPARE(diagnosis.findings.front().effect, std::string("stribeck"));
  QVERIFY(isProved(diagnosis.fit));
  QVERIFY2(inWords(diagnosis).find("rad/s, by") != std::string::npos, inWords(diagnosis).c_str());
}

void TestSpeedAlone::mixedChannels_areOneClearLine() {
  const auto angle = recordRig({.seconds = 4.0}), speed = recordRig({.seconds = 4.0, .speedStep_rad_per_s = 0.02});
  const auto diagnosis = diagnose(angle.bench, {angle.recording, speed.recording}, {}, {});
  VERIFY_ERROR(diagnosis,
               "test.csv: measures another channel than test.csv: expected angle_rad in all recordings or in none");
}

QTEST_APPLESS_MAIN(TestSpeedAlone)
#include "tst_speed_alone.moc"
