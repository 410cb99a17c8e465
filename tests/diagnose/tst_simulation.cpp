#include <QTest>
#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "diagnose/simulate/model_file.h"
#include "diagnose/simulate/simulation.h"
#include "diagnose/simulate/simulator.h"
#include "support/known_servo.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestSimulation : public QObject {
  Q_OBJECT
 private slots:
  void restarts_areAtTheFirstRowsOfTheGrid();
  void ownRecording_isPredictedAgain();
  void quantisedOwnRecording_errsByAboutACount();
  void restartWithWrongFriction_beginsNearTheMeasurement();
  void modelFile_givesTheIdenticalTrace();
  void modelFile_leavesOutWhatIsAbsentAtZero();
  void pushInOneRecording_isNotInAnother();
  void unknownEffect_isOneClearLine();
  void missingDriveChannel_isOneClearLine();
};

namespace {

Model voltageModel() {
  return servoWith(DriveInput::voltage, "cogging", {0.001, 0.4, 12.0});
}

/// Rows of 1 ms, some left out, from 100 s on; positions are the model's own, or floored to its count.
Recording ownRecording(const Model& model, double count, double seconds = 6.0) {
  std::vector<double> time, volts, angle;
  for (int k = 0; k < static_cast<int>(seconds * 1000.0); ++k) {
    if (k % 97 == 13) continue;
    const double t = 1e-3 * k;
    time.push_back(100.0 + t);
    volts.push_back(1.2 * std::sin(3.0 * t) + 0.4 * std::sin(17.0 * t));
    angle.push_back(0.0);
  }
  const auto make = [&] {
    return *Recording::seal("own.csv", {{"time_s", time}, {"angle_rad", angle}, {"voltage_V", volts}});
  };
  const auto trace = simulate(model, make(), {});
  if (!trace) qFatal("%s", trace.error().message().c_str());
  angle = trace->position;
  if (count > 0.0) {
    for (double& value : angle) value = std::floor(value / count) * count;
  }
  return make();
}

double rmsError(const Trace& trace, const Recording& recording) {
  const auto angle = recording.channel("angle_rad");
  double squares = 0.0;
  for (size_t k = 0; k < angle.size(); ++k) squares += std::pow(trace.position[k] - angle[k], 2);
  return std::sqrt(squares / static_cast<double>(angle.size()));
}

}  // namespace

void TestSimulation::restarts_areAtTheFirstRowsOfTheGrid() {
  // A gap over 0.6, a row that misses 0.8 by rounding only, and a start that is not 0.
  std::vector<double> time;
  for (const double t : {0.0, 0.1, 0.2, 0.35, 0.4, 0.55, 0.7, 0.75, 0.8 - 5e-10, 0.9, 0.99, 1.0 - 1e-6, 1.01, 1.5}) {
    time.push_back(7.0 + t);
  }
  const std::vector<double> zeros(time.size(), 0.0);
  const auto recording = Recording::seal("r", {{"time_s", time}, {"angle_rad", zeros}, {"voltage_V", zeros}});
  VERIFY_OK(recording);
  const auto every = simulate(voltageModel(), *recording, {.restartEvery_s = 0.2});
  VERIFY_OK(every);
  QCOMPARE(every->restarts, (std::vector<size_t>{0, 2, 4, 6, 8, 12, 13}));
  const auto never = simulate(voltageModel(), *recording, {});
  VERIFY_OK(never);
  QCOMPARE(never->restarts, std::vector<size_t>{0});
}

void TestSimulation::ownRecording_isPredictedAgain() {
  const Model model = voltageModel();
  const Recording recording = ownRecording(model, 0.0);
  const auto angle = recording.channel("angle_rad");
  QVERIFY(*std::max_element(angle.begin(), angle.end()) > 1.0);
  const auto free = simulate(model, recording, {});
  VERIFY_OK(free);
  QVERIFY(rmsError(*free, recording) < 1e-12);
  const auto restarted = simulate(model, recording, {.restartEvery_s = 0.5});
  VERIFY_OK(restarted);
  const double error = rmsError(*restarted, recording);
  QVERIFY2(error < 1e-3, qPrintable(QString::number(error)));
}

void TestSimulation::quantisedOwnRecording_errsByAboutACount() {
  Model model = voltageModel();
  model.count = 2.0 * 3.141592653589793 / 14400.0;
  const Recording recording = ownRecording(model, model.count);
  const auto trace = simulate(model, recording, {.restartEvery_s = 0.5});
  VERIFY_OK(trace);
  const double counts = rmsError(*trace, recording) / model.count;
  QVERIFY2(counts > 0.2 && counts < 4.0, qPrintable(QString::number(counts)));
}

void TestSimulation::restartWithWrongFriction_beginsNearTheMeasurement() {
  const Model truth = voltageModel();
  const Recording recording = ownRecording(truth, 0.0);
  Model wrong = truth;
  for (Parameter& one : wrong.base) {
    if (one.name == "coulomb_Nm") one.value *= 1.2;
  }
  const auto trace = simulate(wrong, recording, {.restartEvery_s = 0.5});
  VERIFY_OK(trace);
  const auto angle = recording.channel("angle_rad");
  double atRestart = 0.0;
  for (const size_t row : trace->restarts) atRestart += std::pow(trace->position[row] - angle[row], 2);
  atRestart = std::sqrt(atRestart / static_cast<double>(trace->restarts.size()));
  const double over = rmsError(*trace, recording);
  QVERIFY2(atRestart < 0.1 * over && atRestart > 0.0, qPrintable(QString("%1 %2").arg(atRestart).arg(over)));
  QVERIFY2(over > 0.01 && over < 1.0, qPrintable(QString::number(over)));
}

void TestSimulation::modelFile_givesTheIdenticalTrace() {
  const TemporaryFolder folder;
  Model model = voltageModel();
  model.count = 2.0 * 3.141592653589793 / 14400.0;
  model.supply_V = 24.1;
  model.restartHorizon_s = 0.037;
  model.pendulum = Pendulum{0.01, 0.05, 0.002, 0.0};
  model.base.push_back({"down_angle_rad", 1.0 / 3.0, 0.3, 0.4});
  VERIFY_OK(writeModel(model, folder.path("model.json")));
  const auto back = readModel(folder.path("model.json"));
  VERIFY_OK(back);
  QCOMPARE(back->base.size(), model.base.size());
  for (const Parameter& one : model.base) {
    QVERIFY2(std::find(back->base.begin(), back->base.end(), one) != back->base.end(), one.name.c_str());
  }
  QCOMPARE(back->effects.size(), model.effects.size());
  const Recording recording = ownRecording(voltageModel(), model.count, 2.0);
  const auto before = simulate(model, recording, {.restartEvery_s = 0.5}),
             after = simulate(*back, recording, {.restartEvery_s = 0.5});
  VERIFY_OK(before);
  VERIFY_OK(after);
  QCOMPARE(after->position, before->position);
  QCOMPARE(after->velocity, before->velocity);
  QCOMPARE(after->current_A, before->current_A);
  QCOMPARE(before->current_A.size(), recording.rows());
}

void TestSimulation::modelFile_leavesOutWhatIsAbsentAtZero() {
  for (const double friction : {0.0, 0.003}) {
    const Model model = servoWith(DriveInput::torque, "compliance", {2e-5, 80.0, 0.05, friction});
    const TemporaryFolder folder;
    VERIFY_OK(writeModel(model, folder.path("model.json")));
    const auto text = readFile(folder.path("model.json"));
    VERIFY_OK(text);
    QCOMPARE(text->find("load_friction_Nm") != std::string::npos, friction > 0.0);
    const auto back = readModel(folder.path("model.json"));
    VERIFY_OK(back);
    QVERIFY(back->effects == model.effects);
  }
}

void TestSimulation::pushInOneRecording_isNotInAnother() {
  Model model = servoWith(DriveInput::voltage, "external_disturbance", {0.004, 1.0, 2.0});
  model.effects.front().recording = "own.csv";
  const TemporaryFolder folder;
  VERIFY_OK(writeModel(model, folder.path("model.json")));
  const auto back = readModel(folder.path("model.json"));
  VERIFY_OK(back);
  QCOMPARE(back->effects.front().recording, std::string("own.csv"));

  const auto named = [](const char* name) {
    const Recording own = ownRecording(voltageModel(), 0.0, 4.0);
    std::vector<Channel> channels;
    for (const char* channel : {"time_s", "angle_rad", "voltage_V"}) {
      const auto values = own.channel(channel);
      channels.push_back({channel, {values.begin(), values.end()}});
    }
    return *Recording::seal(name, channels);
  };
  Model without = *back;
  without.effects.clear();
  const auto pushed = simulate(*back, named("some/folder/own.csv"), {});
  const auto other = simulate(*back, named("some/folder/other.csv"), {});
  const auto none = simulate(without, named("some/folder/other.csv"), {});
  VERIFY_OK(pushed);
  QCOMPARE(other->position, none->position);
  QVERIFY(std::abs(pushed->position.back() - none->position.back()) > 0.1);
}

void TestSimulation::unknownEffect_isOneClearLine() {
  const TemporaryFolder folder;
  Model model = voltageModel();
  model.effects.front().effect = "coging";
  const std::string path = folder.path("model.json");
  VERIFY_OK(writeModel(model, path));
  VERIFY_ERROR(readModel(path), path + ", effect coging: is not in the catalogue");
}

void TestSimulation::missingDriveChannel_isOneClearLine() {
  const auto recording = Recording::seal("r.csv", {{"time_s", {0.0, 1.0}}, {"angle_rad", {0.0, 0.0}}});
  VERIFY_OK(recording);
  VERIFY_ERROR(simulate(voltageModel(), *recording, {}), "r.csv: has no column voltage_V, which drives this bench");
}

QTEST_APPLESS_MAIN(TestSimulation)
#include "tst_simulation.moc"
