// A column of the wrong scale or sign is the answer, with its factor; sound recordings get none.
#include <QTest>
#include <cmath>

#include "base/numbers.h"
#include "diagnose/diagnosis.h"
#include "recording/csv.h"
#include "recording/import/import.h"
#include "support/driven_recording.h"
#include "support/foreign_rig.h"
#include "support/known_servo.h"
#include "support/recorded_rig.h"
#include "support/sanitized.h"
#include "support/within.h"
#include "trial/sealed_trial.h"

using namespace breakaway;
using namespace breakaway::test;

class TestScaleCheck : public QObject {
  Q_OBJECT
 private slots:
  void wrongScale_isNamedWithItsFactor_data();
  void wrongScale_isNamedWithItsFactor();
  void wrongScale_isTheAnswerInPlaceOfPhysics();
  void angleInDegrees_costsNoTime();
  void wrongScaleUnderCurrentDrive_isNamedToo_data();
  void wrongScaleUnderCurrentDrive_isNamedToo();
  void wrongTorqueConstant_isTheBenchs_data();
  void wrongTorqueConstant_isTheBenchs();
  void currentOfTheOtherSign_isTheAnswerAndTurned();
  void otherSigns_areToldApart_data();
  void otherSigns_areToldApart();
  void honestBench_getsNoHeadline_data();
  void honestBench_getsNoHeadline();
  void voltageAlone_letsAnUntrustedBenchBeWrong();
  void bridgeThatLosesVoltage_isNoScale();
  void voltageOfEveryFifthRow_isNoSign();
  void moveOrTwo_areNoMistake();
  void currentThatIsOverWithinARow_isNoSign();
  void soundTrials_getNoHeadline_data();
  void soundTrials_getNoHeadline();
};

namespace {

std::string dataFile(const char* name) {
  return (qEnvironmentVariable("BREAKAWAY_SOURCE_DIR") + "/tests/data/scale/" + name).toStdString();
}

Recording scaled(const Recording& recording, const std::string& column, double factor) {
  std::vector<Channel> channels = recording.channels();
  for (Channel& one : channels) {
    if (one.name != column) continue;
    for (double& value : one.values) value *= factor;
  }
  return *Recording::seal(recording.name(), channels);
}

struct Case {
  Bench bench;
  Recording recording;
};

/// Eight seconds at 200 Hz, voltage and current, the angle as it is.
Case servo() {
  return {*readBench(dataFile("angle_times_four.bench.json")),
          scaled(*readCsv(dataFile("angle_times_four.csv")), "angle_rad", 0.25)};
}

ScaleCheck checked(const Bench& bench, const Recording& recording) {
  auto check = checkScales(bench, {recording});
  if (!check) qFatal("%s", check.error().message().c_str());
  if (check->misread) qInfo("%s", check->misread->sentence.c_str());
  for (const std::string& one : check->remarks) qInfo("remark: %s", one.c_str());
  return std::move(*check);
}

}  // namespace

void TestScaleCheck::wrongScale_isNamedWithItsFactor_data() {
  QTest::addColumn<QString>("column");
  QTest::addColumn<double>("factor");
  QTest::addColumn<QString>("words");
  QTest::newRow("edges") << "angle_rad" << 4.0 << "4 times too large, as with the encoder's lines";
  QTest::newRow("lines") << "angle_rad" << 0.25 << "4 times too small, as with the encoder's edges";
  QTest::newRow("degrees") << "angle_rad" << 57.29578 << "57.3 times too large, as in degrees";
  QTest::newRow("turns") << "angle_rad" << 1.0 / turn_rad << "6.283 times too small, as in turns";
  QTest::newRow("behind the gear") << "angle_rad" << 1.0 / 14.0 << "times too small, as behind a gear";
  QTest::newRow("before the gear") << "angle_rad" << 14.0 << "times too large, as behind a gear";
  QTest::newRow("rpm") << "angle_rad" << 9.5493 << "as from a speed in rpm";
  QTest::newRow("mA") << "current_A" << 1000.0 << "1000 times too large, as in mA";
  QTest::newRow("mV") << "voltage_V" << 1000.0 << "1000 times too large, as in mV";
}

void TestScaleCheck::wrongScale_isNamedWithItsFactor() {
  QFETCH(QString, column);
  QFETCH(double, factor);
  QFETCH(QString, words);
  Case rig = servo();
  for (const bool trusted : {true, false}) {
    rig.bench.trusted.clear();
    if (trusted) rig.bench.trusted.insert("torque_constant_Nm_per_A");
    const ScaleCheck check = checked(rig.bench, scaled(rig.recording, column.toStdString(), factor));
    QVERIFY(check.misread);
    QCOMPARE(QString::fromStdString(check.misread->what), column);
    QVERIFY2(within(check.misread->factor, factor, 0.03), check.misread->sentence.c_str());
    QVERIFY2(QString::fromStdString(check.misread->sentence).contains(words), check.misread->sentence.c_str());
  }
}

void TestScaleCheck::wrongScale_isTheAnswerInPlaceOfPhysics() {
  const Case rig = servo();
  const auto diagnosis = diagnose(rig.bench, {scaled(rig.recording, "angle_rad", 4.0)}, {}, {});
  QVERIFY(diagnosis);
  QCOMPARE(diagnosis->verdict, Verdict::undecided);
  QVERIFY(diagnosis->findings.empty());
  QCOMPARE(diagnosis->remarks.front(), diagnosis->misread->sentence);
  QVERIFY2(inWords(*diagnosis).starts_with("Misread: "), inWords(*diagnosis).c_str());
  // Of the recording with the angle put right.
  QVERIFY2(within(*diagnosis->base.baseValue("inertia_kg_m2"), 6e-5, 0.1), inWords(*diagnosis).c_str());
  QVERIFY2(within(*diagnosis->base.baseValue("back_emf_constant_V_s_per_rad"), 0.07, 0.05),
           inWords(*diagnosis).c_str());
  const auto right = diagnose(rig.bench, {rig.recording}, {}, {});
  QVERIFY(right && !right->misread);
  QCOMPARE(right->verdict, Verdict::nothingMissing);
}

void TestScaleCheck::angleInDegrees_costsNoTime() {
  const Case rig = servo();
  const auto diagnosis = diagnose(rig.bench, {scaled(rig.recording, "angle_rad", 57.29578)}, {}, {});
  QVERIFY(diagnosis && diagnosis->misread);
  QVERIFY2(diagnosis->cpu_s < 20.0, qPrintable(QString::number(diagnosis->cpu_s)));  // was more than 100 s
}

void TestScaleCheck::wrongScaleUnderCurrentDrive_isNamedToo_data() {
  QTest::addColumn<QString>("column");
  QTest::addColumn<double>("factor");
  QTest::addColumn<bool>("voltageToo");
  for (const bool both : {true, false}) {
    QTest::addRow("degrees, voltage %d", both) << "angle_rad" << 57.29578 << both;
    QTest::addRow("mA, voltage %d", both) << "current_A" << 1000.0 << both;
  }
  QTest::newRow("edges") << "angle_rad" << 4.0 << true;
}

void TestScaleCheck::wrongScaleUnderCurrentDrive_isNamedToo() {
  QFETCH(QString, column);
  QFETCH(double, factor);
  QFETCH(bool, voltageToo);
  const auto rig = recordRig({.seconds = 12.0, .currentDrive = true, .voltageToo = voltageToo});
  QVERIFY(!checked(rig.bench, rig.recording).misread);
  const ScaleCheck check = checked(rig.bench, scaled(rig.recording, column.toStdString(), factor));
  QVERIFY(check.misread);
  QCOMPARE(QString::fromStdString(check.misread->what), column);
  QVERIFY2(within(check.misread->factor, factor, 0.03), check.misread->sentence.c_str());
}

void TestScaleCheck::wrongTorqueConstant_isTheBenchs_data() {
  QTest::addColumn<double>("factor");
  QTest::addColumn<bool>("both");
  size_t row = 0;
  for (const double factor : {1000.0, 9.5493, 57.29578}) {
    if (!alsoRun(row++, 6)) continue;
    QTest::addRow("Kt and Ke, %g", factor) << factor << true;
    QTest::addRow("Kt, %g", factor) << factor << false;
  }
}

void TestScaleCheck::wrongTorqueConstant_isTheBenchs() {
  QFETCH(double, factor);
  QFETCH(bool, both);
  auto rig = recordRig({.seconds = 12.0, .currentDrive = true, .voltageToo = true});
  rig.bench.motor.torqueConstant = *rig.bench.motor.torqueConstant * factor;
  if (both) rig.bench.motor.backEmfConstant = rig.bench.motor.torqueConstant;
  const ScaleCheck check = checked(rig.bench, rig.recording);
  QVERIFY(check.misread && check.misread->ofBench);
  QVERIFY2(within(check.misread->factor, factor, 0.05), check.misread->sentence.c_str());
  QVERIFY(within(*mended(rig.bench, *check.misread).motor.torqueConstant, 0.07, 0.05));
}

void TestScaleCheck::currentOfTheOtherSign_isTheAnswerAndTurned() {
  const auto log = importRecording(dataFile("current_with_wrong_sign.csv"));
  QVERIFY(log);
  const Bench bench = *readBench(dataFile("current_with_wrong_sign.bench.json"));
  const auto diagnosis = diagnose(bench, {log->recording}, {}, {});
  QVERIFY(diagnosis && diagnosis->misread);
  const std::string words = inWords(*diagnosis);
  qInfo("%s", words.c_str());
  QVERIFY(words.substr(0, words.find('\n')).find("current_A has the other sign than the angle") != std::string::npos);
  QVERIFY(within(*diagnosis->base.baseValue("inertia_kg_m2"), 0.02, 0.3));
  // It moves at one speed, 4.77 rad/s: what shows is friction there, of which Coulomb is 0.9 Nm.
  const auto part = [&](const char* name) { return *diagnosis->base.baseValue(name); };
  QVERIFY(within(part("coulomb_Nm") + 4.77 * part("viscous_Nm_s_per_rad"), 0.9 + 4.77 * 0.02, 0.1));
  for (const Parameter& one : diagnosis->base.base) {
    if (one.name == "coulomb_Nm") QVERIFY(one.low95 < 0.9 && one.high95 > 0.9 && one.high95 < 2.0);
  }
  const auto turned = checked(bench, scaled(log->recording, "current_A", -1.0));
  QVERIFY(!turned.misread && turned.remarks.empty());
}

void TestScaleCheck::otherSigns_areToldApart_data() {
  QTest::addColumn<QString>("column");
  QTest::addColumn<bool>("currentDrive");
  QTest::addColumn<bool>("both");
  QTest::newRow("angle, voltage and current") << "angle_rad" << true << true;
  QTest::newRow("current beside voltage") << "current_A" << true << true;
  QTest::newRow("voltage beside current") << "voltage_V" << true << true;
  QTest::newRow("current alone") << "current_A" << true << false;
  QTest::newRow("voltage alone") << "voltage_V" << false << false;
}

void TestScaleCheck::otherSigns_areToldApart() {
  QFETCH(QString, column);
  QFETCH(bool, currentDrive);
  QFETCH(bool, both);
  const auto rig = recordRig({.seconds = 12.0, .currentDrive = currentDrive, .voltageToo = both});
  QVERIFY(!checked(rig.bench, rig.recording).misread);
  const ScaleCheck check = checked(rig.bench, scaled(rig.recording, column.toStdString(), -1.0));
  QVERIFY(check.misread);
  QCOMPARE(QString::fromStdString(check.misread->what), column);
  QCOMPARE(check.misread->factor, -1.0);
}

void TestScaleCheck::honestBench_getsNoHeadline_data() {
  QTest::addColumn<double>("constant");
  QTest::addColumn<double>("resistance");
  QTest::addColumn<double>("inertia");
  QTest::newRow("exact") << 1.0 << 1.0 << 1.0;
  QTest::newRow("magnets, copper, a load") << 1.2 << 0.6 << 0.25;
  QTest::newRow("the other way") << 0.8 << 1.5 << 3.0;
}

void TestScaleCheck::honestBench_getsNoHeadline() {
  QFETCH(double, constant);
  QFETCH(double, resistance);
  QFETCH(double, inertia);
  Case rig = servo();
  MotorBelief& motor = rig.bench.motor;
  motor.torqueConstant = motor.backEmfConstant = 0.07 * constant;
  motor.resistance_ohm = 1.2 * resistance;
  motor.inertia = 6e-5 * inertia;
  const ScaleCheck check = checked(rig.bench, rig.recording);
  QVERIFY(!check.misread && check.remarks.empty());
}

void TestScaleCheck::voltageAlone_letsAnUntrustedBenchBeWrong() {
  auto rig = recordRig({.seconds = 12.0});
  rig.bench.trusted.clear();
  rig.bench.motor.resistance_ohm = 5.0;
  rig.bench.motor.torqueConstant = rig.bench.motor.backEmfConstant = 0.05;
  QVERIFY(!checked(rig.bench, rig.recording).misread);
}

void TestScaleCheck::bridgeThatLosesVoltage_isNoScale() {
  Model model = servoWith(DriveInput::voltage, "dead_time", {0.5, 0.02});
  Bench bench;
  bench.input = DriveInput::voltage;
  bench.motor = {0.07, 0.07, 1.2, 0.0011, 6e-5, {}, {}};
  bench.trusted = {"torque_constant_Nm_per_A"};
  QVERIFY(!checked(bench, drivenRecording(model, {.seconds = 10.0, .size = 4.0})).misread);
}

/// A loop of 1 kHz, of which every fifth row was kept: what acted between them isn't known, and voltage and current
/// seem to disagree in sign. But current and angle agree, and so do voltage and angle.
void TestScaleCheck::voltageOfEveryFifthRow_isNoSign() {
  const auto first = readCsv(dataFile("every_fifth_row_1.csv")), second = readCsv(dataFile("every_fifth_row_2.csv"));
  QVERIFY(first && second);
  const auto check = checkScales(*readBench(dataFile("every_fifth_row.bench.json")), {*first, *second});
  QVERIFY(check);
  QVERIFY2(!check->misread, check->misread ? check->misread->sentence.c_str() : "");
}

/// A rotor that follows the voltage within a fifth of a row: what the current is between is of the other sign as often
/// as not.
void TestScaleCheck::currentThatIsOverWithinARow_isNoSign() {
  const ForeignRig rig = foreignRig("winding_heating", 47);
  const auto check = checkScales(rig.bench, rig.recordings, {});
  QVERIFY2(check && !check->misread, rig.words.c_str());
}

/// An axis that moves twice within 32 s, from one cogging well to the next: too little to tell a constant by.
void TestScaleCheck::moveOrTwo_areNoMistake() {
  const ForeignRig rig = foreignRig("cogging", 56);
  const auto check = checkScales(rig.bench, rig.recordings, {});
  QVERIFY2(check && !check->misread, rig.words.c_str());
}

void TestScaleCheck::soundTrials_getNoHeadline_data() {
  QTest::addColumn<QString>("family");
  size_t row = 0;
  for (const std::string& one : trialFamilies()) {
    if (alsoRun(row++, 3)) QTest::newRow(one.c_str()) << QString::fromStdString(one);
  }
}

void TestScaleCheck::soundTrials_getNoHeadline() {
  QFETCH(QString, family);
  for (std::uint64_t seed = 1; seed <= (thorough() ? 2 : 1); ++seed) {
    const SealedTrial trial = makeTrial(family.toStdString(), seed, {.duration_s = 12.0});
    const auto check = checkScales(trial.bench, trial.recordings);
    if (!check) continue;
    QVERIFY2(!check->misread,
             qPrintable(QString("seed %1: %2")
                            .arg(seed)
                            .arg(QString::fromStdString(check->misread ? check->misread->sentence.english() : ""))));
    for (const std::string& one : check->remarks) qInfo("seed %u: %s", static_cast<unsigned>(seed), one.c_str());
  }
}

QTEST_GUILESS_MAIN(TestScaleCheck)
#include "tst_scale_check.moc"
