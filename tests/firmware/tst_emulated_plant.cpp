#include <QTest>
#include <cmath>
#include <numbers>

#include "firmware_link/board/cortex_m3/emulated_plant.h"
#include "firmware_link/board/cortex_m3/emulated_sensors.h"
#include "firmware_link/board/cortex_m3/gaussian_table.h"
#include "firmware_link/board/cortex_m3/host/rig_tables.h"
#include "plant/plant.h"
#include "plant/sensors.h"

using namespace breakaway;

class TestEmulatedPlant : public QObject {
  Q_OBJECT
 private slots:
  void spinUpAndCoast_goAsThePlantInDoublePrecision();
  void steadySpeed_solvesTheTorqueBalance();
  void breakaway_comesWhereTheTablesSay_data();
  void breakaway_comesWhereTheTablesSay();
  void scatter_hasTheRmsAskedFor();
  void noise_isNormalEnough();
  void gaussianFall_isTheExponential();
  void encoder_countsAsTheHostsModel();
  void sensor_hasTheHostsStepsAndRange();
  void bridge_hasItsDeadZone();
  void whatItCannotCarry_isRefused();
};

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

Rig servo() {
  const auto rig = readRig(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/servo.rig.json");
  Q_ASSERT(rig);
  return *rig;
}

double radOf(const EmulatedPlant& plant) {
  return static_cast<double>(plant.angle_q36()) * 0x1p-36 * turn;
}

}  // namespace

void TestEmulatedPlant::spinUpAndCoast_goAsThePlantInDoublePrecision() {
  Rig rig = servo();
  rig.scatterRms = 0.0;
  const auto tables = rigTables(rig);
  QVERIFY(tables);
  EmulatedPlant emulated(tables->rig, 1);
  Plant plant(rig, 50e-6, 1);
  QVERIFY(std::abs(radOf(emulated) - plant.angle_rad()) < 1e-9);
  // A ramp through breakaway, a steady run, a reversal, then open windings until it rests.
  for (int tick = 0; tick < 15000; ++tick) {
    const double time_s = tick / 5000.0;
    const double voltage_V = time_s < 1.0 ? 3.0 * time_s : time_s < 1.5 ? 3.0 : -2.0;
    if (time_s < 2.0) {
      emulated.applyVoltage(static_cast<float>(voltage_V));
      plant.applyVoltage(voltage_V);
    } else {
      emulated.openWindings();
      plant.openWindings();
    }
    emulated.advance();
    plant.advance(4);
    const QString place = QString("at %1 s").arg(time_s);
    QVERIFY2(std::abs(static_cast<double>(emulated.velocity_rad_per_s()) - plant.velocity_rad_per_s()) < 0.05,
             qPrintable(place + QString(": %1 against %2 rad/s")
                                    .arg(static_cast<double>(emulated.velocity_rad_per_s()))
                                    .arg(plant.velocity_rad_per_s())));
    QVERIFY2(std::abs(static_cast<double>(emulated.current_A()) - plant.current_A()) < 0.003, qPrintable(place));
  }
  QVERIFY(emulated.standing() && plant.standing());
  QVERIFY2(std::abs(radOf(emulated) - plant.angle_rad()) < 0.01,
           qPrintable(QString("%1 against %2 rad").arg(radOf(emulated)).arg(plant.angle_rad())));
}

void TestEmulatedPlant::steadySpeed_solvesTheTorqueBalance() {
  Rig rig = servo();
  rig.positionTorque_Nm.clear();
  for (size_t way = 0; way < 2; ++way) {
    rig.coulomb_Nm[way].harmonics.clear();
    rig.viscous_Nm_s_per_rad[way].harmonics.clear();
  }
  const auto tables = rigTables(rig);
  EmulatedPlant plant(tables->rig, 1);
  plant.applyVoltage(4.0f);
  for (int tick = 0; tick < 15000; ++tick) plant.advance();
  // V = R·i + Ke·ω, Kt·i = C + B·ω.
  const double B = rig.viscous_Nm_s_per_rad[1].mean, C = rig.coulomb_Nm[1].mean;
  const double k = rig.torqueConstant_Nm_per_A, R = rig.resistance_ohm;
  const double speed = (4.0 - R * C / k) / (k + R * B / k);
  QVERIFY2(std::abs(static_cast<double>(plant.velocity_rad_per_s()) / speed - 1.0) < 2e-5,
           qPrintable(QString::number(static_cast<double>(plant.velocity_rad_per_s()) / speed - 1.0)));
}

void TestEmulatedPlant::breakaway_comesWhereTheTablesSay_data() {
  QTest::addColumn<double>("start_rad");
  QTest::addColumn<int>("way");
  for (const double start_rad : {0.3, 2.0, 5.5}) {
    for (const int way : {0, 1}) QTest::addRow("from %g rad, way %d", start_rad, way) << start_rad << way;
  }
}

void TestEmulatedPlant::breakaway_comesWhereTheTablesSay() {
  QFETCH(double, start_rad);
  QFETCH(int, way);
  Rig rig = servo();
  rig.scatterRms = 0.0;
  rig.encoder.indexAngle_rad = -start_rad;
  const auto tables = rigTables(rig);
  EmulatedPlant plant(tables->rig, 1);
  const double sign = way == 0 ? -1.0 : 1.0;
  double voltage_V = 0.0;
  for (; plant.standing() && voltage_V < 2.0; voltage_V += 2e-5) {
    plant.applyVoltage(static_cast<float>(sign * voltage_V));
    plant.advance();
  }
  QVERIFY(!plant.standing());
  const AngleTorques torques = torquesAt(physicsOf(rig), start_rad);
  const double truth_Nm = torques.static_Nm[static_cast<size_t>(way)] - sign * torques.position_Nm;
  const double seen_Nm = rig.torqueConstant_Nm_per_A * voltage_V / rig.resistance_ohm;
  QVERIFY2(std::abs(seen_Nm / truth_Nm - 1.0) < 2e-3,
           qPrintable(QString("%1 against %2 Nm").arg(seen_Nm).arg(truth_Nm)));
}

void TestEmulatedPlant::scatter_hasTheRmsAskedFor() {
  Rig rig = servo();
  rig.scatterRms = 0.02;
  rig.positionTorque_Nm.clear();
  for (size_t way = 0; way < 2; ++way) rig.staticFriction_Nm[way].harmonics.clear();
  const auto tables = rigTables(rig);
  EmulatedPlant plant(tables->rig, 7);
  double sum = 0.0, squares = 0.0;
  constexpr int breakaways = 200;
  for (int k = 0; k < breakaways; ++k) {
    float voltage_V = 0.30f;
    for (; plant.standing() || voltage_V < 0.301f; voltage_V += 2e-4f) {
      plant.applyVoltage(voltage_V);
      plant.advance();
    }
    const double torque_Nm = rig.torqueConstant_Nm_per_A * static_cast<double>(plant.current_A());
    sum += torque_Nm;
    squares += torque_Nm * torque_Nm;
    for (int tick = 0; tick < 50; ++tick) plant.advance();  // far enough for another standstill
    plant.openWindings();
    while (!plant.standing()) plant.advance();
  }
  const double mean = sum / breakaways;
  const double rms = std::sqrt(squares / breakaways - mean * mean) / rig.staticFriction_Nm[1].mean;
  QVERIFY2(rms > 0.016 && rms < 0.024, qPrintable(QString::number(rms)));
}

void TestEmulatedPlant::noise_isNormalEnough() {
  EmulatedNoise noise(3);
  constexpr int count = 200000;
  double sum = 0.0, squares = 0.0, fourths = 0.0, product = 0.0, before = 0.0;
  for (int k = 0; k < count; ++k) {
    const double x = static_cast<double>(noise.normal());
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
    product += x * before;
    before = x;
  }
  QVERIFY(std::abs(sum / count) < 0.01);
  QVERIFY2(std::abs(squares / count - 1.0) < 0.015, qPrintable(QString::number(squares / count)));
  QVERIFY2(std::abs(fourths / count - 2.85) < 0.06, qPrintable(QString::number(fourths / count)));
  QVERIFY(std::abs(product / count) < 0.01);
}

void TestEmulatedPlant::gaussianFall_isTheExponential() {
  for (double x = 0.0; x < 8.0; x += 0.0137) {
    QVERIFY(std::abs(static_cast<double>(gaussianFall(static_cast<float>(x))) - std::exp(-x * x)) < 1e-5);
  }
}

void TestEmulatedPlant::encoder_countsAsTheHostsModel() {
  const Rig rig = servo();
  const auto tables = rigTables(rig);
  EmulatedEncoder emulated(tables->rig);
  EncoderModel encoder(rig);
  int seen = 0, differing = 0;
  for (int k = 0; k < 40000; ++k) {
    const double angle_rad = -rig.encoder.indexAngle_rad + 0.01 * k * (k < 20000 ? 1 : -1) + (k < 20000 ? 0 : 400.0);
    const auto mine = emulated.read(std::llround(angle_rad / turn * 0x1p36));
    const auto host = encoder.read(angle_rad);
    differing += mine.count != host.count;
    QVERIFY(std::abs(mine.count - host.count) <= 1);
    QVERIFY(mine.index == host.index);
    seen += mine.index;
  }
  QVERIFY2(differing <= 2, qPrintable(QString::number(differing)));  // on a count's very edge
  QVERIFY(seen > 60);
}

void TestEmulatedPlant::sensor_hasTheHostsStepsAndRange() {
  Rig rig = servo();
  rig.currentSensor.noiseRms_A = 0.0;
  const auto tables = rigTables(rig);
  EmulatedCurrentSensor emulated(tables->rig, 1);
  CurrentSensorModel sensor(rig, 1);
  const double step_A = rig.currentSensor.adcRange_V / 4096.0 / rig.currentSensor.sensitivity_V_per_A;
  for (double current_A = -16.0; current_A < 16.0; current_A += 0.0137) {
    const double mine_A = static_cast<double>(emulated.current_A(emulated.code(static_cast<float>(current_A), 10.0f)));
    QVERIFY2(std::abs(mine_A - sensor.read(current_A, 10.0)) < 1.001 * step_A, qPrintable(QString::number(current_A)));
  }
}

void TestEmulatedPlant::bridge_hasItsDeadZone() {
  const Rig rig = servo();
  const auto tables = rigTables(rig);
  const EmulatedBridge bridge(tables->rig);
  QVERIFY(bridge.voltage_V(0.009f) == 0.0f);
  QVERIFY(std::abs(bridge.voltage_V(-0.11f) + 2.4f) < 1e-5f);
}

void TestEmulatedPlant::whatItCannotCarry_isRefused() {
  Rig rig = servo();
  rig.effects.push_back({"friction_warmup", {{"share", 0.2}, {"time_constant_s", 60.0}}});
  const auto tables = rigTables(rig);
  QVERIFY(!tables);
  QVERIFY(tables.error().fact.find("friction_warmup") != std::string::npos);
  Rig faulty = servo();
  faulty.faults.emplace_back();
  QVERIFY(!rigTables(faulty));
}

QTEST_GUILESS_MAIN(TestEmulatedPlant)
#include "tst_emulated_plant.moc"
