#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/fit/ringing_start.h"
#include "diagnose/simulate/physics.h"
#include "support/driven_recording.h"

using namespace breakaway;

/// A servo whose winding and rotor ring at 149 Hz, and its recordings by an encoder of 65536 counts.
class TestRingingStart : public QObject {
  Q_OBJECT
 private slots:
  void ringing_isFound_data();
  void ringing_isFound();
  void whatIsTrusted_isKept();
  void rotorThatDoesNotRing_hasNoSuchStart();
};

namespace {

constexpr double inductance_H = 7.3e-3, inertia_kg_m2 = 9.7e-5;

Model ringing(double inductance) {
  Model model;
  model.input = DriveInput::voltage;
  model.count = 2.0 * std::numbers::pi / 65536.0;
  for (const auto& [name, value] : {std::pair<const char*, double>{"torque_constant_Nm_per_A", 0.79},
                                    {"back_emf_constant_V_s_per_rad", 0.79},
                                    {"resistance_ohm", 1.09},
                                    {"inductance_H", inductance},
                                    {"inertia_kg_m2", inertia_kg_m2},
                                    {"viscous_Nm_s_per_rad", 1.1e-4},
                                    {"coulomb_Nm", 0.037}})
    model.base.push_back({name, value, value, value});
  return model;
}

std::vector<Track> tracksOf(const Model& truth, double row_s) {
  const Recording recording = test::drivenRecording(
      truth, {.seconds = 30.0, .row_s = row_s, .hold_s = row_s, .size = 100.0, .current = false, .pulses = true});
  return {*makeTrack(recording, truth.axis, truth.input, {}, truth.count)};
}

/// The bench's belief: inertia and inductance far off.
Model believed() {
  Model start = ringing(3.0 * inductance_H);
  for (Parameter& one : start.base) {
    if (one.name == "inertia_kg_m2") one.value *= 4.0;
  }
  return start;
}

double off(const Model& model, const char* name, double truth) {
  return std::abs(model.baseValue(name).value_or(0.0) / truth - 1.0);
}

}  // namespace

void TestRingingStart::ringing_isFound_data() {
  QTest::addColumn<double>("row_s");
  QTest::addColumn<double>("apart");  // by which each of inductance and inertia may be off
  QTest::newRow("faster than rows") << 0.01 << 0.05;
  QTest::newRow("two rows a turn") << 0.0033 << 0.05;
  QTest::newRow("seven rows a turn") << 0.001 << 0.05;
  QTest::newRow("about once a row") << 1.0 / 142.0 << 0.15;
  QTest::newRow("just once a row, which shows their product alone") << 1.0 / 149.0 << 1.2;
}

void TestRingingStart::ringing_isFound() {
  QFETCH(double, row_s);
  QFETCH(double, apart);
  const auto starts = ringingStarts(believed(), tracksOf(ringing(inductance_H), row_s), {});
  QVERIFY(!starts.empty());
  QVERIFY(std::any_of(starts.begin(), starts.end(), [&](const Model& one) {
    const double together = *one.baseValue("inductance_H") * *one.baseValue("inertia_kg_m2");
    return std::abs(together / (inductance_H * inertia_kg_m2) - 1.0) < 0.15 &&
           off(one, "inductance_H", inductance_H) < apart && off(one, "inertia_kg_m2", inertia_kg_m2) < apart &&
           off(one, "coulomb_Nm", 0.037) < 0.4;
  }));
}

void TestRingingStart::whatIsTrusted_isKept() {
  Model start = believed();
  for (Parameter& one : start.base) {
    if (one.name == "inductance_H") one.value = inductance_H;
  }
  const auto starts = ringingStarts(start, tracksOf(ringing(inductance_H), 0.01), {"inductance_H"});
  QVERIFY(!starts.empty());
  for (const Model& one : starts) QCOMPARE(one.baseValue("inductance_H"), std::optional<double>(inductance_H));
  QVERIFY(std::any_of(starts.begin(), starts.end(),
                      [](const Model& one) { return off(one, "inertia_kg_m2", inertia_kg_m2) < 0.05; }));
}

void TestRingingStart::rotorThatDoesNotRing_hasNoSuchStart() {
  QVERIFY(ringingStarts(believed(), tracksOf(ringing(2e-5), 0.001), {}).empty());
}

QTEST_APPLESS_MAIN(TestRingingStart)
#include "tst_ringing_start.moc"
