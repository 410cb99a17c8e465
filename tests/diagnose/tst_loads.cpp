#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/diagnosis.h"
#include "diagnose/search/model_fit.h"
#include "diagnose/verdict/remainder.h"
#include "support/driven_recording.h"
#include "support/known_servo.h"
#include "support/sanitized.h"
#include "support/within.h"

using namespace breakaway;
using namespace breakaway::test;

/// Loads behind a gap, whose restarts may run away, and restarts at the edge of standstill, which hide nothing.
class TestLoads : public QObject {
  Q_OBJECT
 private slots:
  void softContact_isFoundBehindItsGap();
  void frictionBehindASpring_isFoundThere();
  void windowsThatBeginAtReversals_areNotAboveTheFloor();
  void windowsThatErrWhereverTheyBegin_areAboveTheFloor();
};

namespace {

Bench torqueBench() {
  const auto bench = readBenchText(R"({"schema": "breakaway.bench/1", "name": "driven", "axis": "rotary",
      "encoder": {"counts_per_rev": 8192}, "drive": {"input": "torque_Nm"},
      "motor": {"inertia_kg_m2": 7e-5, "viscous_Nm_s_per_rad": 2.4e-4, "coulomb_Nm": 0.010},
      "controller": {"mode": "open_loop"}})",
                                   "bench.json");
  if (!bench) qFatal("%s", bench.error().message().c_str());
  return *bench;
}

Preparation prepared(Model truth) {
  truth.count = 2.0 * std::numbers::pi / 8192.0;
  auto made = prepare(torqueBench(), {drivenRecording(truth, {.seconds = secondsToFit(30.0)})}, {}, 0.5);
  if (!made) qFatal("%s", made.error().message().c_str());
  return *made;
}

/// Most windows err as restarts of the model do, every fifth far more.
Remainder withFarWindows(const Model& model, const Preparation& data) {
  std::vector<double> errors = scoreWindows(model, data.tracks, data.split.trainScore);
  const double far = 1e4 * *std::max_element(errors.begin(), errors.end());
  for (size_t w = 0; w < errors.size(); w += 5) errors[w] = far;
  return remainderOf(model, data, {errors, errors}, {}, 1);
}

}  // namespace

void TestLoads::softContact_isFoundBehindItsGap() {
  const double load = 2.6e-5, gap = 0.02, frequency = 100.0;
  Model truth = servoWith(DriveInput::torque, "backlash", {load, gap, load * frequency * frequency, 0.3});
  truth.count = 2.0 * std::numbers::pi / 8192.0;
  const auto diagnosis =
      diagnose(torqueBench(), {drivenRecording(truth, {.seconds = secondsToFit(15.0), .size = 1.5})}, {}, {});
  QVERIFY(diagnosis);
  if (sanitized) return;
  QVERIFY2(!diagnosis->findings.empty(), inWords(*diagnosis).c_str());
  const Finding& first = diagnosis->findings.front();
  QCOMPARE(first.effect, std::string("backlash"));
  VERIFY_WITHIN(first.parameters.at(0).value, load, 0.2);
  VERIFY_WITHIN(first.parameters.at(1).value, gap, 0.3);
}

void TestLoads::frictionBehindASpring_isFoundThere() {
  if (sanitized) QSKIP(likeOthers);
  const double load = 2.6e-5, frequency = 90.0, held = 4e-3;
  Model truth = servoWith(DriveInput::torque, "compliance", {load, frequency, 0.04, held});
  truth.count = 2.0 * std::numbers::pi / 8192.0;
  const auto diagnosis =
      diagnose(torqueBench(), {drivenRecording(truth, {.seconds = secondsToFit(15.0), .size = 1.5})}, {}, {});
  QVERIFY(diagnosis);
  QVERIFY2(!diagnosis->findings.empty(), inWords(*diagnosis).c_str());
  const Finding& first = diagnosis->findings.front();
  QCOMPARE(first.effect, std::string("compliance"));
  VERIFY_WITHIN(first.parameters.at(0).value, load, 0.2);
  VERIFY_WITHIN(first.parameters.at(1).value, frequency, 0.1);
  VERIFY_WITHIN(first.parameters.at(3).value, held, 0.3);
}

/// The same restarts half a window later err as little as they should.
void TestLoads::windowsThatBeginAtReversals_areNotAboveTheFloor() {
  const Preparation data = prepared(servoModel(DriveInput::torque));
  const Model model = fitBase(SearchInput(data, 1), data.starts).model;
  QVERIFY(!withFarWindows(model, data).aboveFloor);
}

void TestLoads::windowsThatErrWhereverTheyBegin_areAboveTheFloor() {
  const Preparation data = prepared(servoModel(DriveInput::torque));
  Model model = fitBase(SearchInput(data, 1), data.starts).model;
  for (Parameter& one : model.base) {
    if (one.name == "coulomb_Nm") one.value *= 1.5;
  }
  QVERIFY(withFarWindows(model, data).aboveFloor);
}

QTEST_APPLESS_MAIN(TestLoads)
#include "tst_loads.moc"
