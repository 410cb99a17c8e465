#include <QTest>
#include <cmath>
#include <numbers>

#include "base/statistics.h"
#include "diagnose/diagnosed.h"
#include "diagnose/fit/cross_validation.h"
#include "diagnose/fit/noise_floor.h"
#include "diagnose/search/window_slope.h"
#include "support/driven_recording.h"
#include "support/known_servo.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

/// Rigs whose physics or bench leads a regression, a start or a bound astray.
class TestDiagnoseRigs : public QObject {
  Q_OBJECT
 private slots:
  void benchWithoutResistance_isScaledByItsInertia();
  void supplyThatGivesWayByHalf_isNamed();
  void voltageBesideTheCurrent_tellsSensorFromLoad();
  void frictionOfTheKnownLoadAlone_isLoadDependent();
  void severalPushes_areOneFinding_data();
  void severalPushes_areOneFinding();
  void pushBesideImbalance_hidesNeither();
  void stopsAtBothEnds_areOneFinding_data();
  void stopsAtBothEnds_areOneFinding();
  void slopesOfWindows_showWhatIsThereAndNothingElse();
  void axisThatStands_makesNoOutliersOfTheOthers();
  void crossValidation_startsWhereTheFitEnded();
  void slopesOfWindows_showInWhichRecordingAPushWas();
  void nearTheTop_aWindowMayErrMore();
};

namespace {

constexpr double count = 2.0 * std::numbers::pi / 8192.0;

/// What an encoder of 8192 counts and a current sensor's noise make of a recording.
Recording read(const Recording& exact) {
  Random random(7);
  std::vector<Channel> channels;
  for (const Channel& channel : exact.channels()) {
    channels.push_back(channel);
    for (double& one : channels.back().values) {
      if (channel.name == "angle_rad") one = count * std::floor(one / count);
      if (channel.name == "current_A") one += 0.01 * random.normal();
    }
  }
  return *Recording::seal("rig.csv", channels);
}

Bench benchOf(const Model& model) {
  Bench bench;
  bench.input = model.input;
  bench.supply_V = 24.0;
  bench.countsPerUnit = 8192.0;
  const auto value = [&model](const char* name) { return model.baseValue(name); };
  bench.motor.torqueConstant = value("torque_constant_Nm_per_A");
  bench.motor.backEmfConstant = value("back_emf_constant_V_s_per_rad");
  bench.motor.resistance_ohm = value("resistance_ohm");
  bench.motor.inductance_H = value("inductance_H");
  bench.motor.inertia = 1.2 * *value("inertia_kg_m2");
  bench.trusted = {"torque_constant_Nm_per_A"};
  return bench;
}

Diagnosis diagnosedAlone(const Bench& bench, const Recording& recording) {
  const auto diagnosis = diagnose(bench, {recording}, {}, {});
  if (!diagnosis) qFatal("%s", diagnosis.error().message().c_str());
  qInfo("%s", inWords(*diagnosis).c_str());
  return *diagnosis;
}

}  // namespace

void TestDiagnoseRigs::benchWithoutResistance_isScaledByItsInertia() {
  if (sanitized) QSKIP(likeOthers);
  auto rig = recordRig({.positionTorque = "[[12, 0.003, 1.1]]", .seconds = secondsToFit(20.0)});
  rig.bench.motor.resistance_ohm.reset();
  rig.bench.motor.inertia = 1.1 * 6e-5;
  const Diagnosis diagnosis = diagnosedAlone(rig.bench, rig.recording);
  QCOMPARE(diagnosis.findings.size(), size_t(1));
  QCOMPARE(diagnosis.findings.front().effect, std::string("cogging"));
  const double amplitude = std::abs(parameter(diagnosis.findings.front(), "amplitude_Nm"));
  QVERIFY2(within(amplitude, 1.1 * 0.003, 0.1), qPrintable(QString::number(amplitude)));
  const bool said = std::any_of(diagnosis.remarks.begin(), diagnosis.remarks.end(), [](const std::string& one) {
    return one.find("inertia_kg_m2 (it doesn't say the resistance)") != std::string::npos;
  });
  QVERIFY2(said, inWords(diagnosis).c_str());
}

void TestDiagnoseRigs::supplyThatGivesWayByHalf_isNamed() {
  const double sag_ohm = 1.0;
  Model model = servoWith(DriveInput::voltage, "supply_sag", {sag_ohm, 24.0});
  model.supply_V = 24.0;
  const double unit = frictionInput(model);
  const Recording recording =
      read(drivenRecording(model, {.seconds = secondsToFit(20.0), .hold_s = 0.05, .size = 6.0 / unit}));
  const Diagnosis diagnosis = diagnosedAlone(benchOf(model), recording);
  if (sanitized) return;
  QCOMPARE(diagnosis.findings.size(), size_t(1));
  QCOMPARE(diagnosis.findings.front().effect, std::string("supply_sag"));
  QVERIFY2(within(parameter(diagnosis.findings.front(), "resistance_ohm"), sag_ohm, 0.1), inWords(diagnosis).c_str());
}

void TestDiagnoseRigs::voltageBesideTheCurrent_tellsSensorFromLoad() {
  const double offset_A = 0.04;
  for (const bool ofSensor : {true, false}) {
    RigRecording wanted{.seconds = secondsToFit(20.0), .currentDrive = true, .voltageToo = true};
    (ofSensor ? wanted.currentOffset_A : wanted.asymmetry) = ofSensor ? offset_A : 0.4;
    const auto rig = recordRig(wanted);
    const Diagnosis diagnosis = diagnosedAlone(rig.bench, rig.recording);
    if (sanitized) return;
    QCOMPARE(diagnosis.findings.size(), size_t(1));
    const Finding& finding = diagnosis.findings.front();
    QCOMPARE(finding.effect, std::string(ofSensor ? "current_sensor_offset" : "constant_load"));
    QCOMPARE(nameOf(diagnosis.verdict), std::string("named"));
    if (ofSensor) QVERIFY2(within(parameter(finding, "offset_A"), offset_A, 0.1), inWords(diagnosis).c_str());
  }
}

void TestDiagnoseRigs::frictionOfTheKnownLoadAlone_isLoadDependent() {
  Model model = servoWith(DriveInput::voltage, "load_dependent_friction", {0.3, 1.0});
  model.pendulum = Pendulum{0.1, 0.04, 0.0, 0.0};  // 39 mNm at the most, thrice the friction
  const Recording recording =
      read(drivenRecording(model, {.seconds = secondsToFit(20.0), .hold_s = 0.02, .size = 6.0}));
  Bench bench = benchOf(model);
  bench.pendulum = model.pendulum;
  const Diagnosis diagnosis = diagnosedAlone(bench, recording);
  if (sanitized) return;
  QCOMPARE(diagnosis.findings.size(), size_t(1));
  const Finding& finding = diagnosis.findings.front();
  QCOMPARE(finding.effect, std::string("load_dependent_friction"));
  QCOMPARE(parameter(finding, "known_load_part"), 1.0);
  QVERIFY2(within(parameter(finding, "coefficient"), 0.3, 0.1), inWords(diagnosis).c_str());
}

void TestDiagnoseRigs::severalPushes_areOneFinding_data() {
  QTest::addColumn<double>("first_Nm");
  QTest::addColumn<double>("second_Nm");
  QTest::newRow("a third of the friction") << 0.004 << -0.003;
  QTest::newRow("two thirds of it") << 0.008 << -0.006;
}

void TestDiagnoseRigs::severalPushes_areOneFinding() {
  if (sanitized) QSKIP(likeOthers);
  QFETCH(double, first_Nm);
  QFETCH(double, second_Nm);
  Model model = servoWith(DriveInput::voltage, "external_disturbance", {first_Nm, 3.1, 1.7});
  const Effect& push = *findEffect("external_disturbance");
  model.effects.push_back(effectTerm(push, {second_Nm, 9.4, 2.3}));
  const Recording recording =
      read(drivenRecording(model, {.seconds = secondsToFit(20.0), .hold_s = 0.02, .size = 4.0}));
  const Diagnosis diagnosis = diagnosedAlone(benchOf(model), recording);
  QCOMPARE(diagnosis.findings.size(), size_t(1));
  const Finding& finding = diagnosis.findings.front();
  QCOMPARE(finding.effect, std::string("external_disturbance"));
  const bool inOrder = parameter(finding, "start_s") < parameter(finding, "start2_s");
  const auto valueOf = [&](const char* one, const char* other) { return parameter(finding, inOrder ? one : other); };
  QVERIFY2(within(valueOf("torque_Nm", "torque2_Nm"), first_Nm, 0.1), inWords(diagnosis).c_str());
  QVERIFY2(within(valueOf("torque2_Nm", "torque_Nm"), second_Nm, 0.1), inWords(diagnosis).c_str());
  QVERIFY2(within(valueOf("start2_s", "start_s"), 9.4, 0.03), inWords(diagnosis).c_str());
}

void TestDiagnoseRigs::pushBesideImbalance_hidesNeither() {
  Model model = servoWith(DriveInput::voltage, "external_disturbance", {0.009, 5.2, 1.6});
  model.effects.push_back(effectTerm(*findEffect("imbalance"), {0.003, 0.7, 1.0}));
  const Recording recording =
      read(drivenRecording(model, {.seconds = secondsToFit(20.0), .hold_s = 0.02, .size = 4.0}));
  const Diagnosis diagnosis = diagnosedAlone(benchOf(model), recording);
  if (sanitized) return;
  QCOMPARE(diagnosis.findings.size(), size_t(2));
  for (const Finding& finding : diagnosis.findings) {
    const bool push = finding.effect == "external_disturbance";
    if (!push) QCOMPARE(finding.effect, std::string("imbalance"));
    const double size = std::abs(parameter(finding, push ? "torque_Nm" : "amplitude_Nm"));
    QVERIFY2(within(size, push ? 0.009 : 0.003, 0.1), inWords(diagnosis).c_str());
  }
}

void TestDiagnoseRigs::stopsAtBothEnds_areOneFinding_data() {
  QTest::addColumn<double>("stiffness_Nm_per_rad");
  QTest::newRow("firm") << 0.6;
  if (!sanitized) QTest::newRow("soft") << 0.08;
}

void TestDiagnoseRigs::stopsAtBothEnds_areOneFinding() {
  QFETCH(double, stiffness_Nm_per_rad);
  Model model = servoWith(DriveInput::voltage, "end_stop", {stiffness_Nm_per_rad, 2.0, 1.0, 4e-3});
  model.effects.push_back(effectTerm(*findEffect("end_stop"), {stiffness_Nm_per_rad, -2.4, -1.0, 4e-3}));
  const Recording recording =
      read(drivenRecording(model, {.seconds = secondsToFit(20.0), .hold_s = 0.01, .size = 3.0}));
  const Diagnosis diagnosis = diagnosedAlone(benchOf(model), recording);
  if (sanitized) return;
  QVERIFY(!diagnosis.findings.empty());
  const Finding& finding = diagnosis.findings.front();
  QCOMPARE(finding.effect, std::string("end_stop"));
  for (const char* name : {"stiffness_Nm_per_rad", "stiffness2_Nm_per_rad"})
    QVERIFY2(within(std::abs(parameter(finding, name)), stiffness_Nm_per_rad, 0.1), inWords(diagnosis).c_str());
}

void TestDiagnoseRigs::slopesOfWindows_showWhatIsThereAndNothingElse() {
  const double drag = 2e-6;
  for (const bool there : {true, false}) {
    const Model model =
        there ? servoWith(DriveInput::voltage, "quadratic_drag", {drag}) : servoModel(DriveInput::voltage);
    const Recording recording = read(drivenRecording(model, {.seconds = 12.0, .hold_s = 0.05, .size = 5.0}));
    const auto prepared = prepare(benchOf(model), {recording}, {}, 0.5);
    VERIFY_OK(prepared);
    const SearchInput input(*prepared, 1);
    const FitResult base = fitBase(input, prepared->starts);
    const SlopePick shown = slopePick(input, base, *findEffect("quadratic_drag"));
    const QString what = QString("%1: %2").arg(there).arg(shown.part);
    QVERIFY2(there ? shown.part > 0.5 && shown.part <= 1.0 : shown.part < 0.2, qPrintable(what));
    if (there) QVERIFY2(within(shown.pick.parameters.front(), drag, 0.3), qPrintable(what));
  }
}

/// Most windows of an axis that mostly stands err by nothing: the others are what is usual, and not all of them
/// outliers.
void TestDiagnoseRigs::axisThatStands_makesNoOutliersOfTheOthers() {
  const std::vector<double> weights = robustWeights({0.0, 1e-12, 0.0, 1e-4, 0.0, 2e-4, 0.0, 1.0});
  QCOMPARE(weights[3], 1.0);
  QCOMPARE(weights[5], 1.0);
  QVERIFY(weights[7] < 0.1 && weights[7] > 0.0);
  QCOMPARE(robustWeights({0.0, 0.0}), (std::vector<double>{1.0, 1.0}));
}

/// An effect that starts at a tenth of its size: what is left out is simulated with what the fit ended at, not with the
/// size times ten.
void TestDiagnoseRigs::crossValidation_startsWhereTheFitEnded() {
  const double drag = 2e-6;
  const Model model = servoWith(DriveInput::voltage, "quadratic_drag", {drag});
  const Recording recording = read(drivenRecording(model, {.seconds = 12.0, .hold_s = 0.05, .size = 5.0}));
  const auto prepared = prepare(benchOf(model), {recording}, {}, 0.5);
  VERIFY_OK(prepared);
  const SearchInput input(*prepared, 1);
  const Model start = servoWith(DriveInput::voltage, "quadratic_drag", {0.1 * drag});
  const FitResult fit = fitWindows(vectorOf(input, start), input.tracks, input.split.train, {});
  QVERIFY(within(fit.model.effects[0].parameters[0].value, drag, 0.05));
  const double unseen = mean(
      crossValidated(fit, input.tracks, input.split.train, input.windowWeights, input.split.fold, folds, {1.0, 0.0}));
  QVERIFY2(unseen < 3.0 * mean(fit.windowSquares),
           qPrintable(QString("%1 for %2").arg(unseen).arg(mean(fit.windowSquares))));
}

void TestDiagnoseRigs::slopesOfWindows_showInWhichRecordingAPushWas() {
  const double torque = 0.006;
  std::vector<Recording> recordings;
  for (const bool there : {false, true}) {
    const Model model = there ? servoWith(DriveInput::voltage, "external_disturbance", {torque, 4.0, 1.5})
                              : servoModel(DriveInput::voltage);
    const Recording exact = read(drivenRecording(model, {.seconds = 12.0, .hold_s = 0.05, .size = 5.0}));
    recordings.push_back(*Recording::seal(there ? "pushed.csv" : "untouched.csv", exact.channels()));
  }
  const auto prepared = prepare(benchOf(servoModel(DriveInput::voltage)), recordings, {}, 0.5);
  VERIFY_OK(prepared);
  const SearchInput input(*prepared, 1);
  const FitResult base = fitBase(input, prepared->starts);
  const SlopePick shown = slopePick(input, base, *findEffect("external_disturbance"));
  QCOMPARE(shown.pick.track, size_t(1));
  QVERIFY2(shown.part > 0.3, qPrintable(QString::number(shown.part)));
  QVERIFY2(within(shown.pick.parameters.front(), torque, 0.4), qPrintable(QString::number(shown.pick.parameters[0])));
}

/// A pendulum that is left to itself falls from near its top one way or the other, but hangs where it hangs.
void TestDiagnoseRigs::nearTheTop_aWindowMayErrMore() {
  Model model = servoModel(DriveInput::torque);
  model.count = count;
  model.pendulum = Pendulum{0.05, 0.1, 0.0, 0.0};
  std::vector<double> time, torque, angle;
  for (int k = 0; k < 2000; ++k) {
    time.push_back(1e-3 * k);
    torque.push_back(k % 500 < 250 ? 0.02 : -0.02);
    angle.push_back(k < 1000 ? std::numbers::pi : 0.0);  // standing on the top, then hanging
  }
  const auto recording =
      *Recording::seal("pendulum.csv", {{"time_s", time}, {"angle_rad", angle}, {"torque_Nm", torque}});
  const std::vector<Track> tracks{*makeTrack(recording, model.axis, model.input, std::nullopt, model.count)};
  const std::vector<Window> windows{{0, 200, 700}, {0, 1200, 1700}};
  const auto usual = usualSquares(model, tracks, windows, 1, {.relative = 0.01, .speed = 1.0});
  QCOMPARE(usual.size(), size_t(2));
  QVERIFY2(usual[0] > 4.0 * usual[1] && usual[1] > 0.0, qPrintable(QString("%1 %2").arg(usual[0]).arg(usual[1])));
}

QTEST_APPLESS_MAIN(TestDiagnoseRigs)
#include "tst_diagnose_rigs.moc"
