// Rigs as imperfect as real ones: a bridge that bends its duty, a sensor and an encoder with tolerances, an unknown
// gain.
#include <QTest>

#include "base/atomic_file.h"
#include "commission/commission.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_truth.h"
#include "report/commission_report.h"
#include "support/map_accuracy.h"
#include "support/random_rig.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway;

class TestHonestRig : public QObject {
  Q_OBJECT
 private slots:
  void bentBridge_isMeasuredAndStraightened();
  void boardThatCannotStraighten_commissionsAllTheSame();
  void straightBridge_isLeftAlone();
  void discOfKnownInertia_givesTorquesWithoutATrustedGain();
  void sameDiscTwice_isRefused();
  void axisThatWarms_isSaid();
  void motorFile_readsBackAsItWas();
  void sensorsWithTolerances_areMappedAllTheSame_data();
  void sensorsWithTolerances_areMappedAllTheSame();
};

namespace {

constexpr double Ke = 0.07, R = 1.2, L = 0.0011, J = 6e-5;

std::string curve() {
  std::string rows;
  for (int k = 1; k <= 24; ++k) {
    const double x = 0.25 * k * k / 576.0;
    rows += (k == 1 ? "[" : ", [") + std::to_string(0.01 + x) + ", " +
            std::to_string(x - 0.01 * (1.0 - std::exp(-x / 0.02))) + "]";
  }
  return R"("duty_curve": [)" + rows + "], ";
}

/// The preset servo with more in its fields.
std::string servo(const std::string& bridge, const std::string& motor = {}, const std::string& sensor = {}) {
  auto text = readFile(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/servo.rig.json");
  if (!text) qFatal("%s", text.error().message().c_str());
  const auto put = [&](const std::string& field, const std::string& more) { text->insert(text->find(field), more); };
  put("\"supply_V\"", bridge);
  put("\"torque_constant_Nm_per_A\"", motor);
  put("\"sensitivity_V_per_A\"", sensor);
  const std::string ideal = "\"gain_error\": 0.0,";
  if (!sensor.empty()) text->erase(text->find(ideal), ideal.size());
  return *text;
}

CommissionOptions quick() {
  CommissionOptions options;
  options.rig = "rig";
  options.sweeps.bins = 36;
  options.sweeps.speedRun_s = 4.0;
  options.keepRecordings = false;
  return options;
}

Result<Commission> commissioned(const std::string& uri, const CommissionOptions& options, unsigned seed = 3) {
  auto drive = openDrive(uri, seed);
  if (!drive) return drive.error();
  return commission(**drive, options);
}

/// A board that knows nothing of its bridge's curve.
class PlainBoard : public Drive {
 public:
  explicit PlainBoard(std::unique_ptr<Drive> board) : board_(std::move(board)) {}
  const Identity& identity() const override { return board_->identity(); }
  ControllerSettings settings() const override { return board_->settings(); }
  Result<ControllerSettings> configure(const ControllerSettings& wanted) override { return board_->configure(wanted); }
  void command(const Command& command) override { board_->command(command); }
  void start(std::shared_ptr<Procedure> procedure) override { board_->start(std::move(procedure)); }
  void stop(const Saying& reason) override { board_->stop(reason); }
  Result<size_t> advance(double duration_s, std::vector<Sample>& samples) override {
    return board_->advance(duration_s, samples);
  }

 private:
  std::unique_ptr<Drive> board_;
};

bool says(const Commission& done, const std::string& words) {
  for (const std::string& remark : done.remarks) {
    if (remark.find(words) != std::string::npos) return true;
  }
  return false;
}

void verifyMotor(const IdentifiedMotor& motor) {
  QVERIFY2(std::abs(motor.resistance_ohm.value / R - 1.0) < 0.02,
           qPrintable(QString::number(motor.resistance_ohm.value)));
  QVERIFY2(std::abs(motor.inductance_H.value / L - 1.0) < 0.02, qPrintable(QString::number(motor.inductance_H.value)));
  QVERIFY2(std::abs(motor.backEmfConstant_V_s_per_rad.value / Ke - 1.0) < 0.005,
           qPrintable(QString::number(motor.backEmfConstant_V_s_per_rad.value)));
  QVERIFY2(std::abs(motor.inertia_kg_m2.value / J - 1.0) < 0.02,
           qPrintable(QString::number(motor.inertia_kg_m2.value)));
}

void verifyMap(const Commission& done, const std::string& uri) {
  const auto truth = trueMap(uri, done.map.bins.size(), done.map.totalVelocity_rad_per_s);
  QVERIFY(truth.ok());
  for (const Way way : {Way::cw, Way::ccw}) {
    const auto still = test::deviation(done.map, *truth, way, test::staticOf);
    QVERIFY2(still.rms < 0.03 && still.rms > 1e-4, qPrintable(QString::number(still.rms)));
    const auto coulomb = test::deviation(done.map, *truth, way, test::coulombOf);
    QVERIFY2(coulomb.rms < 0.03, qPrintable(QString::number(coulomb.rms)));
  }
}

}  // namespace

void TestHonestRig::bentBridge_isMeasuredAndStraightened() {
  test::TemporaryFolder folder;
  const std::string uri = "simulated:" + folder.write("bent.rig.json", servo(curve()));
  const auto done = commissioned(uri, quick());
  VERIFY_OK(done);
  verifyMotor(done->motor);
  QVERIFY(done->motor.dutyCurve.known() && says(*done, "through the measured curve's inverse"));
  for (const double duty : {0.02, 0.03, 0.05, 0.1, 0.3}) {
    const double x = duty - 0.01, truth = x - 0.01 * (1.0 - std::exp(-x / 0.02));
    QVERIFY2(std::abs(done->motor.dutyCurve.output(duty) - truth) < 7e-4, qPrintable(QString::number(duty)));
  }
  verifyMap(*done, uri);
  VERIFY_OK(writeCommission(*done, {}, folder.path("out")));
  const auto bench = readBench(folder.path("out/bench.json"));
  VERIFY_OK(bench);
  QCOMPARE(bench->dutyCurve.points.size(), done->motor.dutyCurve.points.size());
  QVERIFY(readFile(folder.path("out/report.html"))->find("What the bridge gives of its duty") != std::string::npos);
}

void TestHonestRig::boardThatCannotStraighten_commissionsAllTheSame() {
  test::TemporaryFolder folder;
  const std::string uri = "simulated:" + folder.write("bent.rig.json", servo(curve()));
  auto board = openDrive(uri, 3);
  VERIFY_OK(board);
  PlainBoard plain(std::move(*board));
  const auto done = commission(plain, quick());
  VERIFY_OK(done);
  verifyMotor(done->motor);
  QVERIFY(says(*done, "the board can't straighten it"));
  verifyMap(*done, uri);
}

void TestHonestRig::straightBridge_isLeftAlone() {
  CommissionOptions options = quick();
  options.motorOnly = true;
  for (unsigned seed = 1; seed <= test::seedsToTry(3); ++seed) {
    test::TemporaryFolder folder;
    const auto done = commissioned("simulated:" + folder.write("servo.rig.json", servo("")), options, seed);
    VERIFY_OK(done);
    verifyMotor(done->motor);
    QVERIFY(!done->motor.dutyCurve.known() && !says(*done, "bridge"));
  }
}

void TestHonestRig::discOfKnownInertia_givesTorquesWithoutATrustedGain() {
  test::TemporaryFolder folder;
  const std::string gain = "\"gain_error\": 0.04, ";
  CommissionOptions options = quick();
  options.motorOnly = true;
  options.addedInertia_kg_m2 = {1.2e-4, 1e-7};
  const auto disc = commissioned(
      "simulated:" + folder.write("disc.rig.json", servo("", "\"added_inertia_kg_m2\": 1.2e-4, ", gain)), options);
  VERIFY_OK(disc);
  options.addedInertia_kg_m2 = {};
  const std::string bareUri = "simulated:" + folder.write("bare.rig.json", servo("", "", gain));
  const auto blind = commissioned(bareUri, options, 4);
  VERIFY_OK(blind);
  QVERIFY(std::abs(blind->motor.inertia_kg_m2.value / J - 1.0) > 0.03);
  options.against = MotorRecord{disc->identity.device, disc->motor, disc->addedInertia_kg_m2};
  const auto bare = commissioned(bareUri, options, 4);
  VERIFY_OK(bare);
  verifyMotor(bare->motor);
  QVERIFY(std::abs(bare->motor.currentGain.value / 1.04 - 1.0) < 0.015);
  QVERIFY(bare->motor.currentGain.low95() < 1.04 && bare->motor.currentGain.high95() > 1.04);
  QVERIFY(bare->motor.inertia_kg_m2.low95() < J && bare->motor.inertia_kg_m2.high95() > J);
  QVERIFY(bare->motor.gauge.find("disc of known inertia") != std::string::npos);
}

void TestHonestRig::sameDiscTwice_isRefused() {
  test::TemporaryFolder folder;
  CommissionOptions options = quick();
  options.against = MotorRecord{"a board", {}, {}};
  const auto done = commissioned("simulated:" + folder.write("servo.rig.json", servo("")), options);
  VERIFY_ERROR(done, "added inertia: is the same as in the motor's file that it is held against, expected another one");
}

/// Its friction falls by a third while breakaways are measured.
void TestHonestRig::axisThatWarms_isSaid() {
  if (test::sanitized) QSKIP("a job like others");
  test::TemporaryFolder folder;
  std::string text = servo({});
  text.insert(text.find('{') + 1,
              R"("effects": [{"effect": "friction_warmup", "parameters": {"share": 1.5, "time_constant_s": 200}}],)");
  const auto done = commissioned("simulated:" + folder.write("cold.rig.json", text), quick());
  VERIFY_OK(done);
  QVERIFY(says(*done, "What starts motion fell by"));
  QVERIFY(std::any_of(done->map.remarks.begin(), done->map.remarks.end(),
                      [](const std::string& remark) { return remark.find("measure again") != std::string::npos; }));
  const auto warm = commissioned("simulated:servo", quick());
  VERIFY_OK(warm);
  QVERIFY(!says(*warm, "What starts motion"));
}

void TestHonestRig::motorFile_readsBackAsItWas() {
  test::TemporaryFolder folder;
  MotorRecord record{"a board", {}, {1.2e-4, 3e-7}};
  record.motor.resistance_ohm = {1.0 / 7.0, 1e-3};
  record.motor.shownInertia_kg_m2 = {1.0 / 3.0, 1e-5};
  record.motor.torqueConstantTrusted = true;
  record.motor.gauge = Message("by words");
  record.motor.dutyCurve.points = {{0.01, {}}, {0.03, {0.015, 1e-4}}};
  VERIFY_OK(writeMotor(record, folder.path("motor.json")));
  const auto back = readMotor(folder.path("motor.json"));
  VERIFY_OK(back);
  QCOMPARE(back->device, record.device);
  QCOMPARE(back->addedInertia_kg_m2, record.addedInertia_kg_m2);
  QCOMPARE(back->motor.resistance_ohm, record.motor.resistance_ohm);
  QCOMPARE(back->motor.shownInertia_kg_m2, record.motor.shownInertia_kg_m2);
  QVERIFY(back->motor.torqueConstantTrusted && back->motor.gauge == "by words");
  QCOMPARE(back->motor.dutyCurve.points[1].output, (Estimate{0.015, 1e-4}));
  const auto none = readMotor(folder.write("not.json", "{}"));
  QVERIFY(!none.ok() && none.error().message().find("schema") != std::string::npos);
}

void TestHonestRig::sensorsWithTolerances_areMappedAllTheSame_data() {
  QTest::addColumn<unsigned>("seed");
  size_t rows = 0;
  for (const unsigned seed : {9101u, 9102u})
    if (test::alsoRun(rows++, 4)) QTest::newRow(std::to_string(seed).c_str()) << seed;
}

void TestHonestRig::sensorsWithTolerances_areMappedAllTheSame() {
  QFETCH(unsigned, seed);
  test::TemporaryFolder folder;
  const std::string uri = "simulated:" + folder.write("random.rig.json", test::RandomRig(seed).text(true));
  CommissionOptions options = quick();
  options.sweeps.bins = 180;
  options.sweeps.speedRun_s = SweepSettings{}.speedRun_s;
  const auto done = commissioned(uri, options, seed);
  VERIFY_OK(done);
  verifyMap(*done, uri);
  QVERIFY(!says(*done, "What starts motion"));
}

QTEST_APPLESS_MAIN(TestHonestRig)
#include "tst_honest_rig.moc"
