// The plan of the bench job, and the job as a thing that runs slice by slice.
#include <QTest>

#include "commission/job.h"
#include "firmware_link/simulated_board.h"
#include "support/linear_rig.h"
#include "support/temporary.h"
#include "support/wired_rig.h"

using namespace breakaway;

class TestJob : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void everyNeed_isLeftByAnEarlierStep_data();
  void everyNeed_isLeftByAnEarlierStep();
  void planOfTheMap_isMadeInOrder();
  void whatIsKnown_isNotMadeAgain();
  void motorAlone_homesNothing();
  void boardThatCannotBeIdentified_homesAllTheSame();
  void slices_changeNothing();
  void stoppedJob_keepsWhatItHasAndGoesOn();
  void gains_areGivenBack();
  void otherSettings_forgetWhatWasMeasuredWithThem();
  void endsFoundElsewhere_forgetTheSweeps();
  void earlyEnd_isTracedToItsWire_data();
  void earlyEnd_isTracedToItsWire();
};

namespace {

Identity board(Axis axis) {
  Identity identity{"board", "1", false, 5000.0, 14400.0, 24.0, true};
  identity.axis = axis;
  return identity;
}

std::vector<std::string> words(const std::vector<StepPtr>& steps) {
  std::vector<std::string> all;
  all.reserve(steps.size());
  for (const StepPtr& step : steps) all.push_back(step->words());
  return all;
}

CommissionOptions quick() {
  CommissionOptions options;
  options.rig = "rig";
  options.sweeps = {36, 1, 2.0, 3, 0.0};
  options.keepRecordings = options.measuresAnew = false;
  return options;
}

std::unique_ptr<Drive> opened(const std::string& uri) {
  auto drive = openDrive(uri, 3);
  if (!drive) qFatal("%s", drive.error().message().c_str());
  return std::move(*drive);
}

/// Until it ends, or `enough` of it.
template <typename Enough>
void run(Job& job, Drive& drive, double slice_s, Enough enough) {
  std::vector<Sample> samples;
  job.begin(drive);
  while (job.running() && !enough()) {
    samples.clear();
    const auto lost = drive.advance(slice_s, samples);
    if (!lost) qFatal("%s", lost.error().message().c_str());
    job.take(drive, slice_s, samples, *lost);
  }
}

void run(Job& job, Drive& drive, double slice_s = 0.25) {
  run(job, drive, slice_s, [] { return false; });
}

}  // namespace

void TestJob::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestJob::everyNeed_isLeftByAnEarlierStep_data() {
  QTest::addColumn<bool>("linear");
  QTest::newRow("rotor") << false;
  QTest::newRow("linear axis") << true;
}

void TestJob::everyNeed_isLeftByAnEarlierStep() {
  QFETCH(bool, linear);
  Facts left;
  for (const StepPtr& step : stepsOf(board(linear ? Axis::linear : Axis::rotary))) {
    QVERIFY2(left.hasAll(step->needs()), step->words().c_str());
    QVERIFY2(!left.hasAll(step->leaves()), step->words().c_str());
    left.add(step->leaves());
  }
  QVERIFY(left.hasAll({Known::map, Known::comparison}));
}

void TestJob::planOfTheMap_isMadeInOrder() {
  const std::vector<std::string> expected{
      "current sensor's zero", "wiring check",    "winding test",        "spin test",       "careful gains",
      "reversal test",         "bridge",          "straightened bridge", "current's scale", "homing",
      "velocity sweep",        "breakaway sweep", "friction map"};
  QCOMPARE(words(plan(board(Axis::rotary), {}, {Known::map})), expected);
}

void TestJob::whatIsKnown_isNotMadeAgain() {
  const Facts known{Known::sensorZero, Known::motor,        Known::roughMotor, Known::bridge,
                    Known::straight,   Known::carefulGains, Known::index,      Known::runs};
  const std::vector<std::string> expected{"breakaway sweep", "friction map"};
  QCOMPARE(words(plan(board(Axis::rotary), known, {Known::map})), expected);
  QVERIFY(plan(board(Axis::rotary), known, {Known::runs}).empty());
}

void TestJob::motorAlone_homesNothing() {
  for (const Axis axis : {Axis::rotary, Axis::linear}) {
    const auto steps = words(plan(board(axis), {}, {Known::motor}));
    QCOMPARE(steps.back(), std::string("current's scale"));
    QVERIFY(std::find(steps.begin(), steps.end(), "homing") == steps.end());
  }
}

void TestJob::boardThatCannotBeIdentified_homesAllTheSame() {
  Identity asked = board(Axis::rotary);
  asked.can.everyTick = false;
  QCOMPARE(words(plan(asked, {}, {Known::index})), std::vector<std::string>{"homing"});
}

void TestJob::slices_changeNothing() {
  Job coarse(quick(), {Known::index}), fine(quick(), {Known::index});
  const auto one = opened("simulated:servo"), other = opened("simulated:servo");
  run(coarse, *one, 0.25);
  run(fine, *other, 0.005);
  QVERIFY2(coarse.status().state == Procedure::State::finished, coarse.failure().message().c_str());
  QCOMPARE(fine.known().rigTime_s, coarse.known().rigTime_s);
  QCOMPARE(fine.known().motor.inertia_kg_m2, coarse.known().motor.inertia_kg_m2);
  QCOMPARE(fine.known().indexAngle_rad, coarse.known().indexAngle_rad);
  QVERIFY(coarse.known().indexAngle_rad.standardError > 0.0);
}

void TestJob::stoppedJob_keepsWhatItHasAndGoesOn() {
  const auto drive = opened("simulated:servo");
  Job job(quick(), {Known::map});
  run(job, *drive, 0.05, [&] { return job.known().breakaways.size() >= 5; });
  QVERIFY(job.running());
  drive->stop("enough");
  job.stop(*drive, "enough");
  QCOMPARE(job.status().state, Procedure::State::stopped);
  QCOMPARE(job.status().failure, std::string("enough"));
  const Commission before = job.known();
  QVERIFY(before.breakaways.size() >= 5 && before.breakaways.size() < 72);
  Job rest(quick(), {Known::map}, before);
  run(rest, *drive);
  QVERIFY2(rest.status().state == Procedure::State::finished, rest.failure().message().c_str());
  const Commission& whole = rest.known();
  QCOMPARE(whole.breakaways.size() + whole.missed, size_t{72});
  QCOMPARE(whole.map.bins.size(), size_t{36});
  for (size_t k = 0; k < before.breakaways.size(); ++k)
    QCOMPARE(whole.breakaways[k].current_A, before.breakaways[k].current_A);
  QVERIFY(whole.rigTime_s < before.rigTime_s + 120.0);  // nothing before the sweep was made again
}

void TestJob::gains_areGivenBack() {
  for (const bool givesBack : {true, false}) {
    const auto drive = opened("simulated:servo");
    const ControllerSettings found = drive->settings();
    CommissionOptions options = quick();
    options.givesGainsBack = givesBack;
    Job job(options, {Known::index});
    run(job, *drive);
    QVERIFY2(job.status().state == Procedure::State::finished, job.failure().message().c_str());
    QCOMPARE(drive->settings() == found, givesBack);
    QVERIFY(drive->settings() == job.known().settings);
    QCOMPARE(job.known().knows(Known::carefulGains), !givesBack);
  }
}

void TestJob::otherSettings_forgetWhatWasMeasuredWithThem() {
  Commission known;
  known.facts = {Known::motor, Known::index, Known::runs, Known::breakaways, Known::map};
  known.runs.resize(6);
  known.breakaways.resize(720);
  SweepSettings others = known.sweeps;
  known.forgetOtherThan(others);
  QVERIFY(known.knows(Known::map) && known.runs.size() == 6);
  others.turns = 3;
  known.forgetOtherThan(others);
  QVERIFY(!known.knows(Known::map) && !known.knows(Known::breakaways) && known.breakaways.empty());
  QVERIFY(known.knows(Known::runs) && known.knows(Known::index) && known.knows(Known::motor));
  others.speedRun_s = 10.0;
  known.forgetOtherThan(others);
  QVERIFY(!known.knows(Known::runs) && known.runs.empty() && known.knows(Known::motor));
}

void TestJob::endsFoundElsewhere_forgetTheSweeps() {
  test::LinearAxis axis;
  axis.length_m = 0.12;
  const test::TemporaryFolder folder;
  const std::string uri = "simulated:" + folder.write("axis.rig.json", test::linearRigText(axis, 7));
  const auto drive = opened(uri);
  Job homing(quick(), {Known::index});
  run(homing, *drive);
  QVERIFY2(homing.status().state == Procedure::State::finished, homing.failure().message().c_str());
  for (const double apart_m : {0.0005, 0.03}) {
    Commission before = homing.known();
    before.forget({Known::ends});
    before.travel->high_m += apart_m;
    before.strokes.resize(3);
    before.breakaways.resize(4);
    CommissionOptions options = quick();
    options.measuresAnew = true;
    Job again(options, {Known::index}, before);
    run(again, *drive);
    const bool same = apart_m < 0.001;
    QCOMPARE(again.known().breakaways.size(), same ? size_t{4} : size_t{0});
    QCOMPARE(again.known().strokes.empty(), !same);
    options.measuresAnew = false;
    Job strict(options, {Known::index}, before);
    run(strict, *drive);
    QCOMPARE(strict.status().state == Procedure::State::finished, same);
  }
}

void TestJob::earlyEnd_isTracedToItsWire_data() {
  QTest::addColumn<QString>("trouble");
  QTest::addColumn<QString>("begins");
  QTest::addColumn<bool>("traced");
  QTest::newRow("counts that change in motion look like a jump, and stay changed")
      << R"("wiring": [{"fault": "counts_factor", "value": 4, "from_s": 45.8}])"
      << "03-spin: at the beginning back_emf_constant_V_s_per_rad is" << true;
  QTest::newRow("a jump is a jump") << R"("faults": [{"fault": "encoder_jump", "start_s": 45.8, "counts": 1000}])"
                                    << "03-spin: the encoder jumped by about" << false;
  QTest::newRow("a sensor that turns round in motion fits to no motor")
      << R"("wiring": [{"fault": "current_sensor_reversed", "from_s": 45.8}])"
      << "03-spin: the rotor moves with the voltage, but the current falls as the voltage rises" << true;
  QTest::newRow("a shaft that is held is no wire's doing") << R"("faults": [{"fault": "blocked", "start_s": 45.8}])"
                                                           << "03-spin: " << false;
}

void TestJob::earlyEnd_isTracedToItsWire() {
  QFETCH(QString, trouble);
  QFETCH(QString, begins);
  QFETCH(bool, traced);
  const test::TemporaryFolder folder;
  const std::string rig = test::replaced(test::wiredRig("servo", ""), "\"wiring\": []", trouble.toStdString());
  const auto drive = opened("simulated:" + folder.write("servo.rig.json", rig));
  Job job(quick(), {Known::motor});
  bool sought = false;
  run(job, *drive, 0.25, [&] {
    sought = sought || job.seeksCause();
    return false;
  });
  QCOMPARE(job.status().state == Procedure::State::finished, false);
  QVERIFY(sought);
  const QString words = QString::fromStdString(job.failure().message());
  QVERIFY2(words.startsWith(begins), qPrintable(words));
  QVERIFY2(words.contains("(found by a wiring check after this: ") == traced, qPrintable(words));
}

QTEST_APPLESS_MAIN(TestJob)
#include "tst_job.moc"
