// The sampled loop's poles: against cases worked by hand, and against the controller's own code in time.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <deque>

#include "stability/root_locus.h"
#include "stability/simulated_loop.h"

using namespace breakaway;
using namespace breakaway::test;

class TestServoLoop : public QObject {
  Q_OBJECT
 private slots:
  void proportionalGain_hasThePolesWorkedByHand_data();
  void proportionalGain_hasThePolesWorkedByHand();
  void lateProportionalGain_isUnstableFromTheGainWorkedByHand();
  void observerAlone_hasThePolesWorkedByHand();
  void heldRotor_leavesTheCurrentLoopsPoles();
  void everySignal_isThatOfTheControllersCode_data();
  void everySignal_isThatOfTheControllersCode();
  void cutoffOfInstability_isThatOfTheSimulatedLoop_data();
  void cutoffOfInstability_isThatOfTheSimulatedLoop();
  void alphaGT_ofInstabilityIsThatOfTheSimulatedIdealLoop_data();
  void alphaGT_ofInstabilityIsThatOfTheSimulatedIdealLoop();
  void ruleOfThumb_isWhereDampingIsLostWithOneTickOfDelay();
  void branches_goOnWithoutJumps();
  void incompleteLoop_isRefusedByItsField();
};

namespace {

ServoLoop idealLoop(double gainPerTick, int delay_ticks) {
  ServoLoop loop = servoLoop(1.0, 1e-3, delay_ticks);
  loop.current = CurrentPath::ideal;
  loop.speed = SpeedSource::backwardDifference;
  loop.motor.viscous_Nm_s_per_rad = 0.0;
  loop.settings.observer_cutoff_rad_per_s = 0.0;
  loop.settings.gains.velocity_kp_A_s_per_rad =
      gainPerTick * loop.motor.inertia_kg_m2 / (loop.motor.torqueConstant_Nm_per_A * loop.board.tick_s);
  return loop;
}

/// How far the nearest pole lies from z.
double distanceTo(const std::complex<double>& z, const std::vector<std::complex<double>>& poles) {
  double least = HUGE_VAL;
  for (const auto& one : poles) least = std::min(least, std::abs(one - z));
  return least;
}

std::vector<std::complex<double>> quadraticRoots(double b, double c) {
  const std::complex<double> root = std::sqrt(std::complex<double>(b * b / 4.0 - c));
  return {-b / 2.0 + root, -b / 2.0 - root};
}

}  // namespace

void TestServoLoop::proportionalGain_hasThePolesWorkedByHand_data() {
  QTest::addColumn<double>("gain");
  for (const double gain : {0.05, 0.3, 1.0, 1.9, 2.1}) QTest::newRow(qPrintable(QString::number(gain))) << gain;
}

void TestServoLoop::proportionalGain_hasThePolesWorkedByHand() {
  // ω' = ω − c·v with v the mean of the last two speeds, c = kp·Kt·T/J: z² − z + c/2·(z + 1) = 0, stable up to c = 2.
  QFETCH(double, gain);
  const auto found = poles(closedLoop(idealLoop(gain, 0)));
  for (const auto& z : quadraticRoots(gain / 2.0 - 1.0, gain / 2.0)) QVERIFY(distanceTo(z, found) < 1e-6);
  QCOMPARE(spectralRadius(closedLoop(idealLoop(gain, 0))) < 1.0, gain < 2.0);
}

void TestServoLoop::lateProportionalGain_isUnstableFromTheGainWorkedByHand() {
  // One tick later: z³ − z² + c/2·(z + 1) = 0 meets the unit circle at 45° with c = 2·tan 22.5° = 2·(√2 − 1).
  const double most = 2.0 * (std::sqrt(2.0) - 1.0);
  QVERIFY(spectralRadius(closedLoop(idealLoop(0.9999 * most, 1))) < 1.0);
  QVERIFY(spectralRadius(closedLoop(idealLoop(1.0001 * most, 1))) > 1.0);
  QVERIFY(distanceTo(std::polar(1.0, M_PI / 4.0), poles(closedLoop(idealLoop(most, 1)))) < 1e-6);
}

void TestServoLoop::observerAlone_hasThePolesWorkedByHand() {
  // Without a speed loop Kn·u = s − gJn·v and s = p·s⁻ + (1 − p)·(Kn·u⁻ + gJn·v) leave u = −p·gJn/Kn·v but for a
  // constant: the loop above with c = α·gT·e^{−gT}, and a speed that is free.
  for (const double alpha : {0.5, 1.0, 4.0, 9.0}) {
    ServoLoop loop = idealLoop(0.0, 0);
    loop.settings.observer_cutoff_rad_per_s = 300.0;
    loop.motor.inertia_kg_m2 /= alpha;
    const double c = alpha * 0.3 * std::exp(-0.3);
    QVERIFY(std::abs(loop.alphaGT() - 0.3 * alpha) < 1e-12);
    const auto found = poles(closedLoop(loop));
    for (const auto& z : quadraticRoots(c / 2.0 - 1.0, c / 2.0)) QVERIFY(distanceTo(z, found) < 1e-6);
    QVERIFY(distanceTo(1.0, found) < 1e-6);
  }
}

void TestServoLoop::heldRotor_leavesTheCurrentLoopsPoles() {
  // i' = a·i + (1 − a)/R·v, v = −L·w·i + I, I' = I − R·w·T·i: trace a − (1 − a)·L·w/R + 1, and so on.
  ServoLoop loop = servoLoop(1.0, 2e-4, 0);
  loop.motor.inertia_kg_m2 = loop.settings.inertia_kg_m2 = 1e9;
  loop.settings.gains = {};
  loop.settings.observer_cutoff_rad_per_s = 0.0;
  const double a = std::exp(-1.2 / 0.0011 * 2e-4), first = a - (1.0 - a) * 0.0011 * 300.0 / 1.2;
  const double b = -(first + 1.0), c = first + (1.0 - a) * 300.0 * 2e-4;
  const auto found = poles(closedLoop(loop));
  for (const auto& z : quadraticRoots(b, c)) QVERIFY(distanceTo(z, found) < 1e-6);
}

void TestServoLoop::everySignal_isThatOfTheControllersCode_data() {
  QTest::addColumn<bool>("position");
  QTest::addColumn<int>("delay");
  for (const int delay : {0, 1, 2}) {
    QTest::newRow(qPrintable(QString("velocity, delay %1").arg(delay))) << false << delay;
    QTest::newRow(qPrintable(QString("position, delay %1").arg(delay))) << true << delay;
  }
}

void TestServoLoop::everySignal_isThatOfTheControllersCode() {
  QFETCH(bool, position);
  QFETCH(int, delay);
  ServoLoop loop = servoLoop(1.3, 2e-4, delay);
  loop.mode = position ? ServoMode::position : ServoMode::velocity;
  loop.settings.gains = {0.05, 0.3, 1e-5, 1.3, 2.0, 0.07, 0.0};
  const DiscreteSystem closed = closedLoop(loop);
  SimulatedLoop simulated(loop);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(closed.A.rows()), u(4), worst = Eigen::VectorXd::Zero(6), largest = worst;
  const unsigned seed = 11;
  qInfo("seed %u", seed);
  Noise noise(seed);
  const double target = position ? 0.2 : 10.0;
  simulated.ask(target);
  for (int k = 0; k < 1500; ++k) {
    u << target, k > 500 ? 0.01 : 0.0, 1e-4 * noise.normal(), 0.02 * noise.normal();
    if (k == 0) u[3] = 0.0;  // the controller doesn't look at the current before its first command has acted
    const double speed = simulated.velocity_rad_per_s(), angle = simulated.angle_rad();
    const auto out = simulated.step(u[2], u[3], u[1]);
    const Eigen::VectorXd y = closed.C * x + closed.D * u;
    Eigen::VectorXd code(6);
    code << speed, out.velocity_rad_per_s, out.disturbance_estimate_Nm, out.current_reference_A, out.voltage_V,
        position ? angle : 0.0;
    worst = worst.cwiseMax((code - y).cwiseAbs());
    largest = largest.cwiseMax(code.cwiseAbs());
    x = closed.A * x + closed.B * u;
  }
  for (int k = 0; k < (position ? 6 : 5); ++k)
    QVERIFY2(worst[k] < 1e-5 * largest[k] && largest[k] > 0.0, qPrintable(QString("output %1").arg(k)));
}

void TestServoLoop::cutoffOfInstability_isThatOfTheSimulatedLoop_data() {
  QTest::addColumn<double>("alpha");
  QTest::addColumn<double>("tick_s");
  QTest::addColumn<int>("delay");
  for (const double tick_s : {1e-4, 2e-4, 1e-3}) {
    for (const double alpha : {1.5, 3.0, 4.0, 6.0}) {
      for (const int delay : {0, 1}) {
        QTest::newRow(qPrintable(QString("alpha %1, T %2 ms, delay %3").arg(alpha).arg(1e3 * tick_s).arg(delay)))
            << alpha << tick_s << delay;
      }
    }
  }
}

void TestServoLoop::cutoffOfInstability_isThatOfTheSimulatedLoop() {
  QFETCH(double, alpha);
  QFETCH(double, tick_s);
  QFETCH(int, delay);
  const ServoLoop loop = servoLoop(alpha, tick_s, delay);
  const auto predicted = cutoffBounds(loop).unstable_rad_per_s;
  std::optional<double> stable, unstable;
  for (double g = 20.0; g < 10.0 / tick_s && !unstable; g *= 1.15) (grows(withCutoff(loop, g)) ? unstable : stable) = g;
  QCOMPARE(unstable.has_value(), predicted.has_value());
  if (!predicted) return;
  QVERIFY2(stable.has_value(), "the simulated loop grows at any cutoff");
  for (int k = 0; k < 5; ++k) {
    const double middle = std::sqrt(*stable * *unstable);
    (grows(withCutoff(loop, middle)) ? unstable : stable) = middle;
  }
  const double simulated = std::sqrt(*stable * *unstable);
  qInfo("predicted %.4g rad/s, simulated %.4g rad/s, alpha g T %.3f", *predicted, simulated,
        withCutoff(loop, *predicted).alphaGT());
  QVERIFY(std::abs(*predicted / simulated - 1.0) < 0.02);
}

namespace {

/// The loop of the rule: held current, backward difference, the observer's own code, a slow speed loop.
ServoLoop ruleLoop(double alphaGT, double gT, int delay_ticks) {
  ServoLoop loop = idealLoop(1e-3 * gT, delay_ticks);
  loop.settings.observer_cutoff_rad_per_s = gT / loop.board.tick_s;
  loop.motor.inertia_kg_m2 *= gT / alphaGT;
  return loop;
}

bool idealGrows(const ServoLoop& loop) {
  const double T = loop.board.tick_s, perAmp = loop.motor.torqueConstant_Nm_per_A / loop.motor.inertia_kg_m2;
  DisturbanceObserver<double> observer;
  observer.configure(
      {loop.settings.observer_cutoff_rad_per_s, loop.settings.inertia_kg_m2, loop.settings.torqueConstant_Nm_per_A}, T);
  std::deque<double> waiting(static_cast<size_t>(loop.delay_ticks), 0.0);
  double speed = 1e-3, angle = 0.0, lastAngle = 0.0, current = 0.0, before = 0.0, after = 0.0;
  const int ticks = 30000;
  for (int k = 0; k < ticks; ++k) {
    const double shown = (angle - lastAngle) / T;
    lastAngle = angle;
    const double estimate = observer.step(current, shown);
    waiting.push_back(-loop.settings.gains.velocity_kp_A_s_per_rad * shown +
                      estimate / loop.settings.torqueConstant_Nm_per_A);
    current = waiting.front();
    waiting.pop_front();
    angle += T * (speed + 0.5 * T * perAmp * current);
    speed += T * perAmp * current;
    if (std::abs(speed) > 1e9) return true;
    if (k >= ticks / 3) (k < 2 * ticks / 3 ? before : after) += current * current;
  }
  return after > before && after > 1e-20;
}

}  // namespace

void TestServoLoop::alphaGT_ofInstabilityIsThatOfTheSimulatedIdealLoop_data() {
  QTest::addColumn<double>("gT");
  QTest::addColumn<int>("delay");
  for (const double gT : {0.02, 0.1, 0.3}) {
    for (const int delay : {0, 1, 2})
      QTest::newRow(qPrintable(QString("gT %1, delay %2").arg(gT).arg(delay))) << gT << delay;
  }
}

void TestServoLoop::alphaGT_ofInstabilityIsThatOfTheSimulatedIdealLoop() {
  QFETCH(double, gT);
  QFETCH(int, delay);
  const auto onset = [](const auto& unstable) {
    double low = 0.05, high = 8.0;
    while (high > 1.001 * low) {
      const double middle = std::sqrt(low * high);
      (unstable(middle) ? high : low) = middle;
    }
    return low;
  };
  const double predicted = onset([&](double k) { return spectralRadius(closedLoop(ruleLoop(k, gT, delay))) >= 1.0; });
  const double simulated = onset([&](double k) { return idealGrows(ruleLoop(k, gT, delay)); });
  qInfo("alpha g T predicted %.3f, simulated %.3f", predicted, simulated);
  QVERIFY(std::abs(predicted / simulated - 1.0) < 0.02);
  QVERIFY(predicted > 0.4 && predicted < 4.0);
}

void TestServoLoop::ruleOfThumb_isWhereDampingIsLostWithOneTickOfDelay() {
  const auto dampingAt = [](double alphaGT, int delay) {
    return damping(poles(closedLoop(ruleLoop(alphaGT, 0.02, delay))));
  };
  QVERIFY(dampingAt(0.24, 1) > 0.707 && dampingAt(0.30, 1) < 0.707);
  QVERIFY(dampingAt(0.30, 0) > 0.707 && dampingAt(0.55, 0) < 0.707);
  QCOMPARE(cutoffBounds(ruleLoop(0.1, 0.02, 1)).ruleOfThumb_rad_per_s, 0.3 / (5.0 * 1e-3));
}

void TestServoLoop::branches_goOnWithoutJumps() {
  const ServoLoop loop = servoLoop(1.0, 1e-3, 1);
  const RootLocus locus = rootLocus(loop, decades(10.0, 3000.0, 400));
  QVERIFY(locus.branches.size() >= 9);
  for (const auto& branch : locus.branches) {
    QCOMPARE(branch.size(), size_t{400});
    for (size_t k = 1; k < branch.size(); ++k) QVERIFY(std::abs(branch[k] - branch[k - 1]) < 0.1);
  }
  const auto bounds = cutoffBounds(loop);
  QVERIFY(bounds.unstable_rad_per_s && bounds.lessDamped_rad_per_s);
  QVERIFY(*bounds.lessDamped_rad_per_s < *bounds.unstable_rad_per_s);
  QVERIFY(std::abs(spectralRadius(closedLoop(withCutoff(loop, *bounds.unstable_rad_per_s))) - 1.0) < 1e-6);
  QVERIFY(std::abs(damping(poles(closedLoop(withCutoff(loop, *bounds.lessDamped_rad_per_s)))) - 0.707) < 1e-4);
}

void TestServoLoop::incompleteLoop_isRefusedByItsField() {
  QVERIFY(check(servoLoop(1.0, 2e-4, 1)));
  ServoLoop loop = servoLoop(1.0, 2e-4, 1);
  loop.motor.inductance_H = 0.0;
  QCOMPARE(check(loop).error().place, std::string("inductance_H"));
  loop.current = CurrentPath::ideal;
  QVERIFY(check(loop));
  loop.board.tick_s = std::nan("");
  QCOMPARE(check(loop).error().place, std::string("tick_s"));
}

QTEST_APPLESS_MAIN(TestServoLoop)
#include "tst_servo_loop.moc"
