#include <oneapi/tbb/global_control.h>

#include <QTest>
#include <algorithm>
#include <numbers>

#include "diagnose/diagnosed.h"
#include "support/driven_recording.h"
#include "support/known_servo.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

/// Recordings of the simulated rig's plant with one thing the base model lacks, and without.
class TestDiagnose : public QObject {
  Q_OBJECT
 private slots:
  void coulombAsymmetry_isOneAndTheSameAsConstantLoad();
  void severalWaves_areOneFinding_data();
  void severalWaves_areOneFinding();
  void sensorsOffset_isNamed_data();
  void sensorsOffset_isNamed();
  void pushInThePartKeptForTheProof_isNamed();
  void sameSeed_givesTheSameDiagnosis_onOneCoreAsOnAll();
  void timeThatIsOver_leavesWhatWasFoundByThen_data();
  void timeThatIsOver_leavesWhatWasFoundByThen();
  void noTime_leavesTheBaseModel();
  void missingChannel_isOneClearLine();
  void threeSeconds_areUndecidedWithTheirBaseParameters();
  void commandsStampedLate_areADelayBelowZero();
  void dutyServesABenchThatVoltageDrives();
};

void TestDiagnose::coulombAsymmetry_isOneAndTheSameAsConstantLoad() {
  const Diagnosis diagnosis = diagnosed({.asymmetry = 0.4, .seconds = 20.0});
  if (sanitized) return;
  QCOMPARE(nameOf(diagnosis.verdict), std::string("named"));
  QCOMPARE(diagnosis.findings.size(), size_t(1));
  const Finding& finding = diagnosis.findings.front();
  QCOMPARE(finding.effect, std::string("constant_load"));
  QCOMPARE(finding.ambiguousWith, std::vector<std::string>{"coulomb_asymmetry"});
  const double load = parameter(finding, "load_Nm");  // half the difference of the two ways
  QVERIFY2(within(load, gauge * 0.5 * 0.4 * 0.012, 0.05), qPrintable(QString::number(load)));
  QVERIFY2(finding.share > 0.8 && finding.share <= 1.0, qPrintable(QString::number(finding.share)));
  QVERIFY(isProved(diagnosis.fit));
  QVERIFY2(diagnosis.proof.achieved > 0.8 && diagnosis.proof.achieved <= 1.0,
           qPrintable(QString::number(diagnosis.proof.achieved)));
  QCOMPARE(diagnosis.proof.worst.recording, std::string("test.csv"));
  QVERIFY(diagnosis.proof.worst.after >= diagnosis.proof.typical.after);
  QVERIFY(!diagnosis.where.empty());
  QVERIFY2(diagnosis.where.front().pValue <= 0.01, diagnosis.where.front().sentence.c_str());
}

void TestDiagnose::severalWaves_areOneFinding_data() {
  QTest::addColumn<QString>("torque");
  QTest::addColumn<QString>("friction");
  QTest::addColumn<QString>("effect");
  QTest::addColumn<QList<double>>("sizes");  // amplitudes in Nm and their orders, the largest first
  QTest::newRow("cogging") << "[[7, 0.002, 0.4], [14, 0.0009, 2.0], [12, 0.0006, -1.0]]"
                           << "[]"
                           << "cogging" << QList<double>{0.002, 7.0, 0.0009, 14.0, 0.0006, 12.0};
  QTest::newRow("friction") << "[]"
                            << "[[1, 0.2, 0.4], [3, 0.1, 1.0]]"
                            << "position_dependent_friction" << QList<double>{0.2 * 0.012, 1.0, 0.1 * 0.012, 3.0};
}

void TestDiagnose::severalWaves_areOneFinding() {
  if (sanitized) QSKIP(likeOthers);
  QFETCH(QString, torque);
  QFETCH(QString, friction);
  QFETCH(QString, effect);
  QFETCH(QList<double>, sizes);
  const Diagnosis diagnosis =
      diagnosed({.positionTorque = torque.toStdString(), .waves = friction.toStdString(), .seconds = 30.0});
  QVERIFY2(nameOf(diagnosis.verdict) == "named", inWords(diagnosis).c_str());
  QCOMPARE(diagnosis.findings.size(), size_t(1));
  const Finding& finding = diagnosis.findings.front();
  QCOMPARE(QString::fromStdString(finding.effect), effect);
  for (qsizetype k = 0; k + 1 < sizes.size(); k += 2) {
    const std::string number = k > 0 ? std::to_string(k / 2 + 1) : "";
    QCOMPARE(parameter(finding, "order" + number), sizes[k + 1]);
    const double size = std::abs(parameter(finding, "amplitude" + number + "_Nm"));
    QVERIFY2(within(size, gauge * sizes[k], 0.1), inWords(diagnosis).c_str());
  }
  QCOMPARE(finding.parameters.size(), static_cast<size_t>(3 * sizes.size() / 2));
  QVERIFY(isProved(diagnosis.fit));
}

void TestDiagnose::sensorsOffset_isNamed_data() {
  QTest::addColumn<double>("wander");  // of the friction
  QTest::newRow("alone") << 0.0;
  QTest::newRow("under a torque that wanders") << 0.03;
}

/// What the current sensor shows moves nothing: neither what the torque does nor held-out positions speak against it.
void TestDiagnose::sensorsOffset_isNamed() {
  if (sanitized) QSKIP(likeOthers);
  QFETCH(double, wander);
  const Diagnosis diagnosis =
      diagnosed({.seconds = 20.0, .currentOffset_A = 0.03, .wander_Nm = wander * 0.012, .seed = 2});
  QCOMPARE(diagnosis.findings.size(), size_t(1));
  const Finding& finding = diagnosis.findings.front();
  QCOMPARE(finding.effect, std::string("current_sensor_offset"));
  QVERIFY2(within(parameter(finding, "offset_A"), 0.03, 0.05),
           qPrintable(QString::number(parameter(finding, "offset_A"))));
}

/// The parts that train show nothing of it.
void TestDiagnose::pushInThePartKeptForTheProof_isNamed() {
  if (sanitized) QSKIP(likeOthers);
  const Diagnosis diagnosis = diagnosed({.seconds = 20.0, .push_Nm = -0.006, .pushFrom_s = 17.0, .pushTo_s = 19.0});
  QCOMPARE(diagnosis.findings.size(), size_t(1));
  const Finding& finding = diagnosis.findings.front();
  QCOMPARE(finding.effect, std::string("external_disturbance"));
  QVERIFY2(within(parameter(finding, "start_s"), 17.0, 0.02), inWords(diagnosis).c_str());
  QVERIFY2(within(parameter(finding, "duration_s"), 2.0, 0.15), inWords(diagnosis).c_str());
  for (const auto& [first, end] : diagnosis.heldoutRows) QVERIFY(end < 16'000);
}

void TestDiagnose::sameSeed_givesTheSameDiagnosis_onOneCoreAsOnAll() {
  const auto rig = recordRig({.asymmetry = 0.4, .seconds = secondsToFit(12.0)});
  DiagnoseOptions options;
  options.seed = 5;
  const auto first = diagnose(rig.bench, {rig.recording}, {}, options);
  const tbb::global_control oneCore(tbb::global_control::max_allowed_parallelism, 1);
  const auto second = diagnose(rig.bench, {rig.recording}, {}, options);
  VERIFY_OK(first);
  VERIFY_OK(second);
  QCOMPARE(inWords(*first), inWords(*second));
  QCOMPARE(first->model.base, second->model.base);
  QCOMPARE(first->model.effects, second->model.effects);
  QCOMPARE(first->fit.improvementLow95, second->fit.improvementLow95);
  QCOMPARE(first->fit.improvementHigh95, second->fit.improvementHigh95);
  QCOMPARE(first->fit.floor, second->fit.floor);
  QCOMPARE(first->heldoutRows, second->heldoutRows);
  QCOMPARE(first->where.size(), second->where.size());
  for (size_t k = 0; k < first->where.size(); ++k) {
    QCOMPARE(first->where[k].sentence, second->where[k].sentence);
    QCOMPARE(first->where[k].pValue, second->where[k].pValue);
  }
}

void TestDiagnose::threeSeconds_areUndecidedWithTheirBaseParameters() {
  const auto rig = recordRig({.seconds = 3.0});
  const auto diagnosis = diagnose(rig.bench, {rig.recording}, {}, {});
  QVERIFY(diagnosis);
  QCOMPARE(nameOf(diagnosis->verdict), std::string("undecided"));
  QVERIFY(diagnosis->findings.empty() && diagnosis->where.empty());
  const FitScore& fit = diagnosis->fit;
  QCOMPARE(fit.heldoutBefore, fit.trainBefore);
  QCOMPARE(fit.heldoutAfter, fit.heldoutBefore);
  QCOMPARE(fit.improvementLow95, 0.0);
  QCOMPARE(fit.improvementHigh95, 0.0);
  const bool said = std::any_of(diagnosis->remarks.begin(), diagnosis->remarks.end(),
                                [](const std::string& one) { return one.find("too short") != std::string::npos; });
  QVERIFY2(said, inWords(*diagnosis).c_str());
  for (const Parameter& one : diagnosis->base.base) {
    if (one.name == "coulomb_Nm")
      QVERIFY2(within(one.value, gauge * 0.012, 0.15), qPrintable(QString::number(one.value)));
  }
}

void TestDiagnose::commandsStampedLate_areADelayBelowZero() {
  Model truth = servoModel(DriveInput::torque);
  truth.count = 2.0 * std::numbers::pi / 8192.0;
  const Recording exact = drivenRecording(truth, {.seconds = secondsToFit(16.0), .row_s = 5e-3, .hold_s = 5e-3});
  std::vector<Channel> channels = exact.channels();
  for (Channel& one : channels) {
    if (one.name == "torque_Nm") std::rotate(one.values.begin(), one.values.end() - 1, one.values.end());
  }
  const auto bench = readBenchText(R"({"schema": "breakaway.bench/1", "name": "log", "axis": "rotary",
      "encoder": {"counts_per_rev": 8192}, "drive": {"input": "torque_Nm"}, "motor": {}})",
                                   "bench.json");
  QVERIFY(bench);
  const auto diagnosis = diagnose(*bench, {*Recording::seal("late.csv", channels)}, {}, {});
  QVERIFY(diagnosis);
  if (sanitized) return;
  QVERIFY2(!diagnosis->findings.empty(), inWords(*diagnosis).c_str());
  QCOMPARE(diagnosis->findings.front().effect, std::string("transport_delay"));
  VERIFY_WITHIN(parameter(diagnosis->findings.front(), "delay_s"), -5e-3, 0.2);
}

void TestDiagnose::dutyServesABenchThatVoltageDrives() {
  auto rig = recordRig({.seconds = 12.0});
  rig.bench.supply_V = 24.0;
  std::vector<Channel> channels = rig.recording.channels();
  for (Channel& one : channels) {
    if (one.name != "voltage_V") continue;
    one.name = "duty";
    for (double& value : one.values) value /= 24.0;
  }
  const Recording duty = *Recording::seal("duty.csv", channels);
  const auto volts = makeTrack(rig.recording, rig.bench.axis, rig.bench.input, rig.bench.supply_V, rig.bench.count());
  const auto track = makeTrack(duty, rig.bench.axis, rig.bench.input, rig.bench.supply_V, rig.bench.count());
  QVERIFY(volts && track);
  for (size_t k = 0; k < track->rows(); ++k) QVERIFY(std::abs(track->input[k] - volts->input[k]) < 1e-9);
  // What shares rows is refused all the same.
  const auto refused = diagnose(rig.bench, {duty}, {*Recording::seal("again.csv", channels)}, {});
  QVERIFY(!refused && refused.error().message().find("again.csv") != std::string::npos);
}

void TestDiagnose::timeThatIsOver_leavesWhatWasFoundByThen_data() {
  QTest::addColumn<QString>("when");  // it is over
  QTest::addColumn<QString>("verdict");
  QTest::addColumn<bool>("cutShort");
  QTest::addColumn<QString>("remark");
  QTest::newRow("before anything is found") << "looking for what is missing"
                                            << "undecided" << true << "give it more";
  QTest::newRow("before all is found") << "looking for more"
                                       << "ambiguous" << true << "there may be more";
  QTest::newRow("before rivals are tried") << "weighing rivals"
                                           << "ambiguous" << false << "those that weren't are listed";
}

void TestDiagnose::timeThatIsOver_leavesWhatWasFoundByThen() {
  QFETCH(QString, when);
  QFETCH(QString, verdict);
  QFETCH(bool, cutShort);
  QFETCH(QString, remark);
  const auto rig = recordRig({.positionTorque = "[[12, 0.003, 1.1]]", .seconds = secondsToFit(20.0)});
  DiagnoseOptions options;
  options.progress = [&, time = options.time](double /*progress*/, const Message& activity) mutable {
    if (activity.english() == when.toStdString()) time.end();
  };
  const auto diagnosis = diagnose(rig.bench, {rig.recording}, {}, options);
  VERIFY_OK(diagnosis);
  const std::string words = inWords(*diagnosis);
  qInfo("%s", words.c_str());
  QCOMPARE(diagnosis->cutShort, cutShort);
  QCOMPARE(diagnosisJson(*diagnosis, true).find("cut_short") != std::string::npos, cutShort);
  QVERIFY2(words.find(remark.toStdString()) != std::string::npos, words.c_str());
  QVERIFY(!diagnosis->base.base.empty());
  if (sanitized) return;
  QVERIFY2(nameOf(diagnosis->verdict) == verdict.toStdString(), words.c_str());
  QCOMPARE(diagnosis->findings.size(), size_t(verdict == "undecided" ? 0 : 1));
  if (!diagnosis->findings.empty()) QCOMPARE(diagnosis->findings.front().effect, std::string("cogging"));
}

void TestDiagnose::noTime_leavesTheBaseModel() {
  const auto rig = recordRig({.positionTorque = "[[12, 0.003, 1.1]]", .seconds = secondsToFit(20.0)});
  DiagnoseOptions options;
  options.time = TimeLimit(0.0);
  const auto soon = diagnose(rig.bench, {rig.recording}, {}, options);
  VERIFY_OK(soon);
  QVERIFY(soon->cutShort);
  QCOMPARE(nameOf(soon->verdict), std::string("undecided"));
  QVERIFY(soon->findings.empty() && !soon->nextSentence.empty());
  const double inertia = *soon->base.baseValue("inertia_kg_m2");
  QVERIFY2(sanitized || within(inertia, 6e-5, 0.2), qPrintable(QString::number(inertia)));
}

void TestDiagnose::missingChannel_isOneClearLine() {
  auto rig = recordRig({.seconds = 2.0});
  rig.bench.input = DriveInput::current;
  const auto diagnosis = diagnose(rig.bench, {rig.recording}, {}, {});
  VERIFY_ERROR(diagnosis, "test.csv: has no column current_A, which drives this bench");
}

QTEST_APPLESS_MAIN(TestDiagnose)
#include "tst_diagnose.moc"
