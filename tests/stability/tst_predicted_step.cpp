// The foretold step: against the same loop integrated by Runge and Kutta, and where current, friction and supply bound
// what a motor can do.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "stability/predicted_step.h"
#include "stability/simulated_loop.h"

using namespace breakaway;
using namespace breakaway::test;

class TestPredictedStep : public QObject {
  Q_OBJECT
 private slots:
  void step_isThatOfTheIntegratedLoop_data();
  void step_isThatOfTheIntegratedLoop();
  void proportionalGain_leavesTheErrorThatFrictionHolds();
  void frictionBeyondTheCurrentLimit_holdsTheShaft();
  void staticFriction_delaysAStartAndNothingElse();
  void lowSupply_boundsTheSpeed();
};

namespace {

ServoLoop unlimitedLoop(int delay_ticks) {
  ServoLoop loop = servoLoop(1.0, 1e-3, delay_ticks);
  loop.settings.gains.velocity_ki_A_per_rad = 10.0 * loop.settings.gains.velocity_kp_A_s_per_rad;
  loop.settings.current_limit_A = 1e6;
  return loop;
}

StepWanted stepTo(double speed_rad_per_s) {
  StepWanted wanted;
  wanted.to_rad_per_s = speed_rad_per_s;
  return wanted;
}

}  // namespace

void TestPredictedStep::step_isThatOfTheIntegratedLoop_data() {
  QTest::addColumn<int>("delay");
  for (const int delay : {0, 1, 2}) QTest::addRow("%d ticks late", delay) << delay;
}

void TestPredictedStep::step_isThatOfTheIntegratedLoop() {
  QFETCH(int, delay);
  const ServoLoop loop = unlimitedLoop(delay);
  const PredictedStep step = predictStep(loop, stepTo(20.0));
  SimulatedLoop integrated(loop);
  double furthest = 0.0, most = 0.0;
  for (size_t k = 0; k < step.time_s.size(); ++k) {
    if (step.time_s[k] < -0.5 * loop.board.tick_s) continue;
    if (std::abs(step.time_s[k]) < 0.5 * loop.board.tick_s) integrated.ask(20.0);
    furthest = std::max(furthest, std::abs(step.velocity_rad_per_s[k] - integrated.velocity_rad_per_s()));
    most = std::max(most, integrated.velocity_rad_per_s());
    integrated.step();
  }
  QVERIFY2(most > 15.0, qPrintable(QString::number(most)));
  QVERIFY2(furthest < 0.02 * 20.0, qPrintable(QString::number(furthest)));
}

void TestPredictedStep::proportionalGain_leavesTheErrorThatFrictionHolds() {
  // At rest of the transient Kt·kp·(ω* − ω) = F + B·ω.
  ServoLoop loop = unlimitedLoop(1);
  loop.settings.gains.velocity_ki_A_per_rad = 0.0;
  loop.settings.observer_cutoff_rad_per_s = 0.0;
  StepWanted wanted = stepTo(20.0);
  wanted.coulomb_Nm = 0.02;
  const double stiffness = loop.motor.torqueConstant_Nm_per_A * loop.settings.gains.velocity_kp_A_s_per_rad;
  const double expected = (stiffness * 20.0 - wanted.coulomb_Nm) / (stiffness + loop.motor.viscous_Nm_s_per_rad);
  const double found = predictStep(loop, wanted).velocity_rad_per_s.back();
  QVERIFY2(std::abs(found - expected) < 0.02 * expected, qPrintable(QString("%1, %2").arg(found).arg(expected)));
}

void TestPredictedStep::frictionBeyondTheCurrentLimit_holdsTheShaft() {
  ServoLoop loop = unlimitedLoop(1);
  loop.settings.current_limit_A = 0.5;
  StepWanted wanted = stepTo(200.0);
  wanted.coulomb_Nm = 0.5 * loop.motor.torqueConstant_Nm_per_A * 2.0;  // beyond the current's overshoot, too
  const PredictedStep held = predictStep(loop, wanted);
  QCOMPARE(*std::max_element(held.velocity_rad_per_s.begin(), held.velocity_rad_per_s.end()), 0.0);
  wanted.coulomb_Nm = 0.5 * loop.motor.torqueConstant_Nm_per_A * 0.8;
  const PredictedStep moved = predictStep(loop, wanted);
  QVERIFY(moved.velocity_rad_per_s.back() > 1.0);
  const double last_A = moved.current_A.back();  // the speed is far from reached
  QVERIFY2(last_A > 0.49 && last_A < 0.51, qPrintable(QString::number(last_A)));
}

void TestPredictedStep::staticFriction_delaysAStartAndNothingElse() {
  // The integral part winds up until the shaft breaks loose: at twice the friction later, then as fast as without.
  const ServoLoop loop = unlimitedLoop(1);
  StepWanted wanted = stepTo(2.0);
  wanted.coulomb_Nm = 0.01;
  const auto startOf = [](const PredictedStep& step) {
    size_t k = 0;
    while (k + 1 < step.time_s.size() && step.velocity_rad_per_s[k] <= 0.0) ++k;
    return step.time_s[k];
  };
  const PredictedStep plain = predictStep(loop, wanted);
  wanted.static_Nm = 0.005;  // less than what moves has is as much
  QCOMPARE(predictStep(loop, wanted).velocity_rad_per_s, plain.velocity_rad_per_s);
  wanted.static_Nm = 0.02;
  const PredictedStep stuck = predictStep(loop, wanted);
  QVERIFY2(startOf(stuck) > startOf(plain) + 1e-3, qPrintable(QString::number(startOf(stuck))));
  const auto breaks =
      static_cast<size_t>(std::find(stuck.time_s.begin(), stuck.time_s.end(), startOf(stuck)) - stuck.time_s.begin());
  const double drive_Nm = loop.motor.torqueConstant_Nm_per_A * stuck.current_A[breaks];
  QVERIFY2(drive_Nm > 0.019 && drive_Nm < 0.03, qPrintable(QString::number(drive_Nm)));
  const double end = stuck.velocity_rad_per_s.back(), expected = plain.velocity_rad_per_s.back();
  QVERIFY2(std::abs(end - expected) < 0.1 * 2.0, qPrintable(QString("%1, %2").arg(end).arg(expected)));
}

void TestPredictedStep::lowSupply_boundsTheSpeed() {
  // 2 V hold 2/Ke = 28.6 rad/s against nothing but the back-EMF.
  const ServoLoop loop = unlimitedLoop(1);
  StepWanted wanted = stepTo(100.0);
  wanted.supply_V = 2.0;
  wanted.after_s = 2.0;
  const double found = predictStep(loop, wanted).velocity_rad_per_s.back();
  QVERIFY2(found > 20.0 && found < 28.6, qPrintable(QString::number(found)));
}

QTEST_APPLESS_MAIN(TestPredictedStep)
#include "tst_predicted_step.moc"
