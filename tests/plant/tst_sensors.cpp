#include "plant/sensors.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace breakaway;

class TestSensors : public QObject {
  Q_OBJECT
 private slots:
  void soundSensor_showsTheCurrent();
  void sensorOnALowSupply_isOffAndLessSensitive();
  void warmSensor_drifts();
  void eccentricDisc_showsOneSwingPerTurn();
  void unevenQuadrature_repeatsEveryLine();
  void wideIndex_isSeenAtTheEdgeThatComesFirst();
  void bentBridge_givesItsCurve();
};

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

Rig sound() {
  Rig rig;
  rig.encoder.countsPerRev = 4000.0;
  rig.currentSensor.adcBits = 24;
  rig.bridge.supply_V = 24.0;
  return rig;
}

double shown_A(const Rig& rig, double current_A, double time_s) {
  return CurrentSensorModel(rig, 1).read(current_A, time_s);
}

/// Encoder's reading less the angle, in rad, while the shaft turns once.
std::vector<double> errors(const Rig& rig, int steps) {
  EncoderModel encoder(rig);
  std::vector<double> errors;
  for (int k = 0; k <= steps; ++k) {
    const double angle = turn * k / steps;
    errors.push_back(static_cast<double>(encoder.read(angle).count) * turn / rig.encoder.countsPerRev - angle);
  }
  return errors;
}

}  // namespace

void TestSensors::soundSensor_showsTheCurrent() {
  for (const double current : {-3.0, 0.0, 2.0}) QVERIFY(std::abs(shown_A(sound(), current, 500.0) - current) < 1e-5);
}

void TestSensors::sensorOnALowSupply_isOffAndLessSensitive() {
  Rig rig = sound();
  rig.currentSensor.supplyDeviation_V = -0.05;
  const double zero = shown_A(rig, 0.0, 0.0);
  QVERIFY(std::abs(zero - -0.025 / 0.185) < 1e-5);
  QVERIFY(std::abs(shown_A(rig, 2.0, 0.0) - zero - 2.0 * 0.99) < 1e-5);
}

void TestSensors::warmSensor_drifts() {
  Rig rig = sound();
  rig.currentSensor.offset_V_per_degC = -0.00026;
  rig.currentSensor.gain_per_degC = 1e-4;
  rig.currentSensor.temperatureRise_degC = 20.0;
  rig.currentSensor.temperatureTime_s = 100.0;
  QVERIFY(std::abs(shown_A(rig, 0.0, 0.0)) < 1e-5);
  const double warm = 20.0 * (1.0 - std::exp(-1.0));
  QVERIFY(std::abs(shown_A(rig, 0.0, 100.0) - -0.00026 * warm / 0.185) < 1e-5);
  QVERIFY(std::abs(shown_A(rig, 2.0, 100.0) - shown_A(rig, 0.0, 100.0) - 2.0 * (1.0 + 1e-4 * warm)) < 1e-5);
}

void TestSensors::eccentricDisc_showsOneSwingPerTurn() {
  Rig rig = sound();
  rig.encoder.eccentricity_rad = 0.02;
  const std::vector<double> swing = errors(rig, 1000);
  QVERIFY(std::abs(swing[500] - swing[0] - -0.04) < 2.0 * turn / 4000.0);
  QVERIFY(std::abs(swing[1000] - swing[0]) < 2.0 * turn / 4000.0);
  for (const double error : errors(sound(), 1000)) QVERIFY(error <= 1e-12 && error > -1.01 * turn / 4000.0);
}

void TestSensors::unevenQuadrature_repeatsEveryLine() {
  Rig rig = sound();
  rig.encoder.quadratureError_counts = 0.3;
  EncoderModel encoder(rig);
  // Edges of the first two lines, from the time the count changes.
  std::vector<double> edges;
  int64_t before = encoder.read(0.1 * turn / 4000.0).count;
  for (int k = 0; k < 9000; ++k) {
    const double angle = (0.1 + 0.001 * k) * turn / 4000.0;
    const int64_t count = encoder.read(angle).count;
    if (count > before) edges.push_back(0.1 + 0.001 * k);
    before = count;
  }
  QVERIFY(edges.size() >= 8);
  QVERIFY(std::abs((edges[4] - edges[0]) - 4.0) < 0.01);
  QVERIFY(std::abs((edges[1] - edges[0]) - 1.0) > 0.05);
}

void TestSensors::wideIndex_isSeenAtTheEdgeThatComesFirst() {
  Rig rig = sound();
  rig.encoder.indexWidth_counts = 2.0;
  const double count = turn / 4000.0;
  EncoderModel encoder(rig);
  QVERIFY(!encoder.read(-0.5 * count).index);
  QVERIFY(encoder.read(0.5 * count).index);
  QVERIFY(!encoder.read(2.5 * count).index);
  QVERIFY(encoder.read(1.5 * count).index);
  QVERIFY(!encoder.read(-0.5 * count).index);
}

void TestSensors::bentBridge_givesItsCurve() {
  Rig rig = sound();
  rig.bridge.deadZoneDuty = 0.01;
  QVERIFY(std::abs(BridgeModel(rig).voltage(-0.11) - -2.4) < 1e-12);
  rig.bridge.dutyCurve.points = {{0.01, {}}, {0.11, {0.05, 0.0}}};
  QVERIFY(std::abs(BridgeModel(rig).voltage(-0.06) - -0.6) < 1e-12);
  QVERIFY(std::abs(BridgeModel(rig).voltage(0.21) - 3.6) < 1e-12);
  QCOMPARE(BridgeModel(rig).voltage(0.01), 0.0);
}

QTEST_APPLESS_MAIN(TestSensors)
#include "tst_sensors.moc"
