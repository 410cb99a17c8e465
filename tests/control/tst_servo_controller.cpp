#include <QTest>
#include <cmath>

#include "control/servo_controller.h"
#include "control/tuning.h"

using namespace breakaway;

class TestServoController : public QObject {
  Q_OBJECT
 private slots:
  void off_isDisabledWithoutVoltage();
  void zeroing_takesTheMeanOff();
  void currentLoop_reachesItsReferenceWithItsBandwidth();
  void currentLimitOfACommand_holds();
  void velocityOutput_staysWithinTheLimit();
  void observerCutoff_keepsAlphaGT();
};

namespace {
ServoController<double>::Board board() {
  return {2e-4, 2.0 * M_PI / 14400.0, {1.2, 0.0011, 0.07, 300.0}, 400.0};
}
ServoSettings<double> settings() {
  return {tuneMotion(6e-5, 0.07, 60.0, 40.0), 200.0, 6e-5, 0.07, 5.0};
}
/// A rotor that is held stands as if its inertia were without end.
ServoSettings<double> heldSettings() {
  ServoSettings<double> held = settings();
  held.inertia_kg_m2 = 1e3;
  return held;
}
}  // namespace

void TestServoController::off_isDisabledWithoutVoltage() {
  ServoController<double> controller(board());
  const auto out = controller.step(0.0, 0.3, 24.0);
  QVERIFY(!out.enabled);
  QCOMPARE(out.voltage_V, 0.0);
}

void TestServoController::zeroing_takesTheMeanOff() {
  ServoController<double> controller(board());
  controller.configure(settings());
  controller.command({ServoMode::off, 0.0, 0.0, true});
  for (int k = 0; k < 100; ++k) controller.step(0.0, k % 2 == 0 ? 0.06 : 0.04, 24.0);
  controller.command({});
  QVERIFY(std::abs(controller.step(0.0, 0.05, 24.0).current_A) < 1e-12);
}

void TestServoController::currentLoop_reachesItsReferenceWithItsBandwidth() {
  // A stalled winding. The feed-forward alone follows with L/R; together the loop must be settled after five of the
  // slower constants.
  ServoController<double> controller(board());
  controller.configure(heldSettings());
  controller.command({ServoMode::current, 1.0, 0.0, false});
  double current = 0.0;
  const double pole = std::exp(-1.2 / 0.0011 * 2e-4);
  for (int k = 0; k < 100; ++k) {
    const double v = controller.step(0.0, current, 24.0).voltage_V;
    current = v / 1.2 + (current - v / 1.2) * pole;
  }
  QVERIFY(std::abs(current - 1.0) < 0.01);
}

void TestServoController::currentLimitOfACommand_holds() {
  ServoController<double> controller(board());
  controller.configure(heldSettings());
  controller.command({ServoMode::voltage, 24.0, 0.5, false});
  double current = 0.0, highest = 0.0;
  const double pole = std::exp(-1.2 / 0.0011 * 2e-4);
  for (int k = 0; k < 2000; ++k) {
    const double v = controller.step(0.0, current, 24.0).voltage_V;
    current = v / 1.2 + (current - v / 1.2) * pole;
    highest = std::max(highest, current);
  }
  QVERIFY2(highest < 0.52 && current > 0.48, qPrintable(QString::number(highest)));
}

void TestServoController::velocityOutput_staysWithinTheLimit() {
  ServoController<double> controller(board());
  controller.configure(settings());
  controller.command({ServoMode::velocity, 1000.0, 2.0, false});
  for (int k = 0; k < 100; ++k) {
    const double reference = controller.step(0.0, 0.0, 24.0).current_reference_A;
    QVERIFY(std::abs(reference) <= 2.0);
  }
}

void TestServoController::observerCutoff_keepsAlphaGT() {
  for (const double tick_s : {5e-5, 2e-4, 1e-3, 5e-3}) {
    const double g = tuneObserver(tick_s, std::min(400.0, 0.4 / tick_s));
    QVERIFY(g * tick_s <= 0.3 + 1e-12);
    QVERIFY(g > 10.0 && g <= 200.0);
  }
}

QTEST_APPLESS_MAIN(TestServoController)
#include "tst_servo_controller.moc"
