// A commissioning that is interrupted keeps what it has, and goes on from there.
#include <signal.h>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTest>
#include <algorithm>

#include "base/numbers.h"
#include "commission/commission.h"
#include "commission/commission_progress.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_truth.h"
#include "house/program.h"
#include "report/commission_report.h"
#include "support/map_accuracy.h"
#include "support/random_rig.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway;

class TestCommissionResume : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void soundRigs_areNeverInterrupted_data();
  void soundRigs_areNeverInterrupted();
  void progress_readsBackAsItWas();
  void brokenOffRun_growsUntilItIsComplete();
  void damagedProgress_isNamed();
  void lostLink_keepsWhatItHasAndGoesOn_data();
  void lostLink_keepsWhatItHasAndGoesOn();
  void interruption_keepsTheStepsRecording();
  void anotherRig_isRefused();
  void otherBins_areRefused();
  void resumingNothing_isWrongInput();
  void theCommand_goesOnWhereItWasCut();
  void killedCommand_keepsTheTurnsOfTheSpeedUnderWay();
  void controlC_endsTheCommandInOrder();
};

namespace {

constexpr size_t bins = 36;

std::string rigFile(const test::TemporaryFolder& folder, const std::string& name, const std::string& faults) {
  auto text = readFile(qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/servo.rig.json");
  if (!text) qFatal("%s", text.error().message().c_str());
  if (!faults.empty()) text->replace(text->rfind('}'), 1, ", \"faults\": [ " + faults + " ] }");
  return folder.write(name + ".rig.json", *text);
}

std::string linkLossAt(double start_s) {
  return R"({ "fault": "link_loss", "start_s": )" + std::to_string(start_s) + " }";
}

CommissionOptions quick(const test::TemporaryFolder& folder) {
  CommissionOptions options;
  options.rig = "rig";
  options.sweeps.bins = bins;
  options.sweeps.speedRun_s = 4.0;
  options.keepProgress = [&folder](const Commission& progress) { return writeProgress(progress, folder.path("out")); };
  options.keepRecording = [&folder](const std::string& step, const Recording& recording) {
    return writeStep(step, recording, folder.path("out"));
  };
  return options;
}

Commission begunOn(const std::string& device, size_t angles) {
  Commission begun;
  begun.identity.device = device;
  begun.sweeps.bins = angles;
  begun.sweeps.speedRun_s = 4.0;
  return begun;
}

Result<Commission> commissioned(const std::string& rig, const CommissionOptions& options) {
  auto drive = openDrive("simulated:" + rig, 4);
  if (!drive) return drive.error();
  return commission(**drive, options);
}

}  // namespace

void TestCommissionResume::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestCommissionResume::soundRigs_areNeverInterrupted_data() {
  QTest::addColumn<unsigned>("seed");
  for (unsigned seed = 7001; seed <= (test::sanitized ? 7001u : 7006u); ++seed)
    QTest::newRow(std::to_string(seed).c_str()) << seed;
}

void TestCommissionResume::soundRigs_areNeverInterrupted() {
  QFETCH(unsigned, seed);
  test::TemporaryFolder folder;
  const auto done = commissioned(folder.write("random.rig.json", test::RandomRig(seed).text()), quick(folder));
  VERIFY_OK(done);
  QCOMPARE(done->events.size() + done->missed, 4 * bins);
  QVERIFY2(done->missed <= bins / 4, qPrintable(QString::number(done->missed)));
}

void TestCommissionResume::progress_readsBackAsItWas() {
  test::TemporaryFolder folder;
  Commission progress = begunOn("a board", bins);
  progress.sweeps.speeds = 5;
  progress.sweeps.highest_rad_per_s = 20.0;
  progress.trustedTorqueConstant_Nm_per_A = 0.07;
  progress.part = 3;
  progress.rigTime_s = 123.25;
  progress.remarks = {Message("a remark")};
  progress.facts.add({Known::motor});
  progress.expected_A = {0.25, 1.0 / 3.0};
  progress.shownResistance_ohm = 1.25;
  progress.identified.resistance_ohm = {1.0 / 7.0, 1e-3};
  progress.identified.torqueConstantTrusted = true;
  VelocityRun run{-10.0 / 3.0, 2, 4.5, 7.5, 0.05, 0.01, 0.3, {{3, 0.1, 0.2, -3.0, 9.1}, {0, 0.0, 0.0, 0.0, 0.0}}, {}};
  run.blocks.assign(2, RunBlock{1, 0.1, 0.2, 0.3, 0.4, run.bins});
  progress.runs = {run, run};
  progress.runs.front().brokenOff = true;
  TravelRun strokes{0.1, 25.0, 40.0, -0.02, 0.003, {}};
  for (auto& way : strokes.bins) way = {{1200, -3.5, 1.0 / 7.0, 2.0}, {0, 0.0, 0.0, 0.0}};
  progress.strokes = {strokes, strokes};
  progress.strokes.back().brokenOff = true;
  progress.travel = Travel{-0.1, 0.3, 1.0 / 90.0};
  BreakawayEvent event;
  event.way = Way::cw;
  event.turn = 1, event.bin = 17, event.samples = 2000, event.outlier = true;
  event.angle_rad = 0.1, event.current_A = 0.2, event.torque_Nm = 0.3, event.commanded_A = 0.4;
  event.commandedMean_A = 0.5, event.measuredMean_A = 0.6, event.commandedVariance_A2 = 0.7, event.covariance_A2 = 0.8;
  event.time_s = 12.5, event.zero_A = 0.01, event.lag_A = 0.02;
  progress.breakaways = {event};
  VERIFY_OK(writeProgress(progress, folder.path("out")));
  const auto back = readProgress(folder.path("out"));
  VERIFY_OK(back);
  QCOMPARE(back->identity.device, progress.identity.device);
  QVERIFY(back->sweeps == progress.sweeps);
  QCOMPARE(back->part, size_t{3});
  QCOMPARE(back->remarks, progress.remarks);
  QCOMPARE(back->trustedTorqueConstant_Nm_per_A, progress.trustedTorqueConstant_Nm_per_A);
  QVERIFY(back->knows(Known::motor));
  QCOMPARE(back->identified.resistance_ohm, progress.identified.resistance_ohm);
  QVERIFY(back->motor.torqueConstantTrusted);
  QCOMPARE(back->expected_A, progress.expected_A);
  QCOMPARE(back->runs.size(), size_t{2});
  QVERIFY(back->runs[0].brokenOff && !back->runs[1].brokenOff);
  QCOMPARE(back->runs[1].target_rad_per_s, run.target_rad_per_s);
  QCOMPARE(back->runs[1].blocks[1].bins[0].velocitySquared, 9.1);
  QVERIFY(back->runs[1].zero_A == 0.05 && back->runs[1].start_rad == 0.3 && back->runs[1].middle_s == 7.5);
  QVERIFY(back->runs[1].blocks[1].turns == 1 && back->runs[1].blocks[1].endWobble_rad_per_s == 0.4);
  const BreakawayEvent& read = back->breakaways.front();
  QVERIFY(read.time_s == 12.5 && read.zero_A == 0.01 && read.lag_A == 0.02);
  QVERIFY(read.way == Way::cw && read.turn == 1 && read.bin == 17 && read.samples == 2000 && read.outlier);
  QVERIFY(read.angle_rad == 0.1 && read.current_A == 0.2 && read.torque_Nm == 0.3 && read.commanded_A == 0.4);
  QVERIFY(read.commandedMean_A == 0.5 && read.measuredMean_A == 0.6);
  QVERIFY(read.commandedVariance_A2 == 0.7 && read.covariance_A2 == 0.8);
  QCOMPARE(back->strokes.size(), size_t{2});
  QVERIFY(!back->strokes[0].brokenOff && back->strokes[1].brokenOff);
  QCOMPARE(back->strokes[0].target_m_per_s, strokes.target_m_per_s);
  QCOMPARE(back->strokes[0].zero_A, strokes.zero_A);
  QCOMPARE(back->strokes[0].bins[1].size(), size_t{2});
  QCOMPARE(back->strokes[0].bins[1][0].velocity_m_per_s, 1.0 / 7.0);
  QVERIFY(back->travel && back->travel->margin_m == 1.0 / 90.0);
}

void TestCommissionResume::brokenOffRun_growsUntilItIsComplete() {
  test::TemporaryFolder folder;
  Commission progress = begunOn("a board", bins);
  VelocityRun run{10.0, 2, 1.5, 0.75, 0.05, 0.01, 0.3, {{3, 0.1, 0.2, -3.0, 9.1}}, {}, true};
  progress.runs = {run};
  const auto back = [&folder] { return readProgress(folder.path("out"))->runs; };
  const std::string begun = folder.path("out/progress/run-01-broken-off.json");
  for (const size_t turns : {2, 5}) {
    progress.runs.back().turns = turns;
    VERIFY_OK(writeProgress(progress, folder.path("out")));
    QCOMPARE(back().size(), size_t{1});
    QVERIFY(back()[0].brokenOff && back()[0].turns == turns);
  }
  progress.runs.back().brokenOff = false;
  VERIFY_OK(writeProgress(progress, folder.path("out")));
  QVERIFY(back().size() == 1 && !back()[0].brokenOff && !QFile::exists(QString::fromStdString(begun)));
  progress.runs.push_back(run);
  VERIFY_OK(writeProgress(progress, folder.path("out")));
  QVERIFY(back().size() == 2 && back()[1].brokenOff);
  progress.runs.pop_back();  // thrown away: the shaft was held
  VERIFY_OK(writeProgress(progress, folder.path("out")));
  QCOMPARE(back().size(), size_t{1});
  QVERIFY(QDir(QString::fromStdString(folder.path("out/progress"))).entryList({"*broken*"}).isEmpty());
}

void TestCommissionResume::damagedProgress_isNamed() {
  test::TemporaryFolder folder;
  Commission progress = begunOn("a board", bins);
  progress.breakaways = {BreakawayEvent{}};
  VERIFY_OK(writeProgress(progress, folder.path("out")));
  VERIFY_OK(writeFile(
      folder.path("out/progress/breakaways.json"),
      R"({"schema": "breakaway.progress/1", "events": [[1, -2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]]})"));
  const auto back = readProgress(folder.path("out"));
  QVERIFY(!back.ok());
  QVERIFY(back.error().message().find("breakaways.json") != std::string::npos);
  QVERIFY(back.error().message().find("wrong turn") != std::string::npos);
  VERIFY_OK(writeFile(
      folder.path("out/progress/breakaways.json"),
      R"({"schema": "breakaway.progress/1", "events": [[1, 0, 0, 1e12, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0]]})"));
  const auto far = readProgress(folder.path("out"));
  QVERIFY(!far.ok() && far.error().message().find("beyond the turn") != std::string::npos);
  auto state = readFile(folder.path("out/progress/state.json"));
  VERIFY_OK(state);
  state->replace(state->find("\"bins\": 36"), 10, "\"bins\": 1e9");
  VERIFY_OK(writeFile(folder.path("out/progress/state.json"), *state));
  const auto absurd = readProgress(folder.path("out"));
  QVERIFY(!absurd.ok() && absurd.error().message().find("field bins: is too large") != std::string::npos);
}

void TestCommissionResume::lostLink_keepsWhatItHasAndGoesOn_data() {
  QTest::addColumn<double>("lost_s");
  QTest::addColumn<bool>("hasMotor");
  QTest::addColumn<bool>("hasRuns");
  QTest::addColumn<bool>("hasEvents");
  if (!test::sanitized) {
    QTest::newRow("in the winding test") << 5.0 << false << false << false;
    QTest::newRow("in the velocity sweep") << 100.0 << true << true << false;
  }
  QTest::newRow("in the breakaway sweep") << 190.0 << true << true << true;
}

void TestCommissionResume::lostLink_keepsWhatItHasAndGoesOn() {
  QFETCH(double, lost_s);
  QFETCH(bool, hasMotor);
  QFETCH(bool, hasRuns);
  QFETCH(bool, hasEvents);
  test::TemporaryFolder folder;
  const auto broken = commissioned(rigFile(folder, "broken", linkLossAt(lost_s)), quick(folder));
  QVERIFY(!broken.ok());
  QVERIFY2(broken.error().message().find("the link to the board is lost") != std::string::npos,
           broken.error().message().c_str());
  auto kept = readProgress(folder.path("out"));
  VERIFY_OK(kept);
  QCOMPARE(kept->knows(Known::motor), hasMotor);
  QCOMPARE(!kept->runs.empty(), hasRuns);
  QCOMPARE(!kept->breakaways.empty(), hasEvents);
  const size_t runs = kept->runs.size(), events = kept->breakaways.size();
  QVERIFY2(!hasRuns || hasEvents || runs < 12, "lost in the middle of the sweep");
  const auto brokenOff = [](const Commission& known) {
    return static_cast<size_t>(
        std::count_if(known.runs.begin(), known.runs.end(), [](const VelocityRun& run) { return run.brokenOff; }));
  };
  const bool inASpeed = hasRuns && !hasEvents;
  QCOMPARE(brokenOff(*kept), size_t{inASpeed ? 1u : 0u});

  const std::string sound = rigFile(folder, "sound", "");
  CommissionOptions options = quick(folder);
  options.earlier = *kept;
  const auto done = commissioned(sound, options);
  VERIFY_OK(done);
  QCOMPARE(done->runs.size(), 12 + brokenOff(*done));
  QCOMPARE(brokenOff(*done), brokenOff(*kept));
  if (inASpeed) {  // only what was left of it was run
    const VelocityRun &before = kept->runs.back(), &after = done->runs[kept->runs.size()];
    QVERIFY(after.isAt(before.target_rad_per_s) && !after.brokenOff && before.turns > 0);
    const double longest_s = std::max(options.sweeps.speedRun_s - before.duration_s, 0.1 * options.sweeps.speedRun_s) +
                             2.5 * turn_rad / std::abs(before.target_rad_per_s);
    QVERIFY2(after.duration_s < longest_s, qPrintable(QString::number(after.duration_s)));
    QVERIFY(before.duration_s + after.duration_s >= options.sweeps.speedRun_s);
  }
  QCOMPARE(done->events.size() + done->missed, 4 * bins);
  if (hasRuns) QCOMPARE(done->runs.front().bins.front().current_A, kept->runs.front().bins.front().current_A);
  if (hasEvents) QCOMPARE(done->events.front().angle_rad, kept->breakaways.front().angle_rad);
  QVERIFY(runs < 13 && events < 4 * bins);
  const auto whole = commissioned(sound, quick(folder));
  VERIFY_OK(whole);
  const double part_s = done->rigTime_s - kept->rigTime_s;
  QVERIFY2(!hasMotor || part_s < whole->rigTime_s - 20.0, qPrintable(QString::number(part_s)));
  const auto truth = trueMap("simulated:" + sound, bins, done->map.totalVelocity_rad_per_s);
  VERIFY_OK(truth);
  for (const Way way : {Way::cw, Way::ccw}) {
    const double rms = test::deviation(done->map, *truth, way, test::staticOf).rms;
    QVERIFY2(rms < 0.05 && rms > 1e-4, qPrintable(QString::number(rms)));
  }
}

void TestCommissionResume::interruption_keepsTheStepsRecording() {
  test::TemporaryFolder folder;
  CommissionOptions options = quick(folder);
  int asked = 0;
  options.interrupted = [&asked] { return ++asked > 400; };
  const auto done = commissioned(rigFile(folder, "sound", ""), options);
  QVERIFY(!done.ok());
  QCOMPARE(done.error().message(), std::string("05-velocity-sweep: interrupted from the keyboard; the motor is off"));
  VERIFY_OK(readFile(folder.path("out/recordings/05-velocity-sweep.csv")));
  VERIFY_OK(readFile(folder.path("out/progress/run-01.json")));
}

void TestCommissionResume::anotherRig_isRefused() {
  test::TemporaryFolder folder;
  CommissionOptions options = quick(folder);
  options.earlier = begunOn("another board", bins);
  const auto done = commissioned(rigFile(folder, "sound", ""), options);
  VERIFY_ERROR(done, "board: is simulated board, rig servo, but the interrupted job was begun on another board");
}

void TestCommissionResume::otherBins_areRefused() {
  test::TemporaryFolder folder;
  CommissionOptions options = quick(folder);
  options.earlier = begunOn("simulated board, rig servo", 72);
  const auto done = commissioned(rigFile(folder, "sound", ""), options);
  VERIFY_ERROR(done, "bins and turns: are 36 and 2, but the interrupted job was begun with 72 and 2");
}

void TestCommissionResume::resumingNothing_isWrongInput() {
  test::TemporaryFolder folder;
  const auto outcome = test::run(test::builtProgram("breakaway"),
                                 {"commission", "--resume", "--out", QString::fromStdString(folder.path("out"))});
  QCOMPARE(outcome.status, 2);
  QVERIFY(outcome.err.contains("holds no interrupted commissioning"));
  QVERIFY(folder.names().isEmpty());
}

void TestCommissionResume::theCommand_goesOnWhereItWasCut() {
  test::TemporaryFolder folder;
  const QString out = QString::fromStdString(folder.path("out"));
  const QString broken = QString::fromStdString(rigFile(folder, "broken", linkLossAt(250.0)));
  const QString sound = QString::fromStdString(rigFile(folder, "sound", ""));
  const auto cut = test::run(test::builtProgram("breakaway"),
                             {"commission", "--board", "simulated:" + broken, "--bins", "36", "--out", out});
  QCOMPARE(cut.status, 1);
  QVERIFY2(cut.err.contains("the link to the board is lost") && cut.err.contains("--resume"), qPrintable(cut.err));
  QVERIFY(!QFile::exists(out + "/map.json"));
  const auto done = test::run(test::builtProgram("breakaway"),
                              {"commission", "--resume", "--board", "simulated:" + sound, "--out", out});
  QVERIFY2(done.status == 0, qPrintable(done.err));
  QVERIFY(done.out.contains("went on: part 2"));
  QVERIFY(QFile::exists(out + "/map.json") && QFile::exists(out + "/recordings/02-winding.csv"));
  QVERIFY(QFile::exists(out + "/recordings/05-velocity-sweep-part2.csv"));
  QVERIFY(!QFile::exists(out + "/progress"));
}

/// Killed at once after it was seen to write, it may not have written for half a second and what that takes.
void TestCommissionResume::killedCommand_keepsTheTurnsOfTheSpeedUnderWay() {
  test::TemporaryFolder folder;
  const QString out = QString::fromStdString(folder.path("out"));
  QProcess process;
  process.start(test::builtProgram("breakaway"),
                {"commission", "--bins", "36", "--turns", "1", "--run-s", "60", "--out", out});
  QVERIFY(process.waitForStarted());
  const auto begun = [&out] { return QDir(out + "/progress").entryList({"run-*-broken-off.json"}); };
  for (int k = 0; k < 6000 && begun().isEmpty(); ++k) QTest::qSleep(10);
  QVERIFY(!begun().isEmpty());
  const QDateTime written = QFileInfo(out + "/progress/state.json").lastModified();
  bool writtenAgain = false;
  for (int k = 0; k < 200 && !writtenAgain; ++k) {
    QTest::qSleep(5);
    writtenAgain = QFileInfo(out + "/progress/state.json").lastModified() > written;
  }
  QVERIFY2(writtenAgain, "within a second");
  process.kill();
  QVERIFY(process.waitForFinished(30000));
  const auto kept = readProgress(folder.path("out"));
  VERIFY_OK(kept);
  QVERIFY(!kept->runs.empty());
  const auto done = test::run(test::builtProgram("breakaway"), {"commission", "--resume", "--out", out});
  QVERIFY2(done.status == 0, qPrintable(done.err));
  QVERIFY2(done.out.contains("went on: part 2"), qPrintable(done.out));
}

void TestCommissionResume::controlC_endsTheCommandInOrder() {
  test::TemporaryFolder folder;
  const QString out = QString::fromStdString(folder.path("out"));
  QProcess process;
  process.start(test::builtProgram("breakaway"), {"commission", "--turns", "20", "--out", out});
  QVERIFY(process.waitForStarted());
  for (int k = 0; k < 6000 && !QFile::exists(out + "/progress/breakaways.json"); ++k) QTest::qSleep(20);
  QVERIFY(QFile::exists(out + "/progress/breakaways.json"));
  QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
  QVERIFY(process.waitForFinished(30000));
  QCOMPARE(process.exitStatus(), QProcess::NormalExit);
  QCOMPARE(process.exitCode(), 130);
  QVERIFY(process.readAllStandardError().contains("06-breakaway-sweep: interrupted from the keyboard"));
  const auto kept = readProgress(folder.path("out"));
  VERIFY_OK(kept);
  QVERIFY(!kept->breakaways.empty() && kept->runs.size() == 12);
}

QTEST_APPLESS_MAIN(TestCommissionResume)
#include "tst_commission_resume.moc"
