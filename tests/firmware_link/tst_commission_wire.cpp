#include <QElapsedTimer>
#include <QProcess>
#include <QTest>
#include <array>
#include <cmath>

#include "commission/commission.h"
#include "experiment/homing.h"
#include "firmware_link/board_drive.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/simulated_truth.h"
#include "firmware_link/transport/open_board.h"
#include "house/program.h"
#include "support/firmware_stream.h"
#include "support/map_accuracy.h"
#include "support/sanitized.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestCommissionWire : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void rig_isCommissionedOverTheWireAndInProcess_data();
  void rig_isCommissionedOverTheWireAndInProcess();
  void mapsOverTheWire_areAsGoodAsInProcess();
  void boardInAProcessOfItsOwn_homes_data();
  void boardInAProcessOfItsOwn_homes();
  void hostThatIsGone_stopsTheMotorAndAnewOneArmsNothing();
  void frozenHost_findsTheMotorStoppedInWords();
  void wrongBoard_isOneLine_data();
  void wrongBoard_isOneLine();

 private:
  /// Sums of mean squares over the seeds: static, Coulomb, viscous.
  std::array<double, 3> wired_{}, direct_{};
  int commissioned_ = 0;
};

namespace {

constexpr const char* uri = "simulated:servo";

/// `breakaway-board` while this lives.
class BoardProcess {
 public:
  explicit BoardProcess(const QStringList& words) {
    process_.start(builtProgram("breakaway-board"), words);
    if (!process_.waitForStarted() || !process_.waitForReadyRead(10000)) qFatal("breakaway-board does not start");
    uri_ = QString::fromUtf8(process_.readLine()).trimmed().toStdString();
  }
  ~BoardProcess() {
    process_.terminate();
    process_.waitForFinished();
  }
  const std::string& uri() const { return uri_; }

 private:
  QProcess process_;
  std::string uri_;
};

std::unique_ptr<Drive> opened(const std::string& board) {
  auto drive = openBoard({.uri = board});
  if (!drive) qFatal("%s", drive.error().message().c_str());
  return std::move(*drive);
}

/// Mean squares of the relative errors: static, Coulomb, viscous.
std::array<double, 3> squares(Drive& drive) {
  CommissionOptions options;
  options.rig = "rig";
  options.sweeps.bins = 36;
  options.sweeps.turns = 1;
  options.sweeps.speedRun_s = 15.0;
  options.keepRecordings = false;
  const auto done = commission(drive, options);
  if (!done) qFatal("%s", done.error().message().c_str());
  const auto truth = trueMap(uri, options.sweeps.bins, done->map.totalVelocity_rad_per_s);
  std::array<double, 3> sums{};
  for (const Way way : {Way::cw, Way::ccw}) {
    sums[0] += std::pow(deviation(done->map, *truth, way, staticOf).rms, 2);
    sums[1] += std::pow(deviation(done->map, *truth, way, coulombOf).rms, 2);
    sums[2] += std::pow(deviation(done->map, *truth, way, viscousOf).rms, 2);
  }
  return sums;
}

}  // namespace

void TestCommissionWire::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

constexpr unsigned seeds = sanitized ? 1 : 12;  // fewer than 12 leave the ratio of two errors to chance

void TestCommissionWire::rig_isCommissionedOverTheWireAndInProcess_data() {
  QTest::addColumn<unsigned>("seed");
  for (unsigned seed = 1; seed <= seeds; ++seed) QTest::addRow("seed %u", seed) << seed;
}

void TestCommissionWire::rig_isCommissionedOverTheWireAndInProcess() {
  QFETCH(unsigned, seed);
  const auto far = std::make_shared<FirmwareStream::Far>(presetRig("servo"), seed);
  auto board = openBoardDrive(std::make_unique<FirmwareStream>(far), {});
  VERIFY_OK(board);
  const auto inProcess = openDrive(uri, seed);
  const auto there = squares(**board), here = squares(**inProcess);
  for (std::size_t k = 0; k < 3; ++k) wired_[k] += there[k], direct_[k] += here[k];
  ++commissioned_;
}

void TestCommissionWire::mapsOverTheWire_areAsGoodAsInProcess() {
  QCOMPARE(commissioned_, static_cast<int>(seeds));
  if (seeds < 12) QSKIP("a ratio of few seeds is chance");
  for (std::size_t k = 0; k < 3; ++k) {
    const double ratio = std::sqrt(wired_[k] / direct_[k]);
    qInfo("%s: %.2f %% over the wire, %.2f %% in process, %.2f times", std::array{"static", "Coulomb", "viscous"}[k],
          100.0 * std::sqrt(wired_[k] / (2.0 * commissioned_)), 100.0 * std::sqrt(direct_[k] / (2.0 * commissioned_)),
          ratio);
    QVERIFY2(ratio < 1.2 && ratio > 0.5, qPrintable(QString::number(ratio)));
  }
}

void TestCommissionWire::boardInAProcessOfItsOwn_homes_data() {
  QTest::addColumn<QStringList>("words");
  QTest::newRow("pseudo terminal, granted") << QStringList{"--pace", "granted"};
  QTest::newRow("TCP, granted") << QStringList{"--pace", "granted", "--tcp", "0"};
}

void TestCommissionWire::boardInAProcessOfItsOwn_homes() {
  QFETCH(QStringList, words);
  const BoardProcess board(words);
  const auto drive = opened(board.uri());
  const auto homing = std::make_shared<Homing>();
  drive->start(homing);
  std::vector<Sample> samples;
  std::size_t missing = 0;
  while (homing->state() == Procedure::State::running) {
    const auto lost = drive->advance(0.1, samples);
    VERIFY_OK(lost);
    missing += *lost;
  }
  QVERIFY2(homing->state() == Procedure::State::finished, homing->status().failure.c_str());
  QCOMPARE(missing, std::size_t(0));
  for (std::size_t k = 1; k < samples.size(); ++k)
    QVERIFY(std::abs(samples[k].time_s - samples[k - 1].time_s - 0.0002) < 1e-9);
  const double index_rad = std::remainder(homing->indexAngle_rad().value, 2.0 * M_PI);
  QVERIFY2(std::abs(index_rad - 1.234) < 3.0 * 2.0 * M_PI / 14400.0, qPrintable(QString::number(index_rad, 'g', 8)));
}

/// The cable is pulled, or the host's process is killed: the same to a board.
void TestCommissionWire::hostThatIsGone_stopsTheMotorAndAnewOneArmsNothing() {
  const BoardProcess board({"--pace", "real", "--tcp", "0"});
  {
    const auto drive = opened(board.uri());
    drive->command({Command::Mode::velocity, 30.0, 0.0, false});
    std::vector<Sample> samples;
    VERIFY_OK(drive->advance(0.5, samples));
    QVERIFY(samples.back().enabled && samples.back().velocity_rad_per_s > 20.0);
  }
  QTest::qWait(600);
  const auto drive = opened(board.uri());
  std::vector<Sample> samples;
  VERIFY_OK(drive->advance(0.3, samples));
  QVERIFY(samples.size() > 500);
  for (const Sample& sample : samples)
    QVERIFY(!sample.enabled && std::abs(sample.velocity_rad_per_s) < 1.0);  // it has had time to come to rest
}

void TestCommissionWire::frozenHost_findsTheMotorStoppedInWords() {
  const BoardProcess board({"--pace", "real"});
  const auto drive = opened(board.uri());
  const auto homing = std::make_shared<Homing>();
  drive->start(homing);
  std::vector<Sample> samples;
  VERIFY_OK(drive->advance(0.3, samples));
  QVERIFY(samples.back().enabled);
  const double last_s = samples.back().time_s;
  QTest::qSleep(700);
  samples.clear();
  VERIFY_OK(drive->advance(0.3, samples));
  QCOMPARE(homing->state(), Procedure::State::stopped);
  QVERIFY2(homing->status().failure.find("the board opened the windings") != std::string::npos,
           homing->status().failure.c_str());
  for (const Sample& sample : samples) QVERIFY(!sample.enabled || sample.time_s < last_s + 0.4);
  QVERIFY(!samples.back().enabled);
}

void TestCommissionWire::wrongBoard_isOneLine_data() {
  QTest::addColumn<QString>("board");
  QTest::newRow("nothing listens") << "tcp:127.0.0.1:1";
  QTest::newRow("no such port") << "serial:/dev/no-such-port";
  QTest::newRow("no such scheme") << "usb:3";
}

void TestCommissionWire::wrongBoard_isOneLine() {
  QFETCH(QString, board);
  const TemporaryFolder folder;
  const Outcome outcome = run(builtProgram("breakaway"),
                              {"commission", "--board", board, "--out", QString::fromStdString(folder.path("out"))});
  QCOMPARE(outcome.status, 2);
  QCOMPARE(outcome.err.count('\n'), 1);
  QVERIFY2(outcome.err.startsWith("breakaway: "), qPrintable(outcome.err));
  QVERIFY(folder.names().isEmpty());
}

QTEST_GUILESS_MAIN(TestCommissionWire)
#include "tst_commission_wire.moc"
