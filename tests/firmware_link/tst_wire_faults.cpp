#include <QTest>
#include <cmath>

#include "experiment/homing.h"
#include "firmware_link/board_drive.h"
#include "support/firmware_stream.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

/// What a bad line may cost is samples, all of them counted; never a wrong value, a crash, or a motor that runs on.
class TestWireFaults : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void badLine_losesOnlyWhatItCounts_data();
  void badLine_losesOnlyWhatItCounts();
  void slightlyBadLine_stillHomes();
  void stopOnABadLine_getsThrough();
  void anotherToolsStream_isNoBoard();
  void halfOpenLine_endsInOneLine();
  void resetInMidSweep_endsInWordsWithTheMotorOff();
};

namespace {

struct BadBoard {
  std::shared_ptr<FirmwareStream::Far> far;
  std::unique_ptr<Drive> drive;
};

/// The line goes bad once the board is known.
Result<BadBoard> opened(const Spoiling& spoiling, unsigned seed) {
  BadBoard made{std::make_shared<FirmwareStream::Far>(presetRig("servo")), nullptr};
  const auto goes = std::make_shared<Spoiling>();
  auto drive =
      openBoardDrive(std::make_unique<SpoiledStream>(std::make_unique<FirmwareStream>(made.far), goes, seed), {});
  if (!drive) return drive.error();
  made.drive = std::move(*drive);
  *goes = spoiling;
  return made;
}

}  // namespace

void TestWireFaults::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestWireFaults::badLine_losesOnlyWhatItCounts_data() {
  QTest::addColumn<double>("flipped");
  QTest::addColumn<double>("dropped");
  QTest::addColumn<double>("doubled");
  QTest::addColumn<double>("truncated");
  QTest::addColumn<double>("garbage");
  QTest::addColumn<double>("reordered");
  QTest::addColumn<bool>("bootText");
  QTest::newRow("one bit in 10000 bytes") << 1e-4 << 0. << 0. << 0. << 0. << 0. << false;
  QTest::newRow("a bit in 1 % of the bytes") << 0.01 << 0. << 0. << 0. << 0. << 0. << false;
  QTest::newRow("1 % of the bytes dropped") << 0. << 0.01 << 0. << 0. << 0. << 0. << false;
  QTest::newRow("frames doubled") << 0. << 0. << 0.2 << 0. << 0. << 0. << false;
  QTest::newRow("frames cut") << 0. << 0. << 0. << 0.05 << 0. << 0. << false;
  QTest::newRow("bursts of garbage") << 0. << 0. << 0. << 0. << 0.05 << 0. << false;
  QTest::newRow("frames out of order") << 0. << 0. << 0. << 0. << 0. << 0.2 << false;
  QTest::newRow("boot text in between") << 0. << 0. << 0. << 0. << 0. << 0. << true;
  QTest::newRow("all of it") << 1e-4 << 1e-4 << 0.05 << 0.02 << 0.02 << 0.05 << true;
}

void TestWireFaults::badLine_losesOnlyWhatItCounts() {
  QFETCH(double, flipped);
  QFETCH(double, dropped);
  QFETCH(double, doubled);
  QFETCH(double, truncated);
  QFETCH(double, garbage);
  QFETCH(double, reordered);
  QFETCH(bool, bootText);
  const Spoiling spoiling{flipped, dropped, doubled, truncated, garbage, reordered, bootText};
  const auto bad = opened(spoiling, 1);
  VERIFY_OK(bad);
  std::vector<Sample> samples;
  std::size_t lost = 0;
  for (const double target : {30.0, -20.0, 10.0}) {
    bad->drive->command({Command::Mode::velocity, target, 0.0, false});
    for (int k = 0; k < 4; ++k) {
      const auto missing = bad->drive->advance(0.05, samples);
      VERIFY_OK(missing);
      lost += *missing;
    }
  }
  QCOMPARE(samples.size() + lost, std::size_t(3000));
  const bool harmless = flipped + dropped + truncated + garbage + reordered == 0.0 && !bootText;
  QVERIFY(!harmless || lost == 0);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Sample& sample = samples[k];
    const double tick = sample.time_s * 5000.0;
    QVERIFY(std::abs(tick - std::round(tick)) < 1e-6);
    QVERIFY(k == 0 || sample.time_s > samples[k - 1].time_s);
    const double wanted = sample.velocity_reference_rad_per_s;
    QVERIFY2(wanted == 0.0 || wanted == 30.0 || wanted == -20.0 || wanted == 10.0, qPrintable(QString::number(wanted)));
    QVERIFY(std::abs(sample.velocity_rad_per_s) < 60.0 && std::abs(sample.current_A) < 10.0);
    QVERIFY(std::abs(sample.voltage_V) <= 24.1 && sample.supply_V > 23.0 && sample.supply_V < 25.0);
  }
}

void TestWireFaults::slightlyBadLine_stillHomes() {
  const auto bad = opened({.flipped = 2e-6, .doubled = 1e-3, .truncated = 3e-4, .garbage = 3e-4}, 3);
  VERIFY_OK(bad);
  const auto homing = std::make_shared<Homing>();
  bad->drive->start(homing);
  std::vector<Sample> samples;
  std::size_t lost = 0;
  while (homing->state() == Procedure::State::running) {
    const auto missing = bad->drive->advance(0.1, samples);
    VERIFY_OK(missing);
    lost += *missing;
  }
  QVERIFY2(homing->state() == Procedure::State::finished, homing->status().failure.c_str());
  QVERIFY(lost > 0 && lost < samples.size() / 20);
  QVERIFY(std::abs(std::remainder(homing->indexAngle_rad().value - 1.234, 2.0 * M_PI)) < 0.002);
}

void TestWireFaults::stopOnABadLine_getsThrough() {
  for (unsigned seed = 1; seed < 6; ++seed) {
    const auto bad = opened({.flipped = 2e-3, .truncated = 0.05}, seed);
    VERIFY_OK(bad);
    std::vector<Sample> samples;
    bad->drive->command({Command::Mode::velocity, 30.0, 0.0, false});
    VERIFY_OK(bad->drive->advance(0.2, samples));
    bad->drive->stop("pressed");
    QVERIFY(!bad->far->board->board().acts());
    VERIFY_OK(bad->drive->advance(0.2, samples));
    QVERIFY(!bad->far->board->enabled());
  }
}

void TestWireFaults::anotherToolsStream_isNoBoard() {
  /// Somebody else's frames, whatever is asked.
  class Chatter final : public ByteStream {
    Result<void> write(std::span<const std::uint8_t>) override { return {}; }
    Result<void> read(std::vector<std::uint8_t>& bytes, double) override {
      const std::uint8_t frame[] = {2, 1, 4, 0x40, 0x84, 3, 0, '1', '.', '2', '\t', '3', '\n'};
      bytes.insert(bytes.end(), std::begin(frame), std::end(frame));
      return {};
    }
  };
  const auto drive = openBoardDrive(std::make_unique<Chatter>(), {.place = "board serial:ttyX"});
  VERIFY_ERROR(drive,
               "board serial:ttyX: sends bytes that are no frames of the wire; is it another kind of board, or is the "
               "baud rate another?");
}

void TestWireFaults::halfOpenLine_endsInOneLine() {
  auto board = opened({}, 1);
  VERIFY_OK(board);
  std::vector<Sample> samples;
  VERIFY_OK(board->drive->advance(0.1, samples));
  const auto homing = std::make_shared<Homing>();
  board->drive->start(homing);
  VERIFY_OK(board->drive->advance(0.1, samples));
  board->far->silent = true;
  const auto lost = board->drive->advance(0.1, samples);
  QVERIFY(!lost.ok());
  QVERIFY2(lost.error().message().find("the link to the board is lost") != std::string::npos,
           lost.error().message().c_str());
  QCOMPARE(homing->state(), Procedure::State::stopped);
}

void TestWireFaults::resetInMidSweep_endsInWordsWithTheMotorOff() {
  auto board = opened({.doubled = 0.05}, 1);
  VERIFY_OK(board);
  const auto homing = std::make_shared<Homing>();
  board->drive->start(homing);
  std::vector<Sample> samples;
  VERIFY_OK(board->drive->advance(0.5, samples));
  board->far->powerUpAnew();
  QVERIFY(!board->drive->advance(0.5, samples).ok());
  QVERIFY(homing->status().failure.find("powered up anew") != std::string::npos);
  QVERIFY(!board->far->board->board().acts() && !board->far->board->enabled());
}

QTEST_APPLESS_MAIN(TestWireFaults)
#include "tst_wire_faults.moc"
