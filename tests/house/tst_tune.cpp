// `breakaway tune` as a person runs it: files, words, and what it refuses.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "house/program.h"
#include "motor/bench.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestTune : public QObject {
  Q_OBJECT
 private slots:
  void tuning_leavesItsFiles();
  void stiffness_changesTheGains();
  void bandwidths_areTakenAsGiven();
  void moreDoubt_isSaidAndCostsGain();
  void motorWithoutWinding_isTunedWithAnIdealCurrent();
  void contradiction_isGoneOnWithAndStaysInTheFile();
  void linearAxis_isTunedInItsOwnUnits();
  void wrongInput_getsOneLine_data();
  void wrongInput_getsOneLine();
};

namespace {

const char* const servo =
    R"({"schema": "breakaway.bench/1", "name": "a servo", "encoder": {"counts_per_rev": 14400},
        "drive": {"input": "current_A", "supply_V": 24}, "motor": {"torque_constant_Nm_per_A": 0.07,
        "resistance_ohm": 1.2, "inductance_H": 0.0011, "inertia_kg_m2": 6e-5},
        "controller": {"mode": "open_loop", "current_limit_A": 4}})";

Outcome tune(const TemporaryFolder& folder, const QString& words) {
  return run(builtProgram("breakaway"), ("tune " + words).split(' ', Qt::SkipEmptyParts),
             QString::fromStdString(folder.path()));
}

QByteArray contentOf(const TemporaryFolder& folder, const QString& name) {
  QFile file(QString::fromStdString(folder.path()) + "/" + name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QJsonObject tuningIn(const TemporaryFolder& folder, const QString& name) {
  return QJsonDocument::fromJson(contentOf(folder, name + "/tuning.json")).object();
}

/// The value that `path`, names with slashes between, leads to.
QJsonValue valueAt(const QJsonObject& object, const QString& path) {
  QJsonValue value = object;
  for (const QString& name : path.split('/')) value = value.toObject().value(name);
  return value;
}

double cutoffIn(const TemporaryFolder& folder, const QString& name) {
  return valueAt(tuningIn(folder, name), "cutoff/chosen_rad_per_s").toDouble();
}

}  // namespace

void TestTune::tuning_leavesItsFiles() {
  const TemporaryFolder folder;
  folder.write("b.json", servo);
  const Outcome outcome = tune(folder, "--bench b.json --out t");
  QVERIFY2(outcome.status == 0 && outcome.err.isEmpty(), qPrintable(outcome.err));
  for (const char* words : {"Tuned medium", "gain margin", "phase margin", "αgT", "Noise", "mNm rms",
                            "Speed observer: ", "chosen", "(the boards' own)", "Current loop: ", "current mA rms"})
    QVERIFY2(outcome.out.contains(QString::fromUtf8(words)), words);
  const QJsonObject json = tuningIn(folder, "t");
  QCOMPARE(json["schema"].toString(), QString("breakaway.tuning/1"));
  QCOMPARE(json["corners"].toArray().size(), qsizetype{4});
  const QJsonObject worst = valueAt(json, "velocity/worst").toObject();
  QVERIFY(worst["stable"].toBool() && worst["gain_margin"].toDouble() >= 3.0);
  QVERIFY(worst["phase_margin_rad"].toDouble() >= 0.785 && worst["peak_sensitivity"].toDouble() <= 1.6);
  const auto bench = readBench(folder.path() + "/t/bench.json");
  QVERIFY2(bench.ok(), bench.ok() ? "" : bench.error().message().c_str());
  QVERIFY(bench->controller.mode == ControlMode::velocity);
  QCOMPARE(bench->controller.kp, valueAt(json, "controller/kp_A_s_per_rad").toDouble());
  QCOMPARE(bench->controller.observerCutoff_rad_per_s, cutoffIn(folder, "t"));
  QCOMPARE(bench->controller.currentLimit_A, 4.0);
  QCOMPARE(*bench->motor.inertia, 6e-5);
  for (const char* name : {"root_locus", "root_locus_s", "loop_gain", "loop_phase", "sensitivity", "load", "noise",
                           "speed_observer", "current_loop"})
    QVERIFY2(contentOf(folder, QString("t/figures/%1.svg").arg(name)).startsWith("<svg"), name);
  QCOMPARE(contentOf(folder, "t/root_locus.csv").count('\n'), qsizetype{301});
  QCOMPARE(contentOf(folder, "t/response.csv").count('\n'), qsizetype{401});
  QCOMPARE(contentOf(folder, "t/noise.csv").count('\n'), qsizetype{61});
  QCOMPARE(contentOf(folder, "t/speed_observer.csv").count('\n'), qsizetype{15});
  QCOMPARE(contentOf(folder, "t/current_loop.csv").count('\n'), qsizetype{15});
  QCOMPARE(valueAt(json, "speed_observer/source").toString(), QString("chosen"));
  QCOMPARE(valueAt(json, "speed_observer/bandwidth_rad_per_s"), valueAt(json, "loop/velocity_bandwidth_rad_per_s"));
  QCOMPARE(valueAt(json, "current_loop/bandwidth_rad_per_s"), valueAt(json, "loop/current_bandwidth_rad_per_s"));
  QCOMPARE(valueAt(json, "speed_observer/board_rad_per_s").toDouble(), 400.0);
  QVERIFY(valueAt(json, "noise/current_reference_rms_A").toDouble() <= 1.001 * 0.02 * 4.0);
}

void TestTune::stiffness_changesTheGains() {
  const TemporaryFolder folder;
  folder.write("b.json", servo);
  for (const char* name : {"soft", "stiff"})
    QCOMPARE(tune(folder, QString("--bench b.json --stiffness %1 --out %1").arg(name)).status, 0);
  QVERIFY(cutoffIn(folder, "stiff") > 1.5 * cutoffIn(folder, "soft"));
}

void TestTune::bandwidths_areTakenAsGiven() {
  const TemporaryFolder folder;
  folder.write("b.json", servo);
  const Outcome given = tune(folder, "--bench b.json --out g --velocity-bandwidth 700 --current-bandwidth 450");
  QVERIFY2(given.status == 0 && given.out.contains("Speed observer: 700 rad/s, given"), qPrintable(given.out));
  QCOMPARE(valueAt(tuningIn(folder, "g"), "loop/velocity_bandwidth_rad_per_s").toDouble(), 700.0);
  QCOMPARE(valueAt(tuningIn(folder, "g"), "loop/current_bandwidth_rad_per_s").toDouble(), 450.0);
  const Outcome boards = tune(folder, "--bench b.json --out b --board-bandwidths");
  QVERIFY2(boards.out.contains("Current loop: 300 rad/s, as Breakaway's own boards have it"), qPrintable(boards.out));
  QCOMPARE(valueAt(tuningIn(folder, "b"), "speed_observer/source").toString(), QString("board"));
  // Whoever sets the others on a board that can't be set so is told.
  QVERIFY2(given.out.contains("gains for one that can't be with --board-bandwidths"), qPrintable(given.out));
  QVERIFY2(!boards.out.contains("gains for those"), qPrintable(boards.out));
}

void TestTune::moreDoubt_isSaidAndCostsGain() {
  const TemporaryFolder folder;
  folder.write("b.json", servo);
  QCOMPARE(tune(folder, "--bench b.json --out sure --inertia-error 0 --torque-constant-error 0").status, 0);
  const Outcome unsure = tune(folder, "--bench b.json --out unsure --inertia-error 20");
  QVERIFY2(unsure.out.contains("inertia ±20 %"), qPrintable(unsure.out));
  QVERIFY(cutoffIn(folder, "unsure") < 0.9 * cutoffIn(folder, "sure"));
}

void TestTune::motorWithoutWinding_isTunedWithAnIdealCurrent() {
  const TemporaryFolder folder;
  folder.write("b.json", QByteArray(servo).replace("\"inductance_H\": 0.0011, ", "").toStdString());
  const Outcome outcome = tune(folder, "--bench b.json --out t");
  QCOMPARE(outcome.status, 0);
  QVERIFY(outcome.out.contains("taken as ideal"));
  QCOMPARE(valueAt(tuningIn(folder, "t"), "loop/current_path").toString(), QString("ideal"));
}

void TestTune::contradiction_isGoneOnWithAndStaysInTheFile() {
  const TemporaryFolder folder;
  folder.write("b.json",
               QByteArray(servo).replace("0.07,", "0.15, \"back_emf_constant_V_s_per_rad\": 0.07,").toStdString());
  const Outcome outcome = tune(folder, "--bench b.json --out t --anyway");
  QVERIFY2(outcome.status == 0 && outcome.out.contains("In spite of a contradiction"), qPrintable(outcome.err));
  const auto bench = readBench(folder.path("t/bench.json"));
  QVERIFY(bench.ok() && bench->remarks.size() == 1);
}

void TestTune::linearAxis_isTunedInItsOwnUnits() {
  const TemporaryFolder folder;
  folder.write("b.json", R"({"schema": "breakaway.bench/1", "axis": "linear", "encoder": {"counts_per_m": 1000000},
      "drive": {"input": "current_A", "supply_V": 24}, "motor": {"force_constant_N_per_A": 14, "resistance_ohm": 2.2,
      "back_emf_constant_V_s_per_m": 14, "inductance_H": 0.0021, "mass_kg": 1.8},
      "controller": {"mode": "open_loop", "current_limit_A": 4}})");
  const Outcome outcome = tune(folder, "--bench b.json --out t");
  QVERIFY2(outcome.status == 0 && outcome.err.isEmpty(), qPrintable(outcome.err));
  QVERIFY(outcome.out.contains(" A s/m") && outcome.out.contains("mass ±") && !outcome.out.contains("Nm"));
  QCOMPARE(valueAt(tuningIn(folder, "t"), "motor/mass_kg/value").toDouble(), 1.8);
  QVERIFY(contentOf(folder, "t/noise.csv").startsWith("cutoff_rad_per_s,disturbance_estimate_rms_N,"));
  QVERIFY(contentOf(folder, "t/response.csv").contains("velocity_yielding_m_per_s_per_N"));
  const auto bench = readBench(folder.path() + "/t/bench.json");
  QVERIFY2(bench.ok(), bench.ok() ? "" : bench.error().message().c_str());
  QVERIFY(bench->axis == Axis::linear && bench->controller.mode == ControlMode::velocity);
  // As fast as a rotor's loop with the same tick: J·w/Kt is a gain of its own unit.
  const double bandwidth = bench->controller.kp * 14.0 / 1.8;
  QVERIFY2(bandwidth > 20.0 && bandwidth < 200.0, qPrintable(QString::number(bandwidth)));
}

void TestTune::wrongInput_getsOneLine_data() {
  QTest::addColumn<QString>("words");
  QTest::addColumn<QByteArray>("bench");
  QTest::addColumn<QString>("line");
  const QByteArray good = servo;
  QTest::newRow("no such stiffness") << "--bench b.json --stiffness hard --out t" << good
                                     << "--stiffness: hard not in {soft,medium,stiff}";
  QTest::newRow("no inertia") << "--bench b.json --out t" << QByteArray(good).replace(", \"inertia_kg_m2\": 6e-5", "")
                              << "b.json, field motor.inertia_kg_m2: is missing";
  QTest::newRow("linear") << "--bench b.json --out t" << QByteArray(R"({"schema": "breakaway.bench/1", "axis": "linear",
                              "drive": {"input": "force_N"}, "motor": {"mass_kg": 2}})")
                          << "b.json, field motor.force_constant_N_per_A: is missing";
  QTest::newRow("tick") << "--bench b.json --out t --tick-s 0" << good << "--tick-s";
  QTest::newRow("doubt") << "--bench b.json --out t --inertia-error 120" << good << "--inertia-error";
  QTest::newRow("inertia in g cm2") << "--bench b.json --out t" << QByteArray(good).replace("6e-5", "600")
                                    << "b.json, field motor.inertia_kg_m2: is 600: with resistance_ohm 1.2";
  QTest::newRow("mNm/A") << "--bench b.json --out t"
                         << QByteArray(good).replace("0.07,", "70, \"back_emf_constant_V_s_per_rad\": 0.07,")
                         << "field motor.torque_constant_Nm_per_A: is 70, but back_emf_constant_V_s_per_rad is 0.07: "
                            "the first is 1000 times as much, as in mNm/A";
  QTest::newRow("no bench") << "--bench c.json --out t" << good << "c.json: cannot be read";
}

void TestTune::wrongInput_getsOneLine() {
  QFETCH(QString, words);
  QFETCH(QByteArray, bench);
  QFETCH(QString, line);
  const TemporaryFolder folder;
  folder.write("b.json", bench.toStdString());
  const Outcome outcome = tune(folder, words);
  QCOMPARE(outcome.status, 2);
  QVERIFY2(outcome.err.count('\n') == 1 && outcome.err.startsWith("breakaway: "), qPrintable(outcome.err));
  QVERIFY2(outcome.err.contains(line), qPrintable(outcome.err));
  QVERIFY(outcome.out.isEmpty());
  QCOMPARE(folder.names(), QStringList{"b.json"});
}

QTEST_APPLESS_MAIN(TestTune)
#include "tst_tune.moc"
