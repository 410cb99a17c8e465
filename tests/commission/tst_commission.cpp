#include <QTest>

#include "commission/commission.h"
#include "diagnose/diagnosis.h"
#include "diagnose/fit/scale_check.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_truth.h"
#include "recording/csv.h"
#include "report/commission_report.h"
#include "support/map_accuracy.h"
#include "support/random_rig.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway;

class TestCommission : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void presetServo_isMappedWithinFivePercent();
  void presetServo_isIdentified();
  void presetServo_showsOverWhichSpeedFrictionFalls();
  void presetServo_gainsFromItsMap();
  void presetServo_isLeftWithTheControllerOfItsBenchFile();
  void presetServo_staysWithinTwentyMinutes();
  void files_areAllThereAndReadBack();
  void ownRecordings_contradictTheirBenchNowhere();
  void ownSlowTurns_showTheFrictionAroundTheRotor();
  void randomRigs_areMappedWithinFivePercent_data();
  void randomRigs_areMappedWithinFivePercent();
  void gainErrorOfTheSensor_isCarriedByAllTorques();
  void sameSeed_givesTheSameMap();
  void everyRotaryPreset_commissions_data();
  void everyRotaryPreset_commissions();

 private:
  std::optional<Commission> servo_;
};

namespace {

constexpr const char* servoUri = "simulated:servo";

Result<Commission> commissioned(const std::string& uri, unsigned seed, bool keep, size_t bins = 180) {
  auto drive = openDrive(uri, seed);
  if (!drive) return drive.error();
  CommissionOptions options;
  options.rig = "rig";
  options.sweeps.bins = bins;
  options.keepRecordings = keep;
  return commission(**drive, options);
}

QString percent(double value) {
  return QString::number(100.0 * value, 'f', 2) + " %";
}

}  // namespace

void TestCommission::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
  auto done = commissioned(servoUri, 1, true);
  QVERIFY2(done.ok(), done.ok() ? "" : done.error().message().c_str());
  servo_ = std::move(*done);
}

void TestCommission::presetServo_isMappedWithinFivePercent() {
  const auto truth = trueMap(servoUri, servo_->map.bins.size(), servo_->map.totalVelocity_rad_per_s);
  QVERIFY(truth.ok());
  for (const Way way : {Way::cw, Way::ccw}) {
    const auto still = test::deviation(servo_->map, *truth, way, test::staticOf);
    QVERIFY2(still.rms < 0.03 && still.rms > 1e-4, qPrintable(percent(still.rms)));
    QVERIFY(servo_->map.repeatability[static_cast<size_t>(way)].correlation > 0.9);
    const auto coulomb = test::deviation(servo_->map, *truth, way, test::coulombOf);
    QVERIFY2(coulomb.rms < 0.03, qPrintable(percent(coulomb.rms)));
    const auto viscous = test::deviation(servo_->map, *truth, way, test::viscousOf);
    QVERIFY2(viscous.rms < 0.08, qPrintable(percent(viscous.rms)));
  }
}

void TestCommission::presetServo_isIdentified() {
  const IdentifiedMotor& motor = servo_->motor;
  QVERIFY(std::abs(motor.backEmfConstant_V_s_per_rad.value / 0.07 - 1.0) < 0.005);
  QVERIFY(std::abs(motor.resistance_ohm.value / 1.2 - 1.0) < 0.01);
  QVERIFY(std::abs(motor.inductance_H.value / 0.0011 - 1.0) < 0.03);
  QVERIFY(std::abs(motor.inertia_kg_m2.value / 6e-5 - 1.0) < 0.02);
  QVERIFY(std::abs(motor.deadZone_V.value - 0.24) < 0.005);
  QVERIFY(!motor.torqueConstantTrusted);
}

void TestCommission::presetServo_showsOverWhichSpeedFrictionFalls() {
  const Estimate& found = servo_->map.stribeckVelocity_rad_per_s;
  QVERIFY2(std::abs(found.value - 1.5) < 3.0 * found.standardError, qPrintable(QString::number(found.value)));
  QVERIFY2(found.standardError < 0.15, qPrintable(QString::number(found.standardError)));
}

void TestCommission::presetServo_gainsFromItsMap() {
  QVERIFY(servo_->compensatedRun.has_value());
  const CompensatedRun& run = *servo_->compensatedRun;
  const QString said = QString("%1 without, %2 with").arg(run.without_rad_per_s).arg(run.with_rad_per_s);
  QVERIFY2(run.without_rad_per_s < 0.5 && run.with_rad_per_s > 0.02, qPrintable(said));
  QVERIFY2(run.without_rad_per_s > 1.2 * run.with_rad_per_s, qPrintable(said));
}

void TestCommission::presetServo_isLeftWithTheControllerOfItsBenchFile() {
  const BenchController& controller = servo_->bench.controller;
  QCOMPARE(controller.kp, servo_->settings.velocity_kp_A_s_per_rad);
  QCOMPARE(controller.observerCutoff_rad_per_s, servo_->settings.observer_cutoff_rad_per_s);
  // Medium stiffness keeps g/w at 10/3, which the careful gains of the measurements don't.
  const double bandwidth = controller.kp * controller.nominalTorqueConstant / controller.nominalInertia;
  QVERIFY2(std::abs(controller.observerCutoff_rad_per_s / bandwidth / (10.0 / 3.0) - 1.0) < 0.01,
           qPrintable(QString::number(bandwidth)));
}

void TestCommission::presetServo_staysWithinTwentyMinutes() {
  QVERIFY2(servo_->rigTime_s > 60.0 && servo_->rigTime_s < 1200.0, qPrintable(QString::number(servo_->rigTime_s)));
}

void TestCommission::files_areAllThereAndReadBack() {
  test::TemporaryFolder folder;
  QVERIFY(writeCommission(*servo_, std::nullopt, folder.path("out")).ok());
  const auto bench = readBench(folder.path("out/bench.json"));
  QVERIFY2(bench.ok(), bench.ok() ? "" : bench.error().message().c_str());
  QVERIFY(bench->trusted.contains("torque_constant_Nm_per_A"));
  QCOMPARE(servo_->recordings.size(), size_t{12});
  const auto recording = readCsv(folder.path("out/recordings/05-velocity-sweep.csv"));
  QVERIFY(recording.ok());
  QVERIFY(recording->has("current_A") && recording->rows() > 10000 && recording->rows() < 200000);
  for (const char* file : {"out/map.json", "out/map.csv", "out/report.html"}) {
    QVERIFY2(readFile(folder.path(file)).ok(), file);
  }
  QVERIFY(!readFile(folder.path("out/truth.csv")).ok());
}

/// What a job recorded says nothing against the bench that it left: currents as good as their own sign, too.
void TestCommission::ownRecordings_contradictTheirBenchNowhere() {
  size_t checked = 0;
  for (const auto& [step, recording] : servo_->recordings) {
    const auto scales = checkScales(servo_->bench, {recording});
    if (!scales) continue;  // a wiring check hardly moves
    ++checked;
    const std::string said = scales->misread           ? scales->misread->sentence.english()
                             : scales->remarks.empty() ? std::string()
                                                       : scales->remarks.front().english();
    QVERIFY2(said.empty(), (step + ": " + said).c_str());
  }
  QVERIFY2(checked >= 8, qPrintable(QString::number(checked)));
}

/// Slow turns whose friction changes along the way, held up by a controller: in motion, a body of twenty times the
/// inertia would err least.
void TestCommission::ownSlowTurns_showTheFrictionAroundTheRotor() {
  if (test::sanitized) QSKIP(test::likeOthers);
  const auto turns = std::find_if(servo_->recordings.begin(), servo_->recordings.end(),
                                  [](const auto& one) { return one.first.starts_with("07"); });
  QVERIFY(turns != servo_->recordings.end());
  const auto diagnosis = diagnose(servo_->bench, {turns->second}, {}, {});
  QVERIFY2(diagnosis.ok(), diagnosis.ok() ? "" : diagnosis.error().message().c_str());
  const std::string words = inWords(*diagnosis);
  QCOMPARE(diagnosis->fit.channel, std::string("torque_Nm"));
  QVERIFY2(!diagnosis->findings.empty() && diagnosis->findings.front().effect == "position_dependent_friction",
           words.c_str());
  QVERIFY2(diagnosis->fit.improvementLow95 > 0.3, words.c_str());
  const double inertia = *diagnosis->model.baseValue("inertia_kg_m2");
  QVERIFY2(std::abs(inertia / 6e-5 - 1.0) < 0.15, words.c_str());
}

void TestCommission::randomRigs_areMappedWithinFivePercent_data() {
  QTest::addColumn<unsigned>("seed");
  for (const unsigned seed : {9001u, 9002u, 9003u, 9004u}) QTest::newRow(std::to_string(seed).c_str()) << seed;
}

void TestCommission::randomRigs_areMappedWithinFivePercent() {
  if (test::sanitized) QSKIP("takes too long under sanitizers: jobs like others");
  QFETCH(unsigned, seed);
  test::TemporaryFolder folder;
  const std::string uri = "simulated:" + folder.write("random.rig.json", test::RandomRig(seed).text());
  const auto done = commissioned(uri, seed, false);
  QVERIFY2(done.ok(), done.ok() ? "" : done.error().message().c_str());
  const auto truth = trueMap(uri, done->map.bins.size(), done->map.totalVelocity_rad_per_s);
  QVERIFY(truth.ok());
  for (const Way way : {Way::cw, Way::ccw}) {
    const auto still = test::deviation(done->map, *truth, way, test::staticOf);
    QVERIFY2(still.rms < 0.05, qPrintable(percent(still.rms)));
    QVERIFY(done->map.repeatability[static_cast<size_t>(way)].correlation > 0.9);
  }
}

void TestCommission::gainErrorOfTheSensor_isCarriedByAllTorques() {
  if (test::sanitized) QSKIP("takes too long under sanitizers: jobs like others");
  test::TemporaryFolder folder;
  auto text = readFile(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/servo.rig.json");
  QVERIFY(text.ok());
  const std::string field = "\"gain_error\": 0.0";
  QVERIFY(text->find(field) != std::string::npos);
  text->replace(text->find(field), field.size(), "\"gain_error\": 0.03");
  const std::string uri = "simulated:" + folder.write("gain.rig.json", *text);
  const auto done = commissioned(uri, 2, false, 72);
  QVERIFY(done.ok());
  const auto truth = trueMap(uri, 72, done->map.totalVelocity_rad_per_s);
  const double mean = test::deviation(done->map, *truth, Way::ccw, test::staticOf).mean;
  QVERIFY2(mean > 0.02 && mean < 0.04, qPrintable(percent(mean)));
}

void TestCommission::sameSeed_givesTheSameMap() {
  if (test::sanitized) QSKIP("takes too long under sanitizers: jobs like others");
  const auto a = commissioned(servoUri, 5, false, 36), b = commissioned(servoUri, 5, false, 36),
             c = commissioned(servoUri, 6, false, 36);
  QVERIFY(a.ok() && b.ok() && c.ok());
  QCOMPARE(a->map.bins[7].way[0].static_Nm, b->map.bins[7].way[0].static_Nm);
  QVERIFY(!(a->map.bins[7].way[0].static_Nm == c->map.bins[7].way[0].static_Nm));
}

void TestCommission::everyRotaryPreset_commissions_data() {
  QTest::addColumn<QString>("preset");
  QTest::addColumn<unsigned>("seed");
  size_t row = 0;
  for (const std::string& name : presetNames()) {
    const auto bench = readBench(benchFileBeside(*rigFileOf("simulated:" + name)));
    if (!bench.ok() || bench->axis != Axis::rotary) continue;
    if (!test::alsoRun(row++, 3)) continue;
    for (unsigned seed = 1; seed <= test::seedsToTry(3); ++seed)
      QTest::addRow("%s, seed %u", name.c_str(), seed) << QString::fromStdString(name) << seed;
  }
}

void TestCommission::everyRotaryPreset_commissions() {
  QFETCH(QString, preset);
  QFETCH(unsigned, seed);
  const std::string uri = "simulated:" + preset.toStdString();
  const auto done = commissioned(uri, seed, false, 36);
  QVERIFY2(done.ok(), done.ok() ? "" : done.error().message().c_str());
  const auto truth = trueMap(uri, 36, done->map.totalVelocity_rad_per_s);
  QVERIFY(truth.ok());
  for (const Way way : {Way::cw, Way::ccw}) {
    const auto still = test::deviation(done->map, *truth, way, test::staticOf);
    QVERIFY2(still.rms < 0.04 && still.rms > 1e-4, qPrintable(percent(still.rms)));
  }
}

QTEST_APPLESS_MAIN(TestCommission)
#include "tst_commission.moc"
