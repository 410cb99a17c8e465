// The session's parts, each alone: the connection, the runs at the bench, the live samples, and pages that are given
// no more than they use.
#include <QFile>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <algorithm>
#include <atomic>

#include "app/small_drive.h"
#include "app/window_support.h"
#include "pages/home_page.h"
#include "pages/tune_page.h"
#include "recording/block_file.h"
#include "recording/csv.h"
#include "recording/sample_recording.h"
#include "session/live_samples.h"
#include "session/settings_edits.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestSession : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void board_comesBeforeItIsShown();
  void failedOpening_isSaidAndLeavesNoBoard();
  void refusedSettings_leaveWhatIsSet();
  void pulledCable_leavesNothingOfTheBoard();
  void lateReports_ofAnEarlierBoard_areNotTaken();
  void liveSamples_keepTheLastMinuteOfTheirBatches();
  void aCopyOfTheHistory_keepsWhatTheHistoryDrops();
  void emptyStretch_isAnError();
  void recording_holdsEverySampleFromItsStart();
  void lostSamples_areGapsOfTheRecording();
  void lostBoard_leavesItsRecordingAndSamples();
  void fullDisk_endsARecordingInOrder();
  void almostFullDisk_isAnnounced();
  void runs_sayWhyTheyCannotStart();
  void measuredSteps_areKeptUntilAnotherBoardComes();
  void surveyOfAnotherBoard_waitsForIt();
  void anotherBoardOfTheModel_isToldByItsSerialNumber();
  void bridgesCurve_isGivenToTheBoard_andARefusalSaid();
  void page_worksWithItsPartsAlone();
};

namespace {

struct Parts {
  QStringList lines() const {
    QStringList all;
    for (const auto& one : said) all << one.at(0).toString();
    return all;
  }

  Messages messages;
  QSignalSpy said{&messages, &Messages::said};
  std::shared_ptr<DriveWitness> witness = std::make_shared<DriveWitness>();
  Connection connection{messages, {1.0, 0.005, 600.0}};
  TemporaryFolder folder;
  BenchProject project{messages};

  Parts() { project.open(QString::fromStdString(folder.path("p"))); }
  /// As the command would find it.
  std::vector<ProjectRun> kept() const {
    auto there = Project::open(folder.path("p"));
    if (!there) qFatal("%s", there.error().message().c_str());
    return there->index().list({}).value();
  }
};

/// Refuses what is asked of it.
class StubbornDrive : public SmallDrive {
 public:
  using SmallDrive::SmallDrive;
  Result<ControllerSettings> configure(const ControllerSettings&) override { return Error{"board", "refuses gains"}; }
  Result<void> linearise(const DutyCurve& curve) override {
    return Error{"board", "refuses a curve of " + std::to_string(curve.points.size()) + " points"};
  }
};

SampleBatch batchOf(double from_s, size_t count) {
  SampleBatch batch;
  for (size_t k = 0; k < count; ++k) {
    Sample sample;
    sample.time_s = from_s + 1e-3 * static_cast<double>(k);
    sample.angle_rad = 2.0 * sample.time_s;
    batch.samples.push_back(sample);
  }
  return batch;
}

}  // namespace

void TestSession::initTestCase() {
  if (qEnvironmentVariableIsEmpty("BREAKAWAY_RESOURCES"))
    qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestSession::board_comesBeforeItIsShown() {
  Parts parts;
  QStringList order;
  connect(&parts.connection, &Connection::changed, this, [&] { order << "changed"; });
  connect(&parts.connection, &Connection::came, this, [&] {
    order << "came";
    QVERIFY(parts.connection.connected());
    QCOMPARE(parts.connection.identity().device, std::string("small drive"));
  });
  connect(&parts.connection, &Connection::left, this, [&] { order << "left"; });
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  QVERIFY(order.endsWith("changed") && order.contains("came"));
  QCOMPARE(parts.connection.uri(), QString("small"));
  QCOMPARE(parts.lines(), QStringList("Connected to small drive"));
  order.clear();
  parts.connection.close();
  QCOMPARE(order.front(), QString("left"));
  QVERIFY(!parts.connection.connected() && parts.connection.identity().device.empty());
  QCOMPARE(parts.connection.state(), ConnectionState::none);
}

void TestSession::failedOpening_isSaidAndLeavesNoBoard() {
  Parts parts;
  parts.connection.open("simulated:no such preset");
  QCOMPARE(parts.connection.state(), ConnectionState::failed);
  QVERIFY(!parts.connection.connected() && !parts.connection.trouble().empty());
  QCOMPARE(parts.lines(), QStringList(inLanguage(parts.connection.trouble())));
  QVERIFY(parts.said.front().at(1).toBool());
  parts.connection.stop();  // nothing to stop is nothing wrong
  QCOMPARE(parts.connection.obstacle(), QString("No board is connected"));
}

void TestSession::refusedSettings_leaveWhatIsSet() {
  Parts parts;
  parts.connection.adopt(std::make_unique<StubbornDrive>(parts.witness), "small");
  const ControllerSettings before = parts.connection.settings();
  ControllerSettings wanted = before;
  wanted.velocity_kp_A_s_per_rad *= 2.0;
  QSignalSpy changed(&parts.connection, &Connection::settingsChanged);
  parts.connection.configure(wanted);
  QVERIFY(changed.wait(5000));
  QVERIFY(parts.connection.settings() == before);
  QCOMPARE(parts.lines().back(), QString("board: refuses gains"));
}

void TestSession::pulledCable_leavesNothingOfTheBoard() {
  Parts parts;
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  QSignalSpy left(&parts.connection, &Connection::left);
  parts.witness->cableCut = true;
  QVERIFY(left.wait(5000));
  QVERIFY(!parts.connection.connected() && !parts.connection.powered() && !parts.connection.run().running());
  QCOMPARE(parts.connection.state(), ConnectionState::failed);
  QVERIFY(parts.lines().back().contains("the cable was pulled"));
}

void TestSession::lateReports_ofAnEarlierBoard_areNotTaken() {
  Parts parts;
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "first");
  QTest::qSleep(100);  // samples are on their way
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "second");
  double first_s = -1.0;
  connect(&parts.connection, &Connection::samplesCame, this, [&](const SampleBatchPtr& batch) {
    if (first_s < 0.0) first_s = batch->samples.front().time_s;
  });
  QTRY_VERIFY(first_s > 0.0);
  QVERIFY2(first_s < 0.0015, qPrintable(QString::number(first_s)));  // the second board's first sample
}

void TestSession::liveSamples_keepTheLastMinuteOfTheirBatches() {
  Parts parts;
  LiveSamples live(parts.connection, parts.project, parts.messages);
  live.take(batchOf(0.0, 1000));
  live.take(batchOf(1.0, 1000));
  QCOMPARE(live.history().end(), uint64_t{2000});
  QCOMPARE(live.history().first(), uint64_t{0});
  const auto stretch = live.stretch(live.history(), 0.4995, 1.2005);
  QVERIFY2(stretch.ok(), stretch.ok() ? "" : stretch.error().message().c_str());
  QCOMPARE(stretch->rows(), size_t{701});
  live.take(batchOf(60.5, 1));
  QCOMPARE(live.history().first(), uint64_t{500});
  QCOMPARE(live.history().newest()->time_s, 60.5);
}

void TestSession::aCopyOfTheHistory_keepsWhatTheHistoryDrops() {
  LiveHistory history;
  history.append(batchOf(0.0, 5000).samples);
  const LiveHistory held = history;
  history.append(batchOf(5.0, 70'000).samples);
  QVERIFY(history.first() > held.end());
  QCOMPARE(history.at(history.first()).time_s, 14.999);
  QCOMPARE(held.first(), uint64_t{0});
  QCOMPARE(held.end(), uint64_t{5000});
  QCOMPARE(held.newest()->time_s, 4.999);
  QCOMPARE(held.nearest(2.0004)->time_s, 2.0);
  QCOMPARE(held.nearest(99.0)->time_s, 4.999);
  QCOMPARE(held.between(4.0, 99.0).size(), size_t{1000});
  history.clear();
  QVERIFY(!history.newest() && held.newest());
  QCOMPARE(history.first(), uint64_t{75'000});
}

void TestSession::emptyStretch_isAnError() {
  Parts parts;
  LiveSamples live(parts.connection, parts.project, parts.messages);
  QVERIFY(!live.stretch(live.history(), 0.0, 1.0).ok());
  live.startRecording();
  QVERIFY(!live.recording());  // there is no board to record
}

void TestSession::recording_holdsEverySampleFromItsStart() {
  Parts parts;
  LiveSamples live(parts.connection, parts.project, parts.messages);
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  live.startRecording();
  QVERIFY(live.recording() && live.lastRecording().isEmpty());
  QTest::qWait(500);
  live.finishRecording();
  QTRY_VERIFY(!live.recording());
  const auto recording = readRecording(live.lastRecording().toStdString());
  VERIFY_OK(recording);
  const auto time = recording->time();
  QVERIFY2(time.size() > 100, qPrintable(QString::number(time.size())));
  for (size_t k = 1; k < time.size(); ++k) QVERIFY(std::abs(time[k] - time[k - 1] - 1e-3) < 1e-9);
  QVERIFY(parts.lines().contains(QString("Recorded %1 samples").arg(time.size())));
  QTRY_COMPARE(parts.kept().size(), size_t{1});
  QTRY_COMPARE(parts.kept().front().state, RunState::whole);
  const QString csv = QString::fromStdString(parts.folder.path("r.csv"));
  live.saveLast(csv);
  QTRY_VERIFY(QFile::exists(csv));
  QCOMPARE(readCsv(csv.toStdString())->rows(), time.size());
}

void TestSession::lostSamples_areGapsOfTheRecording() {
  Parts parts;
  LiveSamples live(parts.connection, parts.project, parts.messages);
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  live.startRecording();
  QTRY_VERIFY(parts.connection.link().recorded_s > 0.0);
  parts.witness->lose = 3;
  QTRY_COMPARE(parts.witness->lose.load(), size_t{0});
  QTest::qWait(50);
  live.finishRecording();
  QTRY_VERIFY(!live.recording());
  const auto survey = surveyBlocks(live.lastRecording().toStdString());
  VERIFY_OK(survey);
  QCOMPARE(survey->lost(), uint64_t{3});
  QCOMPARE(survey->gaps.size(), size_t{1});
}

void TestSession::lostBoard_leavesItsRecordingAndSamples() {
  Parts parts;
  LiveSamples live(parts.connection, parts.project, parts.messages);
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  live.startRecording();
  QTRY_VERIFY(parts.connection.link().recorded_s > 0.2);
  parts.witness->cableCut = true;
  QTRY_VERIFY(!live.recording());
  QVERIFY(live.history().newest() && live.lost_s().has_value());
  QCOMPARE(*live.lost_s(), live.history().newest()->time_s);
  QVERIFY2(live.stretch(live.history(), 0.0, 1e9).ok(), "the samples can still be exported");
  const auto recording = readRecording(live.lastRecording().toStdString());
  VERIFY_OK(recording);
  QVERIFY(recording->rows() > 150);
  const std::pair<std::string, std::string> why{"ended_by", "the link was lost"};
  QVERIFY(std::count(recording->notes().begin(), recording->notes().end(), why) == 1);
  QTRY_COMPARE(parts.kept().front().state, RunState::cut);
  const auto said = parts.lines();
  QVERIFY(std::any_of(said.begin(), said.end(),
                      [](const QString& line) { return line.contains("Kept in the project: Recording of 20"); }));
  parts.witness->cableCut = false;
  const double lost_s = *live.lost_s();
  const uint64_t before = live.history().end();
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  QVERIFY2(!live.current(), "what the lost board said last is not what this one says");
  QTRY_VERIFY(live.history().end() > before);
  QVERIFY2(live.history().at(before).time_s > lost_s, "the board's clock began anew, the history's goes on");
  QVERIFY(live.current() && live.lost_s() == lost_s);
  VERIFY_OK(live.stretch(live.history(), 0.0, 1e9));
}

void TestSession::fullDisk_endsARecordingInOrder() {
  Parts parts;
  const std::string path = parts.folder.path("r.blocks");
  auto writer = BlockWriter::create(path, {sampleColumns(Axis::rotary), {}});
  VERIFY_OK(writer);
  QString why, warned;
  std::atomic<bool> ended{false};
  RecorderOptions options;
  options.reserve_bytes = std::uint64_t{1} << 62U;  // more than any disk has free
  Recorder recorder(std::move(*writer),
                    {[&](const RecordingEnd& end) {
                       why = QString::fromStdString(end.why);
                       ended = true;
                     },
                     {}},
                    options);
  const SampleBatch batch = batchOf(0.0, 500);
  recorder.append(batch.samples, 0);
  QTRY_VERIFY(ended.load());
  QCOMPARE(why, QString("the disk is full"));
  const auto survey = surveyBlocks(path);
  VERIFY_OK(survey);
  QVERIFY(survey->ended && survey->rows == 500);
}

void TestSession::almostFullDisk_isAnnounced() {
  Parts parts;
  auto writer = BlockWriter::create(parts.folder.path("r.blocks"), {sampleColumns(Axis::rotary), {}});
  VERIFY_OK(writer);
  std::atomic<int> warnings{0};
  RecorderOptions options;
  options.warnBefore_s = 1e18;
  Recorder recorder(std::move(*writer), {{}, [&](const std::string&) { ++warnings; }}, options);
  for (int k = 0; k < 6; ++k) {
    recorder.append(batchOf(0.5 * k, 500).samples, 0);
    QTest::qWait(400);
  }
  QCOMPARE(warnings.load(), 1);  // once
}

void TestSession::runs_sayWhyTheyCannotStart() {
  Parts parts;
  BenchRuns bench(parts.connection, parts.messages);
  for (const QString& why : {bench.turningObstacle(), bench.stepObstacle(), bench.obstacleToMake(RunKind::homing),
                             bench.obstacleToMake(RunKind::breakaway), bench.gainsObstacle(), bench.tuningObstacle()})
    QCOMPARE(why, QString("No board is connected"));
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  QVERIFY(bench.obstacleToMake(RunKind::homing).isEmpty() && bench.stepObstacle().isEmpty());
  QVERIFY(bench.obstacleToMake(RunKind::breakaway).isEmpty());
  QCOMPARE(bench.missingFor(RunKind::breakaway),
           QString("First: current sensor's zero, wiring check, winding test, spin test, reversal test, homing, "
                   "velocity sweep"));
  bench.make(RunKind::homing);
  QTRY_VERIFY(parts.connection.runs(RunKind::homing));
  QVERIFY2(bench.stepObstacle().startsWith("Busy: "), qPrintable(bench.stepObstacle()));
}

void TestSession::measuredSteps_areKeptUntilAnotherBoardComes() {
  Parts parts;
  BenchRuns bench(parts.connection, parts.messages);
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  VelocityStepOptions options;
  options.to_rad_per_s = 10.0;
  bench.measureStep(options);
  QTRY_COMPARE_WITH_TIMEOUT(bench.steps().size(), size_t{1}, 20000);
  QCOMPARE(bench.steps().front().options.to_rad_per_s, 10.0);
  QVERIFY(bench.steps().front().settings == parts.connection.settings());
  parts.connection.stop();
  QTRY_COMPARE(parts.connection.stateWords(), QString("stopped"));
  QCOMPARE(bench.steps().size(), size_t{1});  // a report of the same run is no new step
  parts.connection.close();
  QCOMPARE(bench.steps().size(), size_t{1});
  parts.connection.open("simulated:servo");
  QVERIFY(bench.steps().empty());
}

void TestSession::surveyOfAnotherBoard_waitsForIt() {
  Parts parts;
  BenchRuns bench(parts.connection, parts.messages);
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  RunSnapshot swept{RunKind::velocitySweep, {Procedure::State::running, 0.5, 1.0, "sweeping", ""}, {}};
  Commission known;
  known.identity = parts.connection.identity();
  known.settings = parts.connection.settings();
  known.runs.resize(3);
  known.facts = {Known::index, Known::motor};
  swept.result = std::make_shared<const Commission>(known);
  emit parts.connection.runReported(swept);
  QCOMPARE(bench.known().runs.size(), size_t{3});
  QVERIFY(bench.index_rad().has_value());
  parts.connection.close();
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  QCOMPARE(bench.known().runs.size(), size_t{3});                    // the same board again
  QVERIFY(bench.known().knows(Known::motor) && !bench.index_rad());  // which may count from elsewhere now
  parts.connection.open("simulated:servo");
  QVERIFY(parts.connection.connected());
  QVERIFY(bench.known().runs.empty() && bench.bench().has_value());
  QVERIFY(
      parts.lines().contains("This is another board: what was measured on small drive is kept until it comes back"));
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  QCOMPARE(bench.known().runs.size(), size_t{3});
  QVERIFY(bench.known().knows(Known::motor));
}

void TestSession::anotherBoardOfTheModel_isToldByItsSerialNumber() {
  Parts parts;
  BenchRuns bench(parts.connection, parts.messages);
  const auto meet = [&parts](const char* serial) {
    parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness, serial), "small");
  };
  const auto measure = [&](size_t runs) {
    Commission known;
    known.identity = parts.connection.identity();
    known.settings = parts.connection.settings();
    known.runs.resize(runs);
    RunSnapshot swept{RunKind::velocitySweep, {Procedure::State::running, 0.5, 1.0, "sweeping", ""}, {}};
    swept.result = std::make_shared<const Commission>(known);
    emit parts.connection.runReported(swept);
  };
  meet("0042");
  measure(3);
  meet("0043");
  QVERIFY(bench.known().runs.empty());
  QVERIFY(parts.lines().contains(
      "This is another board: what was measured on small drive (0042) is kept until it comes back"));
  measure(5);
  meet("0042");
  QCOMPARE(bench.known().runs.size(), size_t{3});
  meet("");  // a firmware from before it told: nothing says that it is another board
  QCOMPARE(bench.known().runs.size(), size_t{3});
}

void TestSession::bridgesCurve_isGivenToTheBoard_andARefusalSaid() {
  const std::string presets = qgetenv("BREAKAWAY_SOURCE_DIR").toStdString() + "/resources/presets/";
  auto believed = readBench(presets + "servo.bench.json");
  QVERIFY(believed.ok());
  believed->dutyCurve.points = {{0.02, {0.0, 0.001}}, {0.5, {0.45, 0.001}}, {1.0, {0.98, 0.001}}};
  const TemporaryFolder folder;
  const std::string rig = folder.path("own.rig.json");
  QVERIFY(QFile::copy(QString::fromStdString(presets + "servo.rig.json"), QString::fromStdString(rig)));
  QVERIFY(writeBench(*believed, folder.path("own.bench.json")).ok());
  Parts parts;
  BenchRuns bench(parts.connection, parts.messages);
  parts.connection.adopt(std::make_unique<StubbornDrive>(parts.witness), QString::fromStdString("simulated:" + rig));
  QVERIFY(bench.bench().has_value());
  QTRY_COMPARE(parts.lines().back(), QString("board: refuses a curve of 3 points"));
}

void TestSession::page_worksWithItsPartsAlone() {
  Parts parts;
  BenchRuns bench(parts.connection, parts.messages);
  LiveSamples live(parts.connection, parts.project, parts.messages);
  SettingsEdits edits(parts.connection, parts.messages);
  TunePage tune(parts.connection, bench, edits);
  HomePage home(parts.connection, bench, live);
  QVERIFY(!named<QPushButton>(tune, "measureStepButton")->isEnabled());
  parts.connection.adopt(std::make_unique<SmallDrive>(parts.witness), "small");
  QVERIFY(named<QPushButton>(tune, "measureStepButton")->isEnabled());
  QVERIFY(named<QPushButton>(home, "homeButton")->isEnabled());
  tune.show();
  press(tune, "measureStepButton");
  QTRY_COMPARE_WITH_TIMEOUT(named<QTableWidget>(tune, "stepTable")->rowCount(), 1, 20000);
}

JOURNEY_MAIN(TestSession)
#include "tst_session.moc"
