#include <QTest>
#include <cmath>
#include <numbers>

#include "plant/plant.h"
#include "plant/sensors.h"

using namespace breakaway;

class TestPlant : public QObject {
  Q_OBJECT
 private slots:
  void slipOfAHair_isTheSameStandstill();
  void belowStaticFriction_itStandsExactlyStill();
  void breakaway_comesAtTheClosedFormsMoment();
  void coastingOnCoulombAlone_stopsAtTheClosedFormsAngle();
  void steadySpeed_solvesTheTorqueBalance();
  void stopThatComesBehindTheRotor_isMetInTheNextTurn();
  void halvedSteps_changeTheStoppingAngleLittle();
  void positionTorqueBeyondFriction_rollsIntoItsValley();
  void scatter_hasTheRmsAskedFor();
  void propagator_composesWithItself();
  void encoder_roundsDownAndSeesTheIndexOnce();
  void bridge_deadZoneAndMeanOfSteps();
};

namespace {

Rig plainRig() {
  Rig rig;
  rig.torqueConstant_Nm_per_A = rig.backEmfConstant_V_s_per_rad = 0.07;
  rig.resistance_ohm = 1.2;
  rig.inductance_H = 0.0011;
  rig.inertia_kg_m2 = 6e-5;
  for (size_t way = 0; way < 2; ++way) {
    rig.staticFriction_Nm[way].mean = 0.021;
    rig.coulomb_Nm[way].mean = 0.017;
    rig.viscous_Nm_s_per_rad[way].mean = 2e-5;
  }
  rig.stribeckVelocity_rad_per_s = 1.5;
  rig.encoder.countsPerRev = 4096;
  rig.bridge.supply_V = 24.0;
  return rig;
}

/// Sped up by voltage for 0.2 s, then the windings are opened until it rests; returns the coasting angle and its first
/// speed.
std::pair<double, double> coast(const Rig& rig, double substep_s) {
  Plant plant(rig, substep_s, 1);
  plant.applyVoltage(6.0);
  plant.advance(static_cast<int>(std::lround(0.2 / substep_s)));
  const double angle = plant.angle_rad(), speed = plant.velocity_rad_per_s();
  plant.openWindings();
  plant.advance(static_cast<int>(std::lround(5.0 / substep_s)));
  return {plant.standing() ? plant.angle_rad() - angle : NAN, speed};
}

}  // namespace

void TestPlant::belowStaticFriction_itStandsExactlyStill() {
  Plant plant(plainRig(), 50e-6, 1);
  plant.applyVoltage(0.99 * 0.021 / 0.07 * 1.2);
  const double angle = plant.angle_rad();
  plant.advance(200000);
  QVERIFY(plant.standing());
  QCOMPARE(plant.angle_rad(), angle);
  QCOMPARE(plant.velocity_rad_per_s(), 0.0);
}

void TestPlant::breakaway_comesAtTheClosedFormsMoment() {
  // i(t) = v/R·(1 − e^(−Rt/L)) reaches F/Kt = 0.3 A at t = −L/R·ln(1 − 0.3·R/v).
  const double v = 0.5, R = 1.2, L = 0.0011, moment = -L / R * std::log(1.0 - 0.3 * R / v);
  Plant coarse(plainRig(), 50e-6, 1), fine(plainRig(), moment * (1.0 - 1e-5), 1),
      after(plainRig(), moment * (1.0 + 1e-5), 1);
  for (Plant* plant : {&coarse, &fine, &after}) plant->applyVoltage(v);
  fine.advance(1);
  after.advance(1);
  QVERIFY(fine.standing());
  QVERIFY(!after.standing());
  coarse.advance(static_cast<int>(moment / 50e-6));
  QVERIFY(coarse.standing());
  coarse.advance(1);
  QVERIFY(!coarse.standing());
}

void TestPlant::coastingOnCoulombAlone_stopsAtTheClosedFormsAngle() {
  Rig rig = plainRig();
  for (size_t way = 0; way < 2; ++way) {
    rig.staticFriction_Nm[way].mean = rig.coulomb_Nm[way].mean;
    rig.viscous_Nm_s_per_rad[way].mean = 0.0;
  }
  const auto [angle, speed] = coast(rig, 50e-6);
  const double expected = rig.inertia_kg_m2 * speed * speed / (2.0 * 0.017);
  QVERIFY2(std::abs(angle / expected - 1.0) < 1e-9, qPrintable(QString::number(angle / expected - 1.0)));
}

void TestPlant::steadySpeed_solvesTheTorqueBalance() {
  Plant plant(plainRig(), 50e-6, 1);
  plant.applyVoltage(12.0);
  plant.advance(100000);
  // v = R·i + Ke·ω, Kt·i = C + B·ω
  const double speed = (12.0 - 1.2 * 0.017 / 0.07) / (0.07 + 1.2 * 2e-5 / 0.07);
  QVERIFY(std::abs(plant.velocity_rad_per_s() / speed - 1.0) < 1e-9);
  QVERIFY(std::abs(plant.current_A() - (0.017 + 2e-5 * speed) / 0.07) < 1e-9);
}

/// Many turns beyond a stop's angle when that comes, a rotor isn't thrown back by all of them.
void TestPlant::stopThatComesBehindTheRotor_isMetInTheNextTurn() {
  for (const double way : {1.0, -1.0}) {
    Rig rig = plainRig();
    RigWiring stop;
    stop.kind = WiringKind::stopAt;
    stop.value = way * 1.0;
    stop.from_s = 0.5;
    rig.wiring = {stop};
    Plant plant(rig, 50e-6, 1);
    const double start = plant.angle_rad();
    plant.applyVoltage(way * 3.0);
    plant.advance(9990);
    const double before = plant.angle_rad(), fastest = std::abs(plant.velocity_rad_per_s());
    QVERIFY(std::abs(before - start) > 10.0);
    for (int k = 0; k < 500; ++k) {
      plant.advance(20);
      QVERIFY(std::abs(plant.velocity_rad_per_s()) < 1.05 * fastest);
    }
    const double turns = way * (plant.angle_rad() - start - way) / (2.0 * std::numbers::pi);
    QVERIFY(std::abs(plant.angle_rad() - before) < 2.0 * std::numbers::pi + 0.1);
    QVERIFY2(std::abs(turns - std::round(turns)) < 0.01, qPrintable(QString::number(turns)));
  }
}

void TestPlant::halvedSteps_changeTheStoppingAngleLittle() {
  Rig rig = plainRig();
  rig.staticFriction_Nm[1].harmonics = {{3, 0.2, 1.0}};
  rig.coulomb_Nm[1].harmonics = {{3, 0.2, 1.0}};
  const double fine = coast(rig, 3.125e-6).first;
  const double a = std::abs(coast(rig, 50e-6).first / fine - 1.0), b = std::abs(coast(rig, 25e-6).first / fine - 1.0);
  QVERIFY2(a < 1e-5, qPrintable(QString::number(a)));
  QVERIFY2(b < 0.5 * a + 1e-8, qPrintable(QString::number(b) + " after " + QString::number(a)));
}

void TestPlant::positionTorqueBeyondFriction_rollsIntoItsValley() {
  Rig rig = plainRig();
  rig.positionTorque_Nm = {{6, 0.1, 0.0}};
  rig.encoder.indexAngle_rad = -0.01;  // starts near the crest of the torque
  Plant plant(rig, 50e-6, 1);
  plant.advance(40000);
  QVERIFY(plant.standing());
  QVERIFY(plant.angle_rad() > 0.1);
  QVERIFY(std::abs(0.1 * std::cos(6.0 * plant.angle_rad())) <= 0.021);
}

void TestPlant::scatter_hasTheRmsAskedFor() {
  Rig rig = plainRig();
  rig.scatterRms = 0.02;
  Plant plant(rig, 50e-6, 5);
  std::vector<double> levels;
  for (int k = 0; k < 400; ++k) {
    double volts = 0.30;
    for (; plant.standing() && volts < 0.5; volts += 2e-4) {
      plant.applyVoltage(volts);
      plant.advance(160);
    }
    levels.push_back(volts);
    plant.applyVoltage(1.0);  // away from here: a slip of less than 0.1 mrad is the same standstill
    plant.advance(400);
    plant.openWindings();
    plant.advance(4000);
    QVERIFY(plant.standing());
  }
  double sum = 0.0, squares = 0.0;
  for (const double level : levels) sum += level / 400.0;
  for (const double level : levels) squares += (level - sum) * (level - sum) / 399.0;
  const double relative = std::sqrt(squares) / sum;
  QVERIFY2(relative > 0.017 && relative < 0.023, qPrintable(QString::number(relative)));
  QVERIFY(std::abs(sum / 0.36 - 1.0) < 0.01);
}

void TestPlant::slipOfAHair_isTheSameStandstill() {
  Rig rig = plainRig();
  rig.scatterRms = 0.1;
  Plant plant(rig, 50e-6, 5);
  std::vector<double> levels;
  // Current in pulses too short to carry it far: it lets go at the same level each time.
  for (int k = 0; k < 5; ++k) {
    double volts = 0.1;
    for (; plant.standing() && volts < 1.0; volts += 2e-4) {
      plant.applyVoltage(volts);
      plant.advance(160);
    }
    levels.push_back(volts);
    plant.openWindings();
    plant.advance(2000);
    QVERIFY(plant.standing());
  }
  size_t same = 0;
  for (size_t k = 1; k < levels.size(); ++k) same += std::abs(levels[k] - levels[0]) < 3e-4 ? 1 : 0;
  QVERIFY2(same >= 1, qPrintable(QString::number(same)));
}

void TestPlant::propagator_composesWithItself() {
  const LinearMotor motor{0.07, 0.07, 1.2, 0.0011, 6e-5, 2e-5};
  const Propagator once = closedWindings(motor, 1e-3), twice = closedWindings(motor, 2e-3);
  for (int r = 0; r < 2; ++r) {
    for (int c = 0; c < 2; ++c) {
      const double composed = once.phi[r][0] * once.phi[0][c] + once.phi[r][1] * once.phi[1][c];
      QVERIFY(std::abs(composed - twice.phi[r][c]) < 1e-12 * (1.0 + std::abs(composed)));
      const double held = once.gamma[r][c] + once.phi[r][0] * once.gamma[0][c] + once.phi[r][1] * once.gamma[1][c];
      QVERIFY(std::abs(held - twice.gamma[r][c]) < 1e-12 * (1.0 + std::abs(held)));
    }
  }
}

void TestPlant::encoder_roundsDownAndSeesTheIndexOnce() {
  Rig rig = plainRig();
  rig.encoder.indexAngle_rad = 0.5;
  EncoderModel encoder(rig);
  const double count = 2.0 * std::numbers::pi / 4096.0;
  QCOMPARE(encoder.read(-0.5).count, int64_t{0});
  QCOMPARE(encoder.read(-0.5 + 2.9 * count).count, int64_t{2});
  QCOMPARE(encoder.read(-0.5 - 0.1 * count).count, int64_t{-1});
  QVERIFY(!encoder.read(-0.001).index);
  QVERIFY(encoder.read(0.001).index);
  QVERIFY(!encoder.read(0.002).index);
}

void TestPlant::bridge_deadZoneAndMeanOfSteps() {
  Rig rig = plainRig();
  rig.bridge.deadZoneDuty = 0.01;
  rig.bridge.pwmSteps = 100;
  BridgeModel bridge(rig);
  QCOMPARE(bridge.voltage(0.005), 0.0);
  QVERIFY(std::abs(bridge.voltage(-0.06) + 24.0 * 0.05) < 1e-12);
  double sum = 0.0;
  for (int k = 0; k < 1000; ++k) sum += bridge.realisable(0.1234);
  QVERIFY(std::abs(sum / 1000.0 - 0.1234) < 1e-5);
}

QTEST_APPLESS_MAIN(TestPlant)
#include "tst_plant.moc"
