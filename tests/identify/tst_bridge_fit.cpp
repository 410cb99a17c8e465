#include "identify/bridge_fit.h"

#include <QTest>
#include <cmath>

#include "base/random.h"
#include "identify/motor_identification.h"
#include "support/sanitized.h"

using namespace breakaway;
using test::sanitized, test::seedsToTry;

class TestBridgeFit : public QObject {
  Q_OBJECT
 private slots:
  void bentBridge_isFoundWithResistanceAndBackEmf();
  void curvesIntervals_holdTheTruth();
  void straightBridge_hasNoCurve();
  void coarseEncoder_leavesTheResistanceAlone();
  void lowVoltages_areRefusedInWords();
  void alwaysTheSameCurrent_isRefusedInWords();
  void curveThatCantBeTold_leavesTheBackEmfOpen();
  void supplyThatFallsUnseen_leavesTheBackEmfAlone_data();
  void supplyThatFallsUnseen_leavesTheBackEmfAlone();
};

namespace {

constexpr double R = 1.2, Ke = 0.07, supply_V = 24.0, deadZone = 0.012, tick_s = 0.01;

double bent(double duty) {
  const double x = std::max(0.0, std::abs(duty) - deadZone);
  return std::copysign(x - 0.012 * (1.0 - std::exp(-x / 0.02)), duty);
}

double bentFar(double duty) {
  const double x = std::max(0.0, std::abs(duty) - deadZone);
  return std::copysign(x - 0.02 * (1.0 - std::exp(-x / 0.06)), duty);
}

double straight(double duty) {
  return std::copysign(std::max(0.0, std::abs(duty) - deadZone), duty);
}

/// A standing rotor's ramps, and a turning one to and fro whose current is `swing_A` this way and that; the supply
/// falls by `sag_ohm` times what the bridge takes.
BridgeTests tests(double (*bridge)(double), double highest_duty, double swing_A, unsigned seed, double sag_ohm = 0.0) {
  Noise noise(seed);
  BridgeTests tests;
  tests.supply_V = supply_V;
  for (int k = 1; k <= 400; ++k) {
    const double duty = (k % 2 == 0 ? 1.0 : -1.0) * 0.03 * k / 400.0;
    tests.standing.push_back({duty * supply_V, bridge(duty) * supply_V / R + 0.002 + 0.003 * noise.normal()});
  }
  std::vector<SpinBlock> blocks;
  double angle = 0.0, current = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const double phase = k / 150.0 - std::floor(k / 150.0), duty = highest_duty * (1.0 - 4.0 * std::abs(phase - 0.5));
    // What friction and inertia make of it is no matter: any current may flow at any voltage.
    current = 0.15 * (duty > 0.0 ? 1.0 : -1.0) + swing_A * std::sin(k / 37.0);
    const double driven_V = bridge(duty) * supply_V, bus_A = std::max(0.0, driven_V * current / supply_V);
    const double speed = (driven_V * (1.0 - sag_ohm * bus_A / supply_V) - R * current) / Ke;
    angle += speed * tick_s;
    blocks.push_back({tick_s * (k + 1), tick_s, angle, current - 0.001 + 0.003 * noise.normal(), duty * supply_V});
  }
  tests.moving = {blocks};
  return tests;
}

}  // namespace

void TestBridgeFit::bentBridge_isFoundWithResistanceAndBackEmf() {
  for (unsigned seed = 1; seed <= seedsToTry(5); ++seed) {
    const auto fit = fitBridge(tests(bent, 0.5, 1.0, seed));
    QVERIFY2(fit.ok(), fit.ok() ? "" : fit.error().message().c_str());
    QVERIFY2(std::abs(fit->resistance_ohm.value / R - 1.0) < 0.005,
             qPrintable(QString::number(fit->resistance_ohm.value)));
    QVERIFY(std::abs(fit->backEmfConstant_V_s_per_rad.value / Ke - 1.0) < 0.003);
    QVERIFY(std::abs(fit->deadZone_V.value / supply_V - deadZone) < 0.001);
    QVERIFY(fit->curve.known() && fit->curve.rises());
    for (const double duty : {0.016, 0.02, 0.03, 0.05, 0.1, 0.3})
      QVERIFY2(std::abs(fit->curve.output(duty) - bent(duty)) < 6e-4, qPrintable(QString::number(duty)));
  }
}

void TestBridgeFit::curvesIntervals_holdTheTruth() {
  int held = 0, points = 0;
  for (unsigned seed = 1; seed <= seedsToTry(10); ++seed) {
    const auto fit = fitBridge(tests(bent, 0.5, 1.0, seed));
    QVERIFY(fit.ok());
    held += fit->resistance_ohm.low95() <= R && R <= fit->resistance_ohm.high95() ? 1 : 0;
    held += fit->backEmfConstant_V_s_per_rad.low95() <= Ke && Ke <= fit->backEmfConstant_V_s_per_rad.high95() ? 1 : 0;
    points += 2;
  }
  QVERIFY2(sanitized || held >= points - 4, qPrintable(QString::number(held)));
}

void TestBridgeFit::straightBridge_hasNoCurve() {
  for (unsigned seed = 1; seed <= seedsToTry(10); ++seed) {
    const auto fit = fitBridge(tests(straight, 0.5, 1.0, seed));
    QVERIFY2(fit.ok(), fit.ok() ? "" : fit.error().message().c_str());
    QVERIFY(!fit->curve.known());
    QVERIFY(std::abs(fit->resistance_ohm.value / R - 1.0) < 0.005);
  }
}

/// Its rounding is half of what the winding takes here: it would make R too large by a tenth, or bend a straight
/// bridge.
void TestBridgeFit::coarseEncoder_leavesTheResistanceAlone() {
  constexpr double count_rad = 0.03;
  int held = 0;
  double mistaken = 0.0;
  for (unsigned seed = 1; seed <= seedsToTry(10); ++seed) {
    BridgeTests coarse = tests(straight, 0.5, 0.15, seed);
    for (SpinBlock& block : coarse.moving[0]) block.angle_rad = count_rad * std::floor(block.angle_rad / count_rad);
    const auto plain = fitBridge(coarse);
    mistaken = std::max(mistaken, plain ? plain->resistance_ohm.value / R - 1.0 : 1.0);
    coarse.count_rad = count_rad;
    const auto fit = fitBridge(coarse);
    QVERIFY2(fit.ok(), fit.ok() ? "" : fit.error().message().c_str());
    QVERIFY(!fit->curve.known());
    const Estimate &found = fit->resistance_ohm, &Ke_found = fit->backEmfConstant_V_s_per_rad;
    QVERIFY2(std::abs(found.value / R - 1.0) < 0.02, qPrintable(QString::number(found.value)));
    QVERIFY(std::abs(Ke_found.value / Ke - 1.0) < 0.002);
    held += found.low95() <= R && R <= found.high95() ? 1 : 0;
  }
  QVERIFY2(sanitized || held >= 8, qPrintable(QString::number(held)));
  QVERIFY2(mistaken > 0.05, qPrintable(QString::number(mistaken)));
}

void TestBridgeFit::lowVoltages_areRefusedInWords() {
  const auto fit = fitBridge(tests(bent, 0.1, 1.0, 1));
  QVERIFY(!fit.ok());
  QVERIFY2(fit.error().message().find("V only") != std::string::npos, fit.error().message().c_str());
}

void TestBridgeFit::alwaysTheSameCurrent_isRefusedInWords() {
  BridgeTests same = tests(bent, 0.5, 0.0, 1);
  same.standing.clear();
  for (SpinBlock& block : same.moving[0]) block.current_A = 0.15;
  const auto fit = fitBridge(same);
  QVERIFY(!fit.ok());
  QVERIFY2(fit.error().message().find("resistance") != std::string::npos, fit.error().message().c_str());
}

/// The current hardly differs, and a constant by a straight line beyond the dead zone is off by what the bridge bends.
void TestBridgeFit::curveThatCantBeTold_leavesTheBackEmfOpen() {
  int untold = 0, straightHeld = 0, held = 0;
  for (unsigned seed = 1; seed <= seedsToTry(16); ++seed) {
    BridgeTests same = tests(bentFar, 0.4, 0.005, seed);
    same.standing.clear();
    const auto any = backEmfOfAnyCurve(same);
    if (fitBridge(same).ok() || !any) continue;
    ++untold;
    double n = 0.0, w = 0.0, ww = 0.0, e = 0.0, we = 0.0;
    for (size_t k = 1; k < same.moving[0].size(); ++k) {
      const SpinBlock &before = same.moving[0][k - 1], &here = same.moving[0][k];
      const double way = here.voltage_V > 0.0 ? 1.0 : -1.0;
      const double speed = way * (here.angle_rad - before.angle_rad) / here.duration_s;
      const double emf = way * (here.voltage_V - R * here.current_A);
      if (speed * Ke < 0.05 * supply_V) continue;
      n += 1.0, w += speed, ww += speed * speed, e += emf, we += speed * emf;
    }
    IdentifiedMotor motor;
    motor.backEmfConstant_V_s_per_rad.value = (we - w * e / n) / (ww - w * w / n);
    motor.backEmfConstant_V_s_per_rad.standardError = 7e-4 * motor.backEmfConstant_V_s_per_rad.value;
    const auto holds = [&] {
      const Estimate& one = motor.backEmfConstant_V_s_per_rad;
      return one.low95() <= Ke && Ke <= one.high95();
    };
    straightHeld += holds() ? 1 : 0;
    const double doubt = widenByBridge(motor, *any);
    QVERIFY2(doubt < 0.5, qPrintable(QString::number(doubt)));
    QCOMPARE(motor.torqueConstant_Nm_per_A.standardError, motor.backEmfConstant_V_s_per_rad.standardError);
    held += holds() ? 1 : 0;
  }
  QVERIFY2(sanitized || (untold >= 5 && straightHeld <= untold / 4 && held >= untold - 1),
           qPrintable(QString("of %1: %2, %3").arg(untold).arg(straightHeld).arg(held)));
}

void TestBridgeFit::supplyThatFallsUnseen_leavesTheBackEmfAlone_data() {
  QTest::addColumn<double>("sag");
  QTest::addColumn<double>("count_rad");
  QTest::newRow("none") << 0.0 << 0.0;
  QTest::newRow("a twentieth of the winding's") << 0.05 * R << 0.0;
  QTest::newRow("a fifth of it") << 0.2 * R << 0.0;
  QTest::newRow("a twentieth of it, coarse encoder") << 0.05 * R << 0.01;
}

void TestBridgeFit::supplyThatFallsUnseen_leavesTheBackEmfAlone() {
  QFETCH(double, sag);
  QFETCH(double, count_rad);
  int held = 0;
  for (unsigned seed = 1; seed <= seedsToTry(10); ++seed) {
    BridgeTests seen = tests(straight, 0.7, 1.0, seed, sag);
    seen.count_rad = count_rad;
    for (SpinBlock& block : seen.moving[0])
      if (count_rad > 0.0) block.angle_rad = count_rad * std::floor(block.angle_rad / count_rad);
    const auto fit = fitBridge(seen);
    QVERIFY2(fit.ok(), fit.ok() ? "" : fit.error().message().c_str());
    const Estimate& found = fit->backEmfConstant_V_s_per_rad;
    QVERIFY2(std::abs(found.value / Ke - 1.0) < 0.002, qPrintable(QString::number(found.value / Ke)));
    QVERIFY(std::abs(fit->resistance_ohm.value / R - 1.0) < 0.01);
    QVERIFY(found.standardError < 0.002 * Ke);
    held += found.low95() <= Ke && Ke <= found.high95() ? 1 : 0;
  }
  QVERIFY2(sanitized || held >= 8, qPrintable(QString::number(held)));
}

QTEST_APPLESS_MAIN(TestBridgeFit)
#include "tst_bridge_fit.moc"
