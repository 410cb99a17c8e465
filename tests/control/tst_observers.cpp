#include <QTest>
#include <cmath>

#include "motor/noise.h"
#include "observer/disturbance_observer.h"
#include "observer/velocity_observer.h"

using namespace breakaway;

class TestObservers : public QObject {
  Q_OBJECT
 private slots:
  void exponential_agreesWithTheLibrary();
  void constantLoad_isApproachedWithTheExactPole();
  void changedCutoff_givesNoJump();
  void floatObserver_followsTheDoubleOne();
  void constantAcceleration_leavesNoVelocityError();
  void quantisedRamp_isQuieterThanTheBackwardDifference();
};

void TestObservers::exponential_agreesWithTheLibrary() {
  for (double x = 0.0; x > -40.0; x -= 0.37) QVERIFY(std::abs(exponential(x) / std::exp(x) - 1.0) < 1e-12);
}

void TestObservers::constantLoad_isApproachedWithTheExactPole() {
  // Standing at zero speed with current i held: τ̂ after n ticks is Kt·i·(1 − e^(−g·n·T)).
  DisturbanceObserver<double> observer;
  observer.configure({200.0, 6e-5, 0.07}, 2e-4);
  observer.reset(0.0);
  double estimate = 0.0;
  for (int k = 0; k < 50; ++k) estimate = observer.step(0.3, 0.0);
  QVERIFY(std::abs(estimate / (0.021 * (1.0 - std::exp(-200.0 * 50 * 2e-4))) - 1.0) < 1e-10);
}

void TestObservers::changedCutoff_givesNoJump() {
  DisturbanceObserver<double> observer;
  observer.configure({200.0, 6e-5, 0.07}, 2e-4);
  double before = 0.0;
  for (int k = 0; k < 500; ++k) before = observer.step(0.3, 20.0);
  observer.configure({50.0, 6e-5, 0.07}, 2e-4);
  QVERIFY(std::abs(observer.step(0.3, 20.0) - before) < 1e-6);
}

void TestObservers::floatObserver_followsTheDoubleOne() {
  DisturbanceObserver<double> fine;
  DisturbanceObserver<float> board;
  fine.configure({200.0, 6e-5, 0.07}, 2e-4);
  board.configure({200.0f, 6e-5f, 0.07f}, 2e-4f);
  Noise noise(3);
  double worst = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double current = 0.3 + 0.1 * noise.normal(), speed = 20.0 * std::sin(k * 1e-3);
    worst = std::max(worst,
                     std::abs(fine.step(current, speed) -
                              static_cast<double>(board.step(static_cast<float>(current), static_cast<float>(speed)))));
  }
  QVERIFY2(worst < 1e-5 && worst > 0.0, qPrintable(QString::number(worst)));
}

void TestObservers::constantAcceleration_leavesNoVelocityError() {
  VelocityObserver<double> observer;
  observer.configure(400.0, 0.0, 2e-4);
  double velocity = 0.0, time = 0.0;
  for (int k = 0; k < 5000; ++k) {
    time = k * 2e-4;
    velocity = observer.step(0.5 * 100.0 * time * time, 0.0);
  }
  QVERIFY(std::abs(velocity - 100.0 * time) < 1e-6);
}

void TestObservers::quantisedRamp_isQuieterThanTheBackwardDifference() {
  VelocityObserver<double> observer;
  const double T = 2e-4, count = 2.0 * M_PI / 14400.0, speed = 7.3;
  observer.configure(400.0, 0.0, T);
  double last = 0.0, squares = 0.0, raw = 0.0;
  int n = 0;
  for (int k = 0; k < 20000; ++k) {
    const double angle = std::floor(speed * k * T / count) * count;
    const double velocity = observer.step(angle + 0.5 * count, 0.0);
    if (k > 2000)
      squares += (velocity - speed) * (velocity - speed), raw += std::pow((angle - last) / T - speed, 2), ++n;
    last = angle;
  }
  const double ratio = std::sqrt(squares / raw);
  QVERIFY2(ratio < 0.05 && ratio > 0.0001, qPrintable(QString::number(ratio)));
}

QTEST_APPLESS_MAIN(TestObservers)
#include "tst_observers.moc"
