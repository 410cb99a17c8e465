#include <QTest>
#include <algorithm>
#include <cmath>
#include <deque>
#include <string>

#include "base/numbers.h"
#include "base/random.h"
#include "diagnose/diagnosis.h"
#include "diagnose/simulate/model_file.h"
#include "diagnose/simulate/simulation.h"
#include "motor/bench.h"
#include "recording/csv.h"
#include "support/real_recordings.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

/// Recordings that hold what a servo was asked for, while its own loop drove it.
class TestServoLaw : public QObject {
  Q_OBJECT
 private slots:
  void bench_namesTheLaw();
  void bench_refusesWhatIsNoLaw_data();
  void bench_refusesWhatIsNoLaw();
  void soundServo_isSound_data();
  void soundServo_isSound();
  void loadedServo_isLoaded();
  void limit_clips();
  void model_simulatesFromTheReferenceAlone();
  void joints_areExplainedByTheirReference();
};

namespace {

/// A joint behind a PD law of its own, in SI units, and how it is logged.
struct Joint {
  double inertia = 0.02, viscous = 0.15, coulomb = 0.3, load = 0.0;
  double kp = 20.0, kd = 1.0, limit = 1e9, delay_s = 0.0, rate_Hz = 1000.0;
  double torqueConstant = 1.0;             ///< where the law gives out a current
  double wander = 0.003, wander_s = 0.05;  ///< torque that changes at random, as any rig's: rms, correlation time
  double log_Hz = 200.0, count = turn_rad / 16384.0, seconds = 24.0;
};

double asked(double t) {
  return 0.35 * std::sin(2.0 * t) + 0.25 * std::sin(5.3 * t + 1.0) + 0.12 * std::sin(13.0 * t + 0.3 * t * t) +
         0.2 * (std::sin(0.7 * t) > 0.0 ? 1.0 : 0.0);
}

/// Simulated apart from what is tested: small steps, friction that holds, a law at its own instants with a queue.
Recording recordedJoint(const Joint& joint) {
  constexpr double step_s = 5e-5;
  const auto perTick = static_cast<size_t>(std::lround(1.0 / (joint.rate_Hz * step_s)));
  const auto perRow = static_cast<size_t>(std::lround(1.0 / (joint.log_Hz * step_s)));
  const auto late = static_cast<size_t>(std::lround(joint.delay_s / step_s));
  Random random(7);
  std::deque<double> queue(late + 1, 0.0);
  double x = 0.0, v = 0.0, reference = 0.0, drive = 0.0, wander = 0.0;
  const double keep = std::exp(-step_s / joint.wander_s);
  std::vector<double> time, angle, references;
  for (size_t k = 0; static_cast<double>(k) * step_s < joint.seconds; ++k) {
    const double t = static_cast<double>(k) * step_s;
    if (k % perRow == 0) {
      reference = asked(t);
      time.push_back(t);
      angle.push_back(joint.count * std::floor(x / joint.count));
      references.push_back(reference);
    }
    if (k % perTick == 0) drive = std::clamp(joint.kp * (reference - x) - joint.kd * v, -joint.limit, joint.limit);
    queue.push_back(drive);
    queue.pop_front();
    wander = keep * wander + joint.wander * std::sqrt(1.0 - keep * keep) * random.normal();
    const double push = joint.torqueConstant * queue.front() + wander - joint.load - joint.viscous * v;
    if (v == 0.0 && std::abs(push) <= joint.coulomb) continue;
    const double way = v != 0.0 ? std::copysign(1.0, v) : std::copysign(1.0, push);
    const double next = v + step_s * (push - way * joint.coulomb) / joint.inertia;
    v = v != 0.0 && next * v < 0.0 ? 0.0 : next;
    x += step_s * v;
  }
  return *Recording::seal("joint.csv", {{"time_s", time}, {"angle_rad", angle}, {"angle_reference_rad", references}});
}

Bench benchOf(const std::string& controller, const std::string& motor, const std::string& trusted) {
  const auto bench = readBenchText(
      R"({"schema": "breakaway.bench/1", "name": "joint", "axis": "rotary", "encoder": {"counts_per_rev": 16384},
          "drive": {"input": "angle_reference_rad"}, "motor": {)" +
          motor + R"(}, "trusted": [)" + trusted + R"(], "controller": {"mode": "position")" + controller + "}}",
      "joint.bench.json");
  if (!bench) qFatal("%s", bench.error().message().c_str());
  return *bench;
}

const std::string gains = R"(, "kp_Nm_per_rad": 20, "kd_Nm_s_per_rad": 1, "rate_Hz": 1000)";
const std::string believed = R"("inertia_kg_m2": 0.03, "viscous_Nm_s_per_rad": 0.1, "coulomb_Nm": 0.2)";
const std::string trustedKp = R"("controller.kp_Nm_per_rad", "controller.kd_Nm_s_per_rad")";

void compareWithTruth(const Model& model, const char* name, double truth, double part) {
  const double value = model.baseValue(name).value_or(-1.0);
  QVERIFY2(std::abs(value - truth) <= part * std::abs(truth),
           (std::string(name) + " " + std::to_string(value) + ", is " + std::to_string(truth)).c_str());
}

}  // namespace

void TestServoLaw::bench_namesTheLaw() {
  const Bench bench = benchOf(R"(, "kp_A_per_rad": 3, "current_limit_A": 2, "delay_s": 0.004)", believed,
                              R"("controller.kp_A_per_rad")");
  QVERIFY(bench.servo);
  QCOMPARE(bench.input, DriveInput::current);
  QCOMPARE(*bench.servo->kp, 3.0);
  QCOMPARE(*bench.servo->limit, 2.0);
  QCOMPARE(*bench.servo->delay_s, 0.004);
  QCOMPARE(bench.inputChannel(), std::string("angle_reference_rad"));
  const TemporaryFolder folder;
  VERIFY_OK(writeBench(bench, folder.path("again.bench.json")));
  const auto again = readBench(folder.path("again.bench.json"));
  VERIFY_OK(again);
  QCOMPARE(again->input, DriveInput::current);
  QCOMPARE(*again->servo->kp, 3.0);
  QCOMPARE(again->trusted, bench.trusted);
}

void TestServoLaw::bench_refusesWhatIsNoLaw_data() {
  QTest::addColumn<QString>("controller");
  QTest::addColumn<QString>("said");
  QTest::newRow("velocity loop") << R"({"mode": "velocity"})"
                                 << "position";
  QTest::newRow("two quantities") << R"({"kp_Nm_per_rad": 1, "kd_A_s_per_rad": 1})"
                                  << "kd_";
  QTest::newRow("no gain") << R"({"kp_Nm_per_rad": 0})"
                           << "kp_Nm_per_rad";
  QTest::newRow("unknown") << R"({"kp_Nm_per_rad": 1, "ki_Nm_per_rad_s": 1})"
                           << "ki_Nm_per_rad_s";
}

void TestServoLaw::bench_refusesWhatIsNoLaw() {
  QFETCH(QString, controller);
  QFETCH(QString, said);
  const auto bench = readBenchText(
      R"({"schema": "breakaway.bench/1", "axis": "rotary", "drive": {"input": "angle_reference_rad"}, "controller": )" +
          controller.toStdString() + "}",
      "joint.bench.json");
  QVERIFY(!bench);
  QVERIFY2(bench.error().message().find(said.toStdString()) != std::string::npos, bench.error().message().c_str());
}

void TestServoLaw::soundServo_isSound_data() {
  QTest::addColumn<double>("delay_s");
  QTest::addColumn<QString>("trusted");
  if (thorough()) QTest::newRow("at once, gains trusted") << 0.0 << QString::fromStdString(trustedKp);
  QTest::newRow("12 ms late, nothing trusted") << 0.012 << "";
}

void TestServoLaw::soundServo_isSound() {
  if (test::sanitized) QSKIP(likeOthers);
  QFETCH(double, delay_s);
  QFETCH(QString, trusted);
  Joint joint;
  joint.delay_s = delay_s;
  const auto diagnosis = diagnose(benchOf(gains, believed, trusted.toStdString()), {recordedJoint(joint)}, {}, {});
  VERIFY_OK(diagnosis);
  QVERIFY2(diagnosis->verdict == Verdict::nothingMissing, inWords(*diagnosis).c_str());
  compareWithTruth(diagnosis->base, "inertia_kg_m2", joint.inertia, 0.1);
  compareWithTruth(diagnosis->base, "viscous_Nm_s_per_rad", joint.viscous, 0.1);
  compareWithTruth(diagnosis->base, "coulomb_Nm", joint.coulomb, 0.05);
  QVERIFY2(std::abs(*diagnosis->base.baseValue("delay_s") - delay_s) < 1e-3, inWords(*diagnosis).c_str());
  const bool doubted = std::any_of(diagnosis->remarks.begin(), diagnosis->remarks.end(), [](const std::string& one) {
    return one.find("kp_Nm_per_rad") != std::string::npos;
  });
  QCOMPARE(doubted, trusted.isEmpty());
}

void TestServoLaw::loadedServo_isLoaded() {
  Joint joint;
  joint.delay_s = 0.004;
  joint.load = 0.5;
  const auto diagnosis = diagnose(benchOf(gains, believed, trustedKp), {recordedJoint(joint)}, {}, {});
  VERIFY_OK(diagnosis);
  QVERIFY2(diagnosis->findings.size() == 1, inWords(*diagnosis).c_str());
  QCOMPARE(diagnosis->findings.front().effect, std::string("constant_load"));
  compareWithTruth(diagnosis->model, "inertia_kg_m2", joint.inertia, 0.1);
  compareWithTruth(diagnosis->model, "coulomb_Nm", joint.coulomb, 0.1);
}

void TestServoLaw::limit_clips() {
  if (test::sanitized) QSKIP(likeOthers);
  Joint joint;
  joint.limit = 4.0;
  const auto diagnosis =
      diagnose(benchOf(gains + R"(, "torque_limit_Nm": 4.4)", believed, trustedKp), {recordedJoint(joint)}, {}, {});
  VERIFY_OK(diagnosis);
  QVERIFY2(diagnosis->verdict == Verdict::nothingMissing, inWords(*diagnosis).c_str());
  compareWithTruth(diagnosis->base, "torque_limit_Nm", joint.limit, 0.03);
}

void TestServoLaw::model_simulatesFromTheReferenceAlone() {
  if (test::sanitized) QSKIP(likeOthers);
  Joint joint;
  joint.delay_s = 0.004;
  const Recording recording = recordedJoint(joint);
  const auto diagnosis = diagnose(benchOf(gains, believed, trustedKp), {recording}, {}, {});
  VERIFY_OK(diagnosis);
  const TemporaryFolder folder;
  VERIFY_OK(writeModel(diagnosis->model, folder.path("model.json")));
  const auto model = readModel(folder.path("model.json"));
  VERIFY_OK(model);
  SimulateOptions options;
  options.restartEvery_s = 0.5;
  const auto trace = simulate(*model, recording, options);
  VERIFY_OK(trace);
  const auto angle = recording.channel("angle_rad");
  double squares = 0.0;
  for (size_t k = 0; k < angle.size(); ++k) squares += std::pow(trace->position[k] - angle[k], 2);
  const double rms = std::sqrt(squares / static_cast<double>(angle.size()));
  QVERIFY2(rms < 2.0 * diagnosis->fit.heldoutBefore + joint.count, std::to_string(rms).c_str());
}

/// The same recording with the torque that the law makes of the measured motion, as people reconstruct it.
Recording withReconstructedTorque(const Recording& recording, double kp, double kd) {
  const auto time = recording.time(), angle = recording.channel("angle_rad"),
             asked = recording.channel("angle_reference_rad");
  std::vector<double> torque(time.size(), 0.0);
  for (size_t k = 1; k + 1 < time.size(); ++k) {
    const double velocity = (angle[k + 1] - angle[k - 1]) / (time[k + 1] - time[k - 1]);
    torque[k] = kp * (asked[k] - angle[k]) - kd * velocity;
  }
  return *Recording::seal(
      "torque.csv",
      {{"time_s", {time.begin(), time.end()}}, {"angle_rad", {angle.begin(), angle.end()}}, {"torque_Nm", torque}});
}

void TestServoLaw::joints_areExplainedByTheirReference() {
  NEEDS_REAL_RECORDINGS();
  if (test::sanitized) QSKIP("takes too long under sanitizers: diagnoses like others");
  const std::string folder = realRecordings() + "/go2_joint/";
  const auto bench = readBench(folder + "reference.bench.json");
  const auto recording = readCsv(folder + "FR_calf.csv");
  VERIFY_OK(bench);
  VERIFY_OK(recording);
  const auto byReference = diagnose(*bench, {*recording}, {}, {});
  VERIFY_OK(byReference);
  Bench torqueDriven = *bench;
  torqueDriven.servo.reset();
  const auto byTorque = diagnose(torqueDriven, {withReconstructedTorque(*recording, 20.0, 1.5)}, {}, {});
  VERIFY_OK(byTorque);
  QVERIFY2(byReference->fit.heldoutAfter < 0.8 * byTorque->fit.heldoutAfter,
           (inWords(*byReference) + inWords(*byTorque)).c_str());
  const std::string words = inWords(*byReference);
  // Gravity acts on the leg.
  const auto& found = byReference->findings;
  QVERIFY2(!found.empty() && found.front().effect == "imbalance", words.c_str());
  // What users of this robot have published scatters over 0.008 to 0.06 kg m² and 0.16 to 0.77 Nm.
  const auto& base = byReference->model.base;
  const auto inertia =
      std::find_if(base.begin(), base.end(), [](const auto& one) { return one.name == "inertia_kg_m2"; });
  QVERIFY2(inertia != base.end() && inertia->low95 < 0.06 && inertia->high95 > 0.008, words.c_str());
  const double coulomb = *byReference->model.baseValue("coulomb_Nm");
  QVERIFY2(coulomb > 0.16 && coulomb < 0.77, words.c_str());
}

QTEST_APPLESS_MAIN(TestServoLaw)
#include "tst_servo_law.moc"
