// What can be concealed in a plant, each effect against its closed form.
#include <QTest>
#include <cmath>
#include <numbers>
#include <vector>

#include "plant/plant.h"

using namespace breakaway;

class TestConcealed : public QObject {
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

void setCoulomb(PlantPhysics& p, double coulomb) {
  for (size_t way = 0; way < 2; ++way) p.coulomb[way].mean = p.holding[way].mean = coulomb;
}

PlantPhysics plain() {
  PlantPhysics p;
  p.electrical = false;
  p.torqueConstant = p.backEmfConstant = 0.07;
  p.resistance_ohm = 1.2;
  p.inductance_H = 1.5e-3;
  p.inertia = 6e-5;
  setCoulomb(p, 0.017);
  p.sameStand_rad = 0.0;
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

void run(Plant& plant, double input, int count) {
  plant.apply(input);
  plant.advance(count);
}

/// Moments until it stands, s; at most 5.
double stopTime(Plant& plant) {
  while (!plant.standing() && plant.time_s() < 5.0) run(plant, 0.0, 1);
  return plant.time_s();
}

}  // namespace

void TestConcealed::coastingOnCoulombAlone_stopsAtTheClosedFormsAngle() {
  Plant plant(plain(), step_s, 1);
  plant.set(0.3, 40.0, 0.0);
  run(plant, 0.0, steps(1.0));
  QVERIFY(plant.standing());
  QVERIFY(near(plant.angle_rad() - 0.3, 6e-5 * 40.0 * 40.0 / (2.0 * 0.017), 1e-9));
}

void TestConcealed::coastingOnViscousAndCoulomb_stopsAtTheClosedFormsTime() {
  PlantPhysics p = plain();
  p.viscous[0].mean = p.viscous[1].mean = 4e-4;
  Plant plant(p, step_s, 1);
  plant.set(0.0, 40.0, 0.0);
  QVERIFY(near(stopTime(plant), 6e-5 / 4e-4 * std::log(1.0 + 4e-4 * 40.0 / 0.017), 1e-3));
}

void TestConcealed::windingsUnderAStep_followTheClosedForm() {
  PlantPhysics p = plain();
  p.electrical = true;
  setCoulomb(p, 100.0);  // the rotor is held
  Plant plant(p, step_s, 1);
  run(plant, 6.0, steps(1.5e-3));
  QVERIFY(near(plant.current_A(), 5.0 * (1.0 - std::exp(-1.2)), 1e-4));
}

void TestConcealed::belowItsFriction_itStandsExactlyStill() {
  PlantPhysics p = plain();
  p.position = {{7.0, 0.003, 0.4}};
  Plant plant(p, step_s, 1);
  plant.set(1.234567, 0.0, 0.0);
  run(plant, 0.0135, steps(2.0));
  QVERIFY(plant.angle_rad() == 1.234567 && plant.standing());
  run(plant, 0.021, steps(0.05));
  QVERIFY(plant.angle_rad() > 1.24 && !plant.standing());
}

void TestConcealed::longerRest_needsMoreTorqueToBreakAway() {
  PlantPhysics p = plain();
  p.rest.excess = 0.01;
  p.rest.time_s = 0.5;
  for (const double rest_s : {0.1, 0.5, 3.0}) {
    Plant plant(p, step_s, 1);
    run(plant, 0.0, steps(rest_s));
    double torque = 0.0;
    while (plant.standing() && torque < 0.05) run(plant, torque += 1e-4, 1);
    QVERIFY(near(torque, 0.017 + 0.01 * (1.0 - std::exp(-rest_s / 0.5)), 0.01));
  }
}

void TestConcealed::bristles_giveWayByTorqueOverStiffness() {
  PlantPhysics p = plain();
  p.bristles.stiffness = 0.5;
  p.bristles.damping = 2.0 * std::sqrt(0.5 * p.inertia);
  Plant plant(p, step_s, 1);
  for (int k = 0; k < steps(2.0); ++k) run(plant, 0.004 * std::min(1.0, k * step_s), 1);
  // LuGre's bristle yields ln(1/(1 − f/C)) C/σ0 on a monotone way to f.
  QVERIFY(near(plant.angle_rad(), -0.017 / 0.5 * std::log(1.0 - 0.004 / 0.017), 0.02));
}

void TestConcealed::heldLoad_swallowsTheAntiresonance() {
  PlantPhysics p = plain();
  setCoulomb(p, 0.0);
  p.coupling.loadInertia_kg_m2 = 4e-5;
  const double antiresonance_Hz = 30.0;
  p.coupling.stiffness_Nm_per_rad = std::pow(turn * antiresonance_Hz, 2.0) * p.coupling.loadInertia_kg_m2;
  p.coupling.damping_Nm_s_per_rad = 1e-4;
  std::vector<double> swings;
  const std::vector<double> rates{20.0, 25.0, 28.0, 30.0, 32.0, 35.0};
  for (const double rate_Hz : rates) {
    Plant plant(p, step_s, 1);
    double swing = 0.0;
    for (int k = 0; k < steps(4.0); ++k) {
      run(plant, 0.01 * std::cos(turn * rate_Hz * k * step_s), 1);
      if (k > steps(3.0)) swing = std::max(swing, std::abs(plant.velocity_rad_per_s()));
    }
    swings.push_back(swing * rate_Hz);
  }
  QCOMPARE(rates[static_cast<size_t>(std::min_element(swings.begin(), swings.end()) - swings.begin())], 30.0);
}

void TestConcealed::backlash_letsTheMotorMoveItsGapAlone() {
  PlantPhysics p = plain();
  p.coupling.loadInertia_kg_m2 = 4e-5;
  p.coupling.stiffness_Nm_per_rad = 20.0;
  p.coupling.damping_Nm_s_per_rad = 0.005;
  p.coupling.gap_rad = 0.05;
  Plant plant(p, step_s, 1);
  plant.set(0.0, 0.0, 0.0);
  while (plant.angle_rad() < 0.0249 && plant.time_s() < 1.0) run(plant, 0.02, 1);
  QVERIFY(plant.encoderAngle_rad() == 0.0);
  run(plant, 0.02, steps(0.3));
  QVERIFY(plant.encoderAngle_rad() > 0.1);
  QVERIFY(std::abs(plant.angle_rad() - plant.encoderAngle_rad()) < 0.5 * 0.05 + 0.005);
}

void TestConcealed::delayedInput_actsThatMuchLater() {
  PlantPhysics p = plain();
  p.delay_s = 3.3e-3;
  Plant plant(p, step_s, 1);
  while (plant.standing() && plant.time_s() < 1.0) run(plant, 0.03, 1);
  QVERIFY(std::abs(plant.time_s() - 3.3e-3) < 2.5 * step_s);
}

void TestConcealed::hotWinding_settlesAtTheRiseOfItsLoss() {
  PlantPhysics p = plain();
  p.electrical = true;
  setCoulomb(p, 100.0);
  p.heatingPerJoule = 0.01;
  p.heatingTime_s = 2.0;
  Plant plant(p, step_s, 1);
  run(plant, 3.6, steps(30.0));
  // R = R0 (1 + a T v²/R), hence R² − R0 R − R0 a T v² = 0.
  const double hot = 0.6 + std::sqrt(0.36 + 1.2 * 0.01 * 2.0 * 3.6 * 3.6);
  QVERIFY(near(plant.current_A(), 3.6 / hot, 1e-3));
}

void TestConcealed::endStop_holdsAgainstTheDrive() {
  PlantPhysics p = plain();
  p.stops.present = true;
  p.stops.low_rad = -1.0;
  p.stops.high_rad = 2.0;
  p.stops.stiffness = 1.5;
  p.stops.damping = 0.01;
  Plant plant(p, step_s, 1);
  run(plant, 0.08, steps(3.0));
  QVERIFY(plant.standing());
  QVERIFY(plant.angle_rad() > 2.0 && plant.angle_rad() < 2.0 + (0.08 + 0.017) / 1.5);
}

QTEST_APPLESS_MAIN(TestConcealed)
#include "tst_concealed.moc"
