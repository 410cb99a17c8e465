#include <QTest>
#include <cmath>

#include "firmware_link/burst_capture.h"
#include "support/firmware_stream.h"

using namespace breakaway;
using namespace breakaway::test;

class TestBurstCapture : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void burstWithACommand_holdsEveryTickFromItOnAndEndsStopped();
  void burstWithoutACommand_leavesTheMotorOff();
  void moreThanThereIsRoomFor_givesWhatThereIs();
  void faultMeanwhile_isToldInWords();
  void refusedCommand_isAnError();
};

namespace {

struct Opened {
  std::shared_ptr<FirmwareStream::Far> far = std::make_shared<FirmwareStream::Far>(presetRig("servo"));
  BoardLink link{std::make_unique<FirmwareStream>(far), "board"};
};

Result<CapturedBurst> captured(Opened& board, const BurstRequest& request) {
  const auto dictionary = BoardDictionary::read(board.link);
  if (!dictionary) return dictionary.error();
  return captureBurst(board.link, *dictionary, request);
}

}  // namespace

void TestBurstCapture::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestBurstCapture::burstWithACommand_holdsEveryTickFromItOnAndEndsStopped() {
  Opened board;
  const auto burst = captured(board, {.samples = 1500, .mode = wire::MotorCommand::Mode::voltage, .target = 3.0});
  QVERIFY2(burst.ok(), burst ? "" : burst.error().message().c_str());
  QCOMPARE(burst->samples.size(), std::size_t(1500));
  for (std::size_t k = 1; k < burst->samples.size(); ++k)
    QVERIFY(std::abs(burst->samples[k].time_s - burst->samples[k - 1].time_s - 2e-4) < 1e-9);
  QVERIFY(burst->samples.front().enabled && std::abs(burst->samples.front().velocity_rad_per_s) < 0.1);
  QVERIFY(std::abs(burst->samples.front().voltage_V - 3.0) < 0.01);
  QVERIFY(burst->samples.back().velocity_rad_per_s > 20.0);
  QVERIFY(burst->fault.empty());
  QVERIFY(!board.far->board->board().acts());
}

void TestBurstCapture::burstWithoutACommand_leavesTheMotorOff() {
  Opened board;
  const auto burst = captured(board, {.samples = 40, .every = 5});
  QVERIFY2(burst.ok(), burst ? "" : burst.error().message().c_str());
  QCOMPARE(burst->samples.size(), std::size_t(40));
  QVERIFY(std::abs(burst->samples.back().time_s - burst->samples.front().time_s - 39 * 5 * 2e-4) < 1e-9);
  for (const Sample& sample : burst->samples) QVERIFY(!sample.enabled);
}

void TestBurstCapture::moreThanThereIsRoomFor_givesWhatThereIs() {
  Opened board;
  const auto burst = captured(board, {.samples = 65535});
  QVERIFY2(burst.ok(), burst ? "" : burst.error().message().c_str());
  const std::size_t room = SimulatedFirmware::burstBytes / wire::sampleSize(wire::usualChannels);
  QCOMPARE(burst->samples.size(), room);
}

void TestBurstCapture::faultMeanwhile_isToldInWords() {
  Opened board;
  const auto dictionary = BoardDictionary::read(board.link);
  QVERIFY(dictionary && dictionary->write(board.link, {{"travel_limit_rad", 0.5}}));
  const auto burst = captureBurst(board.link, *dictionary,
                                  {.samples = 2000, .mode = wire::MotorCommand::Mode::velocity, .target = 20.0});
  QVERIFY2(burst.ok(), burst ? "" : burst.error().message().c_str());
  QVERIFY2(burst->fault.find("travel_limit_rad") != std::string::npos, burst->fault.c_str());
  QVERIFY(burst->samples.front().enabled && !burst->samples.back().enabled);
}

void TestBurstCapture::refusedCommand_isAnError() {
  Opened board;
  const auto burst =
      captured(board, {.samples = 10, .mode = wire::MotorCommand::Mode::current, .target = std::nan("")});
  QVERIFY(!burst.ok());
  QCOMPARE(burst.error().message(), std::string("board: refused a value (command)"));
  QVERIFY(!board.far->board->board().acts());
}

QTEST_APPLESS_MAIN(TestBurstCapture)
#include "tst_burst_capture.moc"
