// Margins and noise of the loop: against frequency sweeps and noise put through the controller's own code.
#include <QTest>
#include <cmath>
#include <numbers>

#include "stability/loop_noise.h"
#include "stability/margins.h"
#include "stability/root_locus.h"
#include "stability/simulated_loop.h"

using namespace breakaway;
using namespace breakaway::test;

class TestMargins : public QObject {
  Q_OBJECT
 private slots:
  void sensitivity_isWhatASineSweepMeasures_data();
  void sensitivity_isWhatASineSweepMeasures();
  void slowLoad_isSeenWholeAndHeldAgainst();
  void margins_agreeWithADenseSweep_data();
  void margins_agreeWithADenseSweep();
  void gainMargin_isWhereTheSimulatedLoopBeginsToGrow_data();
  void gainMargin_isWhereTheSimulatedLoopBeginsToGrow();
  void delayMargin_isWhereTheSimulatedLoopBeginsToGrow();
  void integral_boundsTheGainFromBelowToo();
  void unstableLoop_hasNoMargins();
  void openLoop_hasNothingToLose();
  void noise_isThatOfManyTicks_data();
  void noise_isThatOfManyTicks();
  void roundedAngle_makesAboutTheNoiseOfWhiteRounding_data();
  void roundedAngle_makesAboutTheNoiseOfWhiteRounding();
  void higherCutoff_costsMoreNoise();
  void unstableLoop_hasNoNoiseFigure();
};

namespace {

/// The measured angle over the angle error that is put in, at one frequency: S.
std::complex<double> measuredSensitivity(const ServoLoop& loop, int ticksPerPeriod) {
  SimulatedLoop simulated(loop);
  const int settle = 20000 / ticksPerPeriod * ticksPerPeriod, counted = settle + 20 * ticksPerPeriod;
  std::complex<double> in, out;
  double mean = 0.0;
  for (int k = 0; k < counted; ++k) {
    const double phase = 2.0 * std::numbers::pi * k / ticksPerPeriod, error = 1e-3 * std::sin(phase);
    const double angle = simulated.angle_rad();
    simulated.step(error);
    if (k == settle) mean = angle;
    if (k < settle) continue;
    in += std::polar(error, -phase);
    out += std::polar(angle - mean + error, -phase);
  }
  return out / in;
}

ServoLoop modes(bool position, double alpha, double tick_s) {
  ServoLoop loop = servoLoop(alpha, tick_s, 1);
  loop.mode = position ? ServoMode::position : ServoMode::velocity;
  loop.settings.gains.position_kp_A_per_rad = 0.7;
  loop.settings.gains.position_kd_A_s_per_rad = 0.05;
  return loop;
}

void addModes() {
  QTest::addColumn<bool>("position");
  QTest::addColumn<double>("alpha");
  QTest::addColumn<double>("tick_s");
  for (const bool position : {false, true}) {
    for (const double alpha : {0.8, 1.0, 1.5}) {
      for (const double tick_s : {2e-4, 1e-3}) {
        QTest::newRow(qPrintable(
            QString("%1, alpha %2, T %3 ms").arg(position ? "position" : "velocity").arg(alpha).arg(1e3 * tick_s)))
            << position << alpha << tick_s;
      }
    }
  }
}

}  // namespace

void TestMargins::sensitivity_isWhatASineSweepMeasures_data() {
  addModes();
}

void TestMargins::sensitivity_isWhatASineSweepMeasures() {
  QFETCH(bool, position);
  QFETCH(double, alpha);
  QFETCH(double, tick_s);
  const ServoLoop loop = modes(position, alpha, tick_s);
  for (const int ticks : {10, 40, 100, 400}) {
    const auto expected = loopResponse(loop, {2.0 * std::numbers::pi / (ticks * tick_s)}).sensitivity.front();
    const auto measured = measuredSensitivity(loop, ticks);
    QVERIFY2(
        std::abs(measured - expected) < 0.01 * std::abs(expected),
        qPrintable(QString("%1 ticks: %2 expected %3").arg(ticks).arg(std::abs(measured)).arg(std::abs(expected))));
  }
}

void TestMargins::slowLoad_isSeenWholeAndHeldAgainst() {
  ServoLoop loop = servoLoop(1.0, 2e-4, 1);
  loop.motor.viscous_Nm_s_per_rad = 0.0;
  const auto closed = closedResponse(loop, {0.1, 200.0, 5000.0});
  QVERIFY(std::abs(closed.following[0] - 1.0) < 0.01);
  QVERIFY(std::abs(closed.observing[0] - 1.0) < 0.01);
  QVERIFY(std::abs(closed.observing[1]) > 0.3 && std::abs(closed.observing[1]) < 1.5);
  QVERIFY(std::abs(closed.observing[2]) < 0.05);
  // Slow loads meet s/(J·w)·(1/g + L/R + T), as what the current lags behind the estimate; fast ones the bare inertia.
  const double slow = 0.1 / (6e-5 * 60.0) * (1.0 / 200.0 + 0.0011 / 1.2 + 2e-4);
  QVERIFY2(std::abs(std::abs(closed.yielding[0]) / slow - 1.0) < 0.02, qPrintable(QString::number(slow)));
  QVERIFY(std::abs(std::abs(closed.yielding[2]) * 6e-5 * 5000.0 - 1.0) < 0.1);
}

void TestMargins::margins_agreeWithADenseSweep_data() {
  addModes();
}

void TestMargins::margins_agreeWithADenseSweep() {
  QFETCH(bool, position);
  QFETCH(double, alpha);
  QFETCH(double, tick_s);
  const ServoLoop loop = modes(position, alpha, tick_s);
  const LoopMargins found = margins(loop);
  QVERIFY(found.stable);
  const auto sweep = loopResponse(loop, decades(1.0, std::numbers::pi / tick_s, 20000));
  double gain = HUGE_VAL, phase = HUGE_VAL, peak = 0.0, complementary = 0.0;
  for (size_t k = 0; k < sweep.loop.size(); ++k) {
    const auto L = sweep.loop[k];
    peak = std::max(peak, std::abs(sweep.sensitivity[k]));
    complementary = std::max(complementary, std::abs(sweep.complementary[k]));
    if (std::abs(std::abs(L) - 1.0) < 1e-3) phase = std::min(phase, std::abs(std::arg(-L)));
    if (std::abs(std::arg(-L)) < 1e-3 && std::abs(L) < 1.0) gain = std::min(gain, 1.0 / std::abs(L));
  }
  QVERIFY(std::abs(found.gainMargin / gain - 1.0) < 0.01);
  QVERIFY(std::abs(found.phaseMargin_rad / phase - 1.0) < 0.01);
  QVERIFY(std::abs(found.peakSensitivity / peak - 1.0) < 1e-4);
  QVERIFY(std::abs(found.peakComplementary / complementary - 1.0) < 1e-4);
  // A vector of length 1/Ms around −1 bounds both margins.
  QVERIFY(found.gainMargin >= peak / (peak - 1.0) * (1.0 - 1e-3));
  QVERIFY(found.phaseMargin_rad >= 2.0 * std::asin(0.5 / peak) * (1.0 - 1e-3));
}

void TestMargins::gainMargin_isWhereTheSimulatedLoopBeginsToGrow_data() {
  addModes();
}

void TestMargins::gainMargin_isWhereTheSimulatedLoopBeginsToGrow() {
  QFETCH(bool, position);
  QFETCH(double, alpha);
  QFETCH(double, tick_s);
  const ServoLoop loop = modes(position, alpha, tick_s);
  const double margin = margins(loop).gainMargin;
  QVERIFY(!grows(loop, 0.98 * margin));
  QVERIFY(grows(loop, 1.02 * margin));
}

void TestMargins::delayMargin_isWhereTheSimulatedLoopBeginsToGrow() {
  ServoLoop loop = servoLoop(2.0, 2e-4, 0);
  const double ticks = margins(loop).delayMargin_s / loop.board.tick_s;
  QVERIFY(ticks > 5.0 && ticks < 20.0);
  loop.delay_ticks = static_cast<int>(std::floor(0.95 * ticks));
  QVERIFY(!grows(loop));
  loop.delay_ticks = static_cast<int>(std::ceil(1.05 * ticks));
  QVERIFY(grows(loop));
}

void TestMargins::integral_boundsTheGainFromBelowToo() {
  ServoLoop loop = servoLoop(1.0, 2e-4, 1);
  QCOMPARE(margins(loop).gainReduction, 0.0);
  loop.motor.viscous_Nm_s_per_rad = 0.0;
  loop.motor.backEmfConstant_V_s_per_rad = loop.board.current.backEmfConstant_V_s_per_rad = 0.0;
  loop.settings.gains.velocity_ki_A_per_rad = 2.0;
  const double least = margins(loop).gainReduction;
  QVERIFY(least > 0.01 && least < 1.0);
  const auto heavier = [&loop](double part) {
    ServoLoop other = loop;
    other.motor.inertia_kg_m2 /= part;
    return spectralRadius(closedLoop(other));
  };
  QVERIFY(heavier(1.01 * least) < 1.0);
  QVERIFY(heavier(0.99 * least) > 1.0);
}

void TestMargins::unstableLoop_hasNoMargins() {
  const LoopMargins found = margins(withCutoff(servoLoop(6.0, 2e-4, 1), 400.0));
  QVERIFY(!found.stable);
  QCOMPARE(found.gainMargin, 0.0);
  QVERIFY(found.damping < 0.0);
}

void TestMargins::openLoop_hasNothingToLose() {
  ServoLoop loop = servoLoop(1.0, 2e-4, 1);
  loop.settings.gains = {};
  loop.settings.observer_cutoff_rad_per_s = 0.0;
  loop.current = CurrentPath::ideal;
  const LoopMargins found = margins(loop);
  QVERIFY(found.stable);
  QVERIFY(std::isinf(found.gainMargin) && std::isinf(found.phaseMargin_rad) && std::isinf(found.delayMargin_s));
  QVERIFY(std::abs(found.peakSensitivity - 1.0) < 1e-12);
}

void TestMargins::noise_isThatOfManyTicks_data() {
  QTest::addColumn<double>("cutoff");
  QTest::addColumn<double>("angle_rad");
  QTest::addColumn<double>("current_A");
  for (const double cutoff : {50.0, 200.0, 600.0}) {
    QTest::newRow(qPrintable(QString("encoder, g %1").arg(cutoff))) << cutoff << 1.26e-4 << 0.0;
    QTest::newRow(qPrintable(QString("current, g %1").arg(cutoff))) << cutoff << 0.0 << 0.018;
    QTest::newRow(qPrintable(QString("both, g %1").arg(cutoff))) << cutoff << 1.26e-4 << 0.018;
  }
}

void TestMargins::noise_isThatOfManyTicks() {
  QFETCH(double, cutoff);
  QFETCH(double, angle_rad);
  QFETCH(double, current_A);
  const ServoLoop loop = withCutoff(servoLoop(1.1, 2e-4, 1), cutoff);
  const auto expected = loopNoise(loop, {angle_rad, current_A});
  QVERIFY(expected.ok());
  SimulatedLoop simulated(loop);
  const unsigned seed = 7;
  qInfo("seed %u", seed);
  Noise noise(seed);
  double estimate = 0.0, current = 0.0, shown = 0.0, speed = 0.0, voltage = 0.0;
  const int settle = 5000, count = 600000;
  for (int k = 0; k < settle + count; ++k) {
    const double before = simulated.velocity_rad_per_s();
    const auto out = simulated.step(angle_rad * noise.normal(), current_A * noise.normal());
    if (k < settle) continue;
    estimate += out.disturbance_estimate_Nm * out.disturbance_estimate_Nm;
    current += out.current_reference_A * out.current_reference_A;
    shown += out.velocity_rad_per_s * out.velocity_rad_per_s;
    speed += before * before;
    voltage += out.voltage_V * out.voltage_V;
  }
  const auto near = [](double squares, double value) {
    return std::abs(std::sqrt(squares / count) / value - 1.0) < 0.03;
  };
  QVERIFY(near(estimate, expected->estimate_Nm));
  QVERIFY(near(current, expected->currentReference_A));
  QVERIFY(near(shown, expected->velocityEstimate_rad_per_s));
  QVERIFY(near(speed, expected->velocity_rad_per_s));
  QVERIFY(near(voltage, expected->voltage_V));
}

void TestMargins::roundedAngle_makesAboutTheNoiseOfWhiteRounding_data() {
  QTest::addColumn<double>("speed_rad_per_s");
  QTest::addColumn<double>("most");
  for (const double speed : {0.3, 3.0, 7.3, 20.0}) QTest::newRow(qPrintable(QString::number(speed))) << speed << 1.2;
  QTest::newRow("a saw tooth") << 0.01 << 3.5;
  QTest::newRow("a count per tick") << 2.18 << 3.5;
}

void TestMargins::roundedAngle_makesAboutTheNoiseOfWhiteRounding() {
  QFETCH(double, speed_rad_per_s);
  QFETCH(double, most);
  const double count = 2.0 * std::numbers::pi / 14400.0;
  const ServoLoop loop = servoLoop(1.0, 2e-4, 1);
  const auto expected = loopNoise(loop, {roundingRms_rad(count), 0.0});
  QVERIFY(expected.ok());
  SimulatedLoop simulated(loop);
  simulated.ask(speed_rad_per_s);
  double sum = 0.0, squares = 0.0;
  const int settle = 20000, ticks = 200000;
  for (int k = 0; k < settle + ticks; ++k) {
    const double angle = simulated.angle_rad();
    const double estimate =
        simulated.step(std::floor(angle / count) * count + 0.5 * count - angle).disturbance_estimate_Nm;
    if (k < settle) continue;
    sum += estimate;
    squares += estimate * estimate;
  }
  const double rms = std::sqrt(squares / ticks - std::pow(sum / ticks, 2)), ratio = rms / expected->estimate_Nm;
  QVERIFY2(ratio > 0.5 && ratio < most, qPrintable(QString::number(ratio)));
}

void TestMargins::higherCutoff_costsMoreNoise() {
  const auto curve = noiseOverCutoff(servoLoop(1.0, 2e-4, 1), {1.26e-4, 0.018}, {25.0, 50.0, 100.0, 200.0, 400.0});
  for (size_t k = 1; k < curve.size(); ++k) {
    QVERIFY(curve[k].estimate_Nm > 1.2 * curve[k - 1].estimate_Nm);
    QVERIFY(curve[k].estimate_Nm < 4.0 * curve[k - 1].estimate_Nm);
    QVERIFY(curve[k].estimateByEncoder_Nm < curve[k].estimate_Nm);
  }
}

void TestMargins::unstableLoop_hasNoNoiseFigure() {
  const ServoLoop loop = servoLoop(6.0, 2e-4, 1);
  QVERIFY(!loopNoise(withCutoff(loop, 400.0), {1e-4, 0.0}));
  const auto curve = noiseOverCutoff(loop, {1e-4, 0.0}, {20.0, 400.0});
  QVERIFY(curve[0].estimate_Nm > 0.0 && std::isnan(curve[1].estimate_Nm));
}

QTEST_APPLESS_MAIN(TestMargins)
#include "tst_margins.moc"
