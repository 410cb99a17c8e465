// What a simulated rig's coupling does, against closed forms; and the stops of a linear axis.
#include <QTest>
#include <cmath>
#include <numbers>

#include "plant/plant.h"
#include "support/linear_rig.h"

using namespace breakaway;

class TestCoupling : public QObject {
  Q_OBJECT
 private slots:
  void motorAndLoad_swingAtTheFormulasFrequency();
  void momentum_isKeptThroughTheCoupling();
  void play_passesNothingOnInsideTheGap();
  void wrongCouplings_areRefusedByField_data();
  void wrongCouplings_areRefusedByField();
  void stops_holdTheAxisAndGiveTheirEnergyBackButForTheDamper();
};

namespace {

/// Without friction, on one shaft with what turns behind the coupling.
Rig freeRig(double gap_rad = 0.0) {
  Rig rig;
  rig.torqueConstant_Nm_per_A = rig.backEmfConstant_V_s_per_rad = 0.07;
  rig.resistance_ohm = 1.2;
  rig.inductance_H = 0.0011;
  rig.inertia_kg_m2 = 6e-5;
  rig.stribeckVelocity_rad_per_s = 1.5;
  rig.encoder.countsPerRev = 4096;
  rig.bridge.supply_V = 24.0;
  rig.coupling = {40.0, 0.0, 4e-5, gap_rad};
  return rig;
}

/// Sped up by voltage, then left to itself.
Plant spunPlant(const Rig& rig) {
  Plant plant(rig, coarsestStep_s(rig), 1);
  plant.applyVoltage(2.0);
  plant.advance(static_cast<int>(0.01 / coarsestStep_s(rig)));
  plant.openWindings();
  return plant;
}

double momentum(const Plant& plant, const Rig& rig) {
  return rig.inertia_kg_m2 * plant.velocity_rad_per_s() +
         rig.coupling.loadInertia_kg_m2 * plant.loadVelocity_rad_per_s();
}

}  // namespace

void TestCoupling::motorAndLoad_swingAtTheFormulasFrequency() {
  const Rig rig = freeRig();
  Plant plant = spunPlant(rig);
  // Two frequencies' worth of zero crossings of the slip, interpolated within the step.
  double before = plant.velocity_rad_per_s() - plant.loadVelocity_rad_per_s(), first_s = -1.0, last_s = -1.0;
  int swings = 0;
  while (swings < 400) {
    const double then_s = plant.time_s();
    plant.advance(1);
    const double slip = plant.velocity_rad_per_s() - plant.loadVelocity_rad_per_s();
    if (before < 0.0 && slip >= 0.0) {
      last_s = then_s + (plant.time_s() - then_s) * before / (before - slip);
      if (first_s < 0.0) first_s = last_s;
      ++swings;
    }
    before = slip;
    QVERIFY(plant.time_s() < 10.0);
  }
  const double measured = 2.0 * std::numbers::pi * (swings - 1) / (last_s - first_s);
  const double formula = std::sqrt(40.0 * (1.0 / 6e-5 + 1.0 / 4e-5));
  QVERIFY2(std::abs(measured / formula - 1.0) < 1e-4, qPrintable(QString::number(measured / formula - 1.0)));
}

void TestCoupling::momentum_isKeptThroughTheCoupling() {
  for (const double gap_rad : {0.0, 0.01}) {
    Rig rig = freeRig(gap_rad);
    rig.coupling.damping_Nm_s_per_rad = 2e-3;
    Plant plant = spunPlant(rig);
    const double begin = momentum(plant, rig);
    QVERIFY(std::abs(begin) > 1e-5);
    plant.advance(20000);
    QVERIFY2(std::abs(momentum(plant, rig) / begin - 1.0) < 1e-9,
             qPrintable(QString::number(momentum(plant, rig) / begin - 1.0)));
    // The damper has brought both to one speed where nothing but it and the spring is between them.
    if (gap_rad == 0.0) QVERIFY(std::abs(plant.loadVelocity_rad_per_s() / plant.velocity_rad_per_s() - 1.0) < 1e-6);
  }
}

void TestCoupling::play_passesNothingOnInsideTheGap() {
  const Rig rig = freeRig(0.2);
  Plant plant(rig, coarsestStep_s(rig), 1);
  plant.applyVoltage(1.0);
  while (plant.angle_rad() < 0.0999) {
    QCOMPARE(plant.loadVelocity_rad_per_s(), 0.0);
    QCOMPARE(plant.encoderAngle_rad(), 0.0);
    plant.advance(1);
  }
  plant.advance(static_cast<int>(0.02 / coarsestStep_s(rig)));
  QVERIFY(plant.loadVelocity_rad_per_s() > 0.0);
}

void TestCoupling::wrongCouplings_areRefusedByField_data() {
  QTest::addColumn<QString>("coupling");
  QTest::addColumn<QString>("words");
  const auto row = [](const char* name, const char* coupling, const char* words) {
    QTest::newRow(name) << QString(coupling) << QString(words);
  };
  row("no stiffness", R"({"load_mass_kg": 1})", "coupling.stiffness_N_per_m");
  row("no load", R"({"stiffness_N_per_m": 1e5})", "coupling.load_mass_kg");
  row("a rotor's name", R"({"stiffness_Nm_per_rad": 1, "load_mass_kg": 1})", "coupling.stiffness_N_per_m");
  row("too stiff", R"({"stiffness_N_per_m": 1e12, "load_mass_kg": 1})", "expected at most 30000");
  row("no swing", R"({"stiffness_N_per_m": 1e5, "load_mass_kg": 1, "damping_N_s_per_m": 1e6})", "critical");
  row("negative play", R"({"stiffness_N_per_m": 1e5, "load_mass_kg": 1, "gap_m": -1})", "coupling.gap_m");
}

void TestCoupling::wrongCouplings_areRefusedByField() {
  QFETCH(QString, coupling);
  QFETCH(QString, words);
  test::LinearAxis axis;
  axis.more = ", \"coupling\": " + coupling.toStdString();
  const auto rig = readRigText(test::linearRigText(axis, 1), "a.rig.json");
  QVERIFY(!rig);
  QVERIFY2(rig.error().message().find(words.toStdString()) != std::string::npos, rig.error().message().c_str());
}

void TestCoupling::stops_holdTheAxisAndGiveTheirEnergyBackButForTheDamper() {
  test::LinearAxis axis;
  axis.coulomb_N = 1e-6;
  const auto rig = readRigText(test::linearRigText(axis, 1), "a.rig.json");
  QVERIFY2(rig.ok(), rig ? "" : rig.error().message().c_str());
  Plant plant(*rig, 50e-6, 1);
  plant.applyVoltage(6.0);
  double fastest = 0.0;
  while (plant.angle_rad() < 2.0 * std::numbers::pi) {
    fastest = plant.velocity_rad_per_s();
    plant.advance(1);
  }
  plant.openWindings();
  while (plant.angle_rad() > 2.0 * std::numbers::pi) plant.advance(1);
  // A damper of ζ = 0.3 in a half swing that may only push: e = exp(−ζ·(π − acos(2ζ² − 1)…)) lies between these.
  const double back = -plant.velocity_rad_per_s() / fastest;
  QVERIFY2(back > 0.3 && back < 0.7, qPrintable(QString::number(back)));
  plant.applyVoltage(24.0);
  plant.advance(200000);
  const double beyond_m = (plant.angle_rad() - 2.0 * std::numbers::pi) * rig->unitPerRad();
  // Pressed with K·V/R against k = m·10⁶ N/m.
  QVERIFY2(std::abs(beyond_m / (14.0 * 24.0 / 2.2 / 1.8e6) - 1.0) < 1e-3, qPrintable(QString::number(beyond_m)));
}

QTEST_APPLESS_MAIN(TestCoupling)
#include "tst_coupling.moc"
