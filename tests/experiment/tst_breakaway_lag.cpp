#include <QTest>
#include <cmath>

#include "experiment/breakaway_lag.h"
#include "experiment/breakaway_ramp.h"

using namespace breakaway;

class TestBreakawayLag : public QObject {
  Q_OBJECT
 private slots:
  void countsThatFollow_tellWhereTheRotorStood();
  void oneCountAlone_leavesEveryPlaceOpen();
  void frictionThatFallsWithinACount_isReadFromTheNext();
  void withoutBackEmf_itIsACubeRoot();
  void withBackEmf_itAgreesWithIntegration();
  void unknownInertia_givesNone();
  void currentThatComesLate_isNoSteeperRamp();
};

/// A step and a ramp on a winding of L/R = 12 ms, on which the rotor lets go at 9 A.
void TestBreakawayLag::currentThatComesLate_isNoSteeperRamp() {
  constexpr double tick_s = 2.5e-4, winding_s = 0.012, start_A = 6.3, rate_A_per_s = 6.0, count_rad = 5e-5;
  BreakawayRamp ramp({start_A, rate_A_per_s, 100.0, false}, 1.0, 0.0, count_rad, 1);
  double time_s = 0.0, flows_A = 0.0;
  for (; flows_A < 9.0; time_s += tick_s) {
    const double commanded_A = start_A + rate_A_per_s * time_s;
    ramp.add({time_s, commanded_A, flows_A, 0.0});
    flows_A += (commanded_A - flows_A) * -std::expm1(-tick_s / winding_s);
  }
  ramp.add({time_s, start_A + rate_A_per_s * time_s, flows_A, 1.1 * count_rad});
  const auto slopeOf = [](const BreakawayEvent& event) { return event.covariance_A2 / event.commandedVariance_A2; };
  BreakawayLag motor;
  const double early = slopeOf(ramp.event(motor, tick_s));
  QVERIFY2(early > 1.15, qPrintable(QString::number(early)));
  motor.windingTime_s = winding_s;
  const BreakawayEvent event = ramp.event(motor, tick_s);
  QVERIFY2(std::abs(slopeOf(event) - 1.0) < 0.01, qPrintable(QString::number(slopeOf(event))));
  QVERIFY2(std::abs(event.current_A - 9.0) < 0.01, qPrintable(QString::number(event.current_A)));
}

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

void TestBreakawayLag::countsThatFollow_tellWhereTheRotorStood() {
  const BreakawayLag motor{6e-5, 0.07, 0.07, 1.2};
  const double rate = 0.2, count = 4.4e-4;
  for (const double toEdge : {0.1, 0.5, 0.9}) {
    std::vector<double> edges_s(4);
    for (size_t k = 0; k < 4; ++k)
      edges_s[k] = 7.0 + motionLag_s(motor, rate, (toEdge + static_cast<double>(k)) * count);
    const double lag_s = likelyMotionLag_s(motor, rate, count, edges_s, 1e-4);
    const double truth_s = motionLag_s(motor, rate, toEdge * count);
    QVERIFY2(std::abs(lag_s / truth_s - 1.0) < 0.12, qPrintable(QString::number(lag_s / truth_s)));
  }
}

void TestBreakawayLag::oneCountAlone_leavesEveryPlaceOpen() {
  const BreakawayLag motor{6e-5, 0.07, 0.0, 0.0};
  // Without back-EMF the time grows with the cube root of the travel, whose mean over a count is three quarters.
  const double lag_s = likelyMotionLag_s(motor, 0.2, 4.4e-4, {0.1}, 1e-4), whole_s = motionLag_s(motor, 0.2, 4.4e-4);
  QVERIFY2(std::abs(lag_s / whole_s - 0.75) < 0.005, qPrintable(QString::number(lag_s / whole_s)));
}

/// A coarse encoder: friction has lost a fifth before the first count comes, and the rotor was so much faster.
void TestBreakawayLag::frictionThatFallsWithinACount_isReadFromTheNext() {
  const BreakawayLag motor{4e-6, 0.025, 0.025, 5.0, 0.1};
  const double rate = 0.2, count = 0.0157, drop_A = 0.02, fallsOver = 0.6, dt = 1e-6;
  double worst_s = 0.0, worstWithout_s = 0.0;
  for (const double toEdge : {0.2, 0.6, 0.95}) {
    std::vector<double> edges_s;
    double speed = 0.0, angle = 0.0, time = 0.0;
    while (edges_s.size() < 4) {
      const double x = speed / fallsOver;
      const double driven_A = rate * time - drop_A * std::expm1(-x * x);
      speed += dt * 0.025 / 4e-6 * (driven_A - 0.025 * speed / 5.0);
      angle += dt * speed;
      time += dt;
      if (angle > (toEdge + static_cast<double>(edges_s.size())) * count) edges_s.push_back(time);
    }
    const double lag_s = likelyMotionLag_s(motor, rate, count, edges_s, 5e-5);
    BreakawayLag stays = motor;
    stays.friction_A = 0.0;
    const double off_s = std::abs(lag_s - edges_s[0]);
    const double without_s = std::abs(likelyMotionLag_s(stays, rate, count, edges_s, 5e-5) - edges_s[0]);
    worst_s = std::max(worst_s, off_s);
    worstWithout_s = std::max(worstWithout_s, without_s);
  }
  QVERIFY2(worst_s < 0.6 * worstWithout_s, qPrintable(QString("%1 %2").arg(worst_s).arg(worstWithout_s)));
}

QTEST_APPLESS_MAIN(TestBreakawayLag)
#include "tst_breakaway_lag.moc"
