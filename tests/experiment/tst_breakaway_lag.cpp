#include <QTest>
#include <cmath>

#include "experiment/breakaway_lag.h"

using namespace breakaway;

class TestBreakawayLag : public QObject {
  Q_OBJECT
 private slots:
  void withoutBackEmf_itIsACubeRoot();
  void withBackEmf_itAgreesWithIntegration();
  void unknownInertia_givesNone();
};

void TestBreakawayLag::withoutBackEmf_itIsACubeRoot() {
  QVERIFY(std::abs(motionLag_s({6e-5, 0.07, 0.0, 0.0}, 0.2, 2e-4) - std::cbrt(6.0 * 2e-4 * 6e-5 / (0.07 * 0.2))) <
          1e-12);
}

void TestBreakawayLag::withBackEmf_itAgreesWithIntegration() {
  const BreakawayLag motor{6e-5, 0.07, 0.07, 1.2};
  const double rate = 0.2, travel = 2e-4, dt = 1e-7;
  double speed = 0.0, angle = 0.0, time = 0.0;
  while (angle < travel) {
    speed += dt * 0.07 / 6e-5 * (rate * (time + 0.5 * dt) - 0.07 * speed / 1.2);
    angle += dt * speed;
    time += dt;
  }
  QVERIFY2(std::abs(motionLag_s(motor, rate, travel) / time - 1.0) < 1e-3, qPrintable(QString::number(time)));
}

void TestBreakawayLag::unknownInertia_givesNone() {
  QCOMPARE(motionLag_s({}, 0.2, 1e-4), 0.0);
}

QTEST_APPLESS_MAIN(TestBreakawayLag)
#include "tst_breakaway_lag.moc"
