#include <QTest>
#include <cmath>

#include "base/random.h"
#include "identify/stribeck_velocity.h"

using namespace breakaway;

class TestStribeckVelocity : public QObject {
  Q_OBJECT
 private slots:
  void isFoundFromSlowTurns();
  void standardErrorHoldsTheTruth();
  void frictionThatHardlyFalls_isNotKnown();
  void turnsThatAreAllFast_sayNothing();
  void haltingTurns_sayNothing();
};

namespace {

constexpr double Kt = 0.07, coulomb_Nm = 0.017, viscous = 2e-5;

FrictionMap mapWith(double static_Nm) {
  FrictionMap map;
  map.bins.resize(36);
  for (MapBin& bin : map.bins) {
    for (WayBin& way : bin.way) {
      way.static_Nm.value = static_Nm;
      way.coulomb_Nm.value = coulomb_Nm;
      way.viscous_Nm_s_per_rad.value = viscous;
    }
  }
  return map;
}

std::vector<SlowTurn> turnsOf(double stribeck, double static_Nm, const std::vector<double>& speeds, double error_Nm,
                              unsigned seed) {
  Noise noise(seed);
  std::vector<SlowTurn> turns;
  for (const double speed : speeds) {
    for (const double sign : {1.0, -1.0}) {
      const double x = speed / stribeck;
      const double torque =
          coulomb_Nm + (static_Nm - coulomb_Nm) * std::exp(-x * x) + viscous * speed + error_Nm * noise.normal();
      turns.push_back({sign * speed, sign * torque / Kt});
    }
  }
  return turns;
}

const std::vector<double> slow{4.0, 2.0, 1.0, 0.5};

}  // namespace

void TestStribeckVelocity::isFoundFromSlowTurns() {
  for (const double truth : {0.6, 1.5, 3.0}) {
    const Estimate found = stribeckVelocity(turnsOf(truth, 0.022, slow, 0.0, 1), mapWith(0.022), Kt);
    QVERIFY2(std::abs(found.value / truth - 1.0) < 0.01, qPrintable(QString::number(found.value)));
    QVERIFY(found.standardError > 0.0 && found.standardError < 0.15 * truth);
  }
}

void TestStribeckVelocity::standardErrorHoldsTheTruth() {
  double covered = 0.0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Estimate found = stribeckVelocity(turnsOf(1.5, 0.022, slow, 5e-4, seed), mapWith(0.022), Kt);
    covered += std::abs(found.value - 1.5) <= 1.96 * found.standardError ? 1.0 / 200.0 : 0.0;
  }
  QVERIFY2(covered > 0.89 && covered < 0.995, qPrintable(QString::number(covered)));
}

void TestStribeckVelocity::frictionThatHardlyFalls_isNotKnown() {
  QCOMPARE(stribeckVelocity(turnsOf(1.5, 0.0172, slow, 1e-4, 3), mapWith(0.0172), Kt).value, 0.0);
}

void TestStribeckVelocity::turnsThatAreAllFast_sayNothing() {
  QCOMPARE(stribeckVelocity(turnsOf(0.5, 0.022, {4.0, 3.0, 2.5}, 1e-4, 4), mapWith(0.022), Kt).value, 0.0);
}

/// As on a coarse encoder, where the loop pushes the rotor from count to count.
void TestStribeckVelocity::haltingTurns_sayNothing() {
  const double fall_Nm = 0.005, left[] = {0.08, 0.19, 0.78, 3.2};
  std::vector<SlowTurn> turns;
  for (size_t k = 0; k < slow.size(); ++k) {
    const double current_A = (coulomb_Nm + viscous * slow[k] + left[k] * fall_Nm) / Kt;
    turns.push_back({slow[k], current_A});
    turns.push_back({-slow[k], -current_A});
  }
  QCOMPARE(stribeckVelocity(turns, mapWith(coulomb_Nm + fall_Nm), Kt).value, 0.0);
}

QTEST_APPLESS_MAIN(TestStribeckVelocity)
#include "tst_stribeck_velocity.moc"
