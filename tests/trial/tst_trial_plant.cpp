#include <QTest>
#include <cmath>
#include <numbers>
#include <vector>

#include "trial/trial_plant.h"

using namespace breakaway;

class TestTrialPlant : public QObject {
  Q_OBJECT
 private slots:
  void coastingOnCoulombAlone_stopsAtTheClosedFormsAngle();
  void coastingOnViscousAndCoulomb_stopsAtTheClosedFormsTime();
  void windingsUnderAStep_followTheClosedForm();
  void belowItsFriction_itStandsExactlyStill();
  void longerRest_needsMoreTorqueToBreakAway();
  void bristles_giveWayByTorqueOverStiffness();
  void heldLoad_swallowsTheAntiresonance();
  void backlash_letsTheMotorMoveItsGapAlone();
  void delayedInput_actsThatMuchLater();
  void hotWinding_settlesAtTheRiseOfItsLoss();
  void endStop_holdsAgainstTheDrive();
};

namespace {

constexpr double step_s = 25e-6;
constexpr double turn = 2.0 * std::numbers::pi;

TrialPhysics plain() {
  TrialPhysics p;
  p.torqueConstant = 0.07;
  p.resistance_ohm = 1.2;
  p.inductance_H = 1.5e-3;
  p.inertia = 6e-5;
  p.friction.coulomb = 0.017;
  return p;
}

int steps(double seconds) {
  return static_cast<int>(std::lround(seconds / step_s));
}

bool near(double found, double expected, double relative) {
  const bool ok = std::abs(found - expected) <= relative * std::abs(expected);
  if (!ok) qWarning("found %.9g, expected %.9g", found, expected);
  return ok;
}

/// Moments until it stands, s; at most 5.
double stopTime(TrialPlant& plant) {
  while (!plant.standing() && plant.time_s() < 5.0) plant.advance(0.0, 1);
  return plant.time_s();
}

}  // namespace

void TestTrialPlant::coastingOnCoulombAlone_stopsAtTheClosedFormsAngle() {
  TrialPlant plant(plain(), step_s, 1);
  plant.set(0.3, 40.0, 0.0);
  plant.advance(0.0, steps(1.0));
  QVERIFY(plant.standing());
  QVERIFY(near(plant.position() - 0.3, 6e-5 * 40.0 * 40.0 / (2.0 * 0.017), 1e-9));
}

void TestTrialPlant::coastingOnViscousAndCoulomb_stopsAtTheClosedFormsTime() {
  TrialPhysics p = plain();
  p.friction.viscous = 4e-4;
  TrialPlant plant(p, step_s, 1);
  plant.set(0.0, 40.0, 0.0);
  QVERIFY(near(stopTime(plant), 6e-5 / 4e-4 * std::log(1.0 + 4e-4 * 40.0 / 0.017), 1e-3));
}

void TestTrialPlant::windingsUnderAStep_followTheClosedForm() {
  TrialPhysics p = plain();
  p.electrical = true;
  p.friction.coulomb = 100.0;  // the rotor is held
  TrialPlant plant(p, step_s, 1);
  plant.advance(6.0, steps(1.5e-3));
  QVERIFY(near(plant.current(), 5.0 * (1.0 - std::exp(-1.2)), 1e-4));
}

void TestTrialPlant::belowItsFriction_itStandsExactlyStill() {
  TrialPhysics p = plain();
  p.cogging = {0.003, 7.0, 0.4};
  TrialPlant plant(p, step_s, 1);
  plant.set(1.234567, 0.0, 0.0);
  plant.advance(0.0135, steps(2.0));
  QVERIFY(plant.position() == 1.234567 && plant.standing());
  plant.advance(0.021, steps(0.05));
  QVERIFY(plant.position() > 1.24 && !plant.standing());
}

void TestTrialPlant::longerRest_needsMoreTorqueToBreakAway() {
  TrialPhysics p = plain();
  p.friction.restExcess = 0.01;
  p.friction.restTime_s = 0.5;
  for (const double rest_s : {0.1, 0.5, 3.0}) {
    TrialPlant plant(p, step_s, 1);
    plant.advance(0.0, steps(rest_s));
    double torque = 0.0;
    while (plant.standing() && torque < 0.05) plant.advance(torque += 1e-4, 1);
    QVERIFY(near(torque, 0.017 + 0.01 * (1.0 - std::exp(-rest_s / 0.5)), 0.01));
  }
}

void TestTrialPlant::bristles_giveWayByTorqueOverStiffness() {
  TrialPhysics p = plain();
  p.friction.stiffness = 0.5;
  p.friction.damping = 2.0 * std::sqrt(0.5 * p.inertia);
  TrialPlant plant(p, step_s, 1);
  for (int k = 0; k < steps(2.0); ++k) plant.advance(0.004 * std::min(1.0, k * step_s), 1);
  // LuGre's bristle yields ln(1/(1 − f/C)) C/σ0 on a monotone way to f.
  QVERIFY(near(plant.position(), -0.017 / 0.5 * std::log(1.0 - 0.004 / 0.017), 0.02));
}

void TestTrialPlant::heldLoad_swallowsTheAntiresonance() {
  TrialPhysics p = plain();
  p.friction.coulomb = 0.0;
  p.loadInertia = 4e-5;
  const double antiresonance_Hz = 30.0;
  p.shaftStiffness = std::pow(turn * antiresonance_Hz, 2.0) * p.loadInertia;
  p.shaftDamping = 1e-4;
  std::vector<double> swings;
  const std::vector<double> rates{20.0, 25.0, 28.0, 30.0, 32.0, 35.0};
  for (const double rate_Hz : rates) {
    TrialPlant plant(p, step_s, 1);
    double swing = 0.0;
    for (int k = 0; k < steps(4.0); ++k) {
      plant.advance(0.01 * std::cos(turn * rate_Hz * k * step_s), 1);
      if (k > steps(3.0)) swing = std::max(swing, std::abs(plant.velocity()));
    }
    swings.push_back(swing * rate_Hz);
  }
  QCOMPARE(rates[static_cast<size_t>(std::min_element(swings.begin(), swings.end()) - swings.begin())], 30.0);
}

void TestTrialPlant::backlash_letsTheMotorMoveItsGapAlone() {
  TrialPhysics p = plain();
  p.loadInertia = 4e-5;
  p.shaftStiffness = 20.0;
  p.shaftDamping = 0.005;
  p.gap = 0.05;
  TrialPlant plant(p, step_s, 1);
  plant.set(0.0, 0.0, 0.0);
  while (plant.position() < 0.0249 && plant.time_s() < 1.0) plant.advance(0.02, 1);
  QVERIFY(plant.loadPosition() == 0.0);
  plant.advance(0.02, steps(0.3));
  QVERIFY(plant.loadPosition() > 0.1);
  QVERIFY(std::abs(plant.position() - plant.loadPosition()) < 0.5 * 0.05 + 0.005);
}

void TestTrialPlant::delayedInput_actsThatMuchLater() {
  TrialPhysics p = plain();
  p.delay_s = 3.3e-3;
  TrialPlant plant(p, step_s, 1);
  while (plant.standing() && plant.time_s() < 1.0) plant.advance(0.03, 1);
  QVERIFY(std::abs(plant.time_s() - 3.3e-3) < 2.5 * step_s);
}

void TestTrialPlant::hotWinding_settlesAtTheRiseOfItsLoss() {
  TrialPhysics p = plain();
  p.electrical = true;
  p.friction.coulomb = 100.0;
  p.heatingPerJoule = 0.01;
  p.heatingTime_s = 2.0;
  TrialPlant plant(p, step_s, 1);
  plant.advance(3.6, steps(30.0));
  // R = R0 (1 + a T v²/R), hence R² − R0 R − R0 a T v² = 0.
  const double hot = 0.6 + std::sqrt(0.36 + 1.2 * 0.01 * 2.0 * 3.6 * 3.6);
  QVERIFY(near(plant.current(), 3.6 / hot, 1e-3));
}

void TestTrialPlant::endStop_holdsAgainstTheDrive() {
  TrialPhysics p = plain();
  p.stops = true;
  p.lowStop = -1.0;
  p.highStop = 2.0;
  p.stopStiffness = 1.5;
  p.stopDamping = 0.01;
  TrialPlant plant(p, step_s, 1);
  plant.advance(0.08, steps(3.0));
  QVERIFY(plant.standing());
  QVERIFY(plant.position() > 2.0 && plant.position() < 2.0 + (0.08 + 0.017) / 1.5);
}

QTEST_APPLESS_MAIN(TestTrialPlant)
#include "tst_trial_plant.moc"
