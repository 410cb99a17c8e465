// The image on the emulated Cortex-M3, over a pty, through the code that a real port uses. Run by ./dev test firmware.
#include <QProcess>
#include <QTest>
#include <cmath>
#include <random>

#include "firmware/emulator.h"
#include "firmware_link/board_dictionary.h"
#include "firmware_link/board_drive.h"
#include "firmware_link/board_link.h"
#include "firmware_link/transport/open_byte_stream.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestCortexM3 : public QObject {
  Q_OBJECT
 private slots:
  void image_hasNoHeapAndNoExceptions();
  void imagesOwnCode_hasNoDoublePrecision();
  void bootText_isNoHindrance();
  void garbage_isCountedAndSurvived();
  void unknownType_isRefusedAndTheNextIsAnswered();
  void grantedClock_stopsWhereTheGrantEnds();
  void currentLimit_isTheBoardsOwn();
  void travelLimit_stopsAndLatches();
  void leaseThatRunsOut_stopsWithinATick();
  void reconnecting_neverArms();
};

namespace {

std::string imageFolder() {
  return qgetenv("BREAKAWAY_FIRMWARE_DIR").toStdString();
}
std::string granted() {
  return imageFolder() + "/emulated_board.elf";
}
std::string realPace() {
  return imageFolder() + "/emulated_board_real_pace.elf";
}

QStringList linesOf(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  if (!process.waitForFinished(30000) || process.exitCode() != 0)
    qFatal("%s: %s", qPrintable(program), process.readAllStandardError().constData());
  return QString::fromUtf8(process.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
}

BoardLink linkTo(const Emulator& emulator) {
  if (!emulator.runs()) qFatal("no emulator: %s", qPrintable(emulator.said()));
  auto stream = openByteStream(emulator.uri());
  if (!stream) qFatal("%s", stream.error().message().c_str());
  BoardLink link(std::move(*stream), "board");
  // A busy machine may take its time to start the emulator.
  const auto hello = link.ask<wire::Hello>(wire::Type::hello, BoardLink::Patience{0.5, 60});
  if (!hello) qFatal("%s", hello.error().message().c_str());
  return link;
}

Result<wire::Alive> beat(BoardLink& link, std::uint32_t untilTick) {
  return link.ask<wire::Alive>(wire::Type::heartbeat, wire::Heartbeat{untilTick}, {0.5, 10});
}

Result<wire::MotorCommand> command(BoardLink& link, wire::MotorCommand::Mode mode, float target, std::uint16_t latch) {
  wire::MotorCommand wanted;
  wanted.mode = mode;
  wanted.flags = wire::MotorCommand::fresh;
  wanted.latch = latch;
  wanted.target = target;
  return link.ask<wire::MotorCommand>(wire::Type::command, wanted, {0.5, 10});
}

Result<wire::Fault> fault(BoardLink& link) {
  const auto body = link.ask(wire::Type::fault, std::span<const std::uint8_t>{}, {0.5, 10});
  if (!body) return body.error();
  wire::Fault told;
  if (!wire::readMessage(*body, told)) return Error{"fault", "is too short"};
  return told;
}

/// Grants board time bit by bit, up to `untilTick`.
Result<wire::Alive> runTo(BoardLink& link, std::uint32_t untilTick) {
  auto told = beat(link, untilTick);
  while (told && static_cast<std::int32_t>(told->tick - untilTick) < 0) {
    if (auto took = link.take(0.02); !took) return took.error();
    told = beat(link, untilTick);
  }
  return told;
}

}  // namespace

void TestCortexM3::image_hasNoHeapAndNoExceptions() {
  static const QRegularExpression unwanted(
      "(^|_)(malloc|calloc|realloc|sbrk)(_r)?$|^_Zn[wa]|^_Zd[la]|__cxa_throw|__cxa_allocate|__dynamic_cast|_ZTI");
  int symbols = 0;
  for (const std::string& image : {granted(), realPace()}) {
    for (const QString& line : linesOf("arm-none-eabi-nm", {QString::fromStdString(image)})) {
      const QString name = line.section(' ', -1);
      QVERIFY2(!unwanted.match(name).hasMatch(), qPrintable(name));
      ++symbols;
    }
  }
  QVERIFY(symbols > 100);
}

void TestCortexM3::imagesOwnCode_hasNoDoublePrecision() {
  const QString objects = QString::fromStdString(imageFolder()) + "/CMakeFiles/emulated_board.dir/";
  static const QRegularExpression inDouble("__aeabi_(d(add|sub|mul|div|rsub|cmp|2)|f2d|i2d|ui2d|l2d|ul2d)");
  int floats = 0;
  for (const char* object : {"emulated_board.cpp.obj", "emulated_plant.cpp.obj"}) {
    for (const QString& line : linesOf("arm-none-eabi-nm", {"-u", objects + object})) {
      QVERIFY2(!inDouble.match(line).hasMatch(), qPrintable(line));
      floats += line.contains("__aeabi_fmul");
    }
  }
  QCOMPARE(floats, 2);  // both compute, and in single precision
}

void TestCortexM3::bootText_isNoHindrance() {
  const Emulator emulator(granted());
  QTest::qWait(300);  // the text has gone out before anybody asks
  BoardLink link = linkTo(emulator);
  const auto dictionary = BoardDictionary::read(link);
  VERIFY_OK(dictionary);
  QCOMPARE(dictionary->device(), std::string("emulated Cortex-M3, rig servo"));
  QVERIFY(dictionary->can(wire::Hello::grantedPace) && dictionary->can(wire::Hello::simulated));
  QCOMPARE(dictionary->hello().countsPerRev, 14400u);
  QCOMPARE(dictionary->hello().loopRate_Hz, 5000.0f);
}

void TestCortexM3::garbage_isCountedAndSurvived() {
  const Emulator emulator(granted());
  {
    auto stream = openByteStream(emulator.uri());
    VERIFY_OK(stream);
    std::mt19937 random(5);
    std::vector<std::uint8_t> bytes(20000);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    VERIFY_OK((*stream)->write(bytes));
    VERIFY_OK(BoardLink(std::move(*stream), "board").clear());
  }
  BoardLink link = linkTo(emulator);
  const auto told = beat(link, 50);
  VERIFY_OK(told);
  QCOMPARE(told->mode, wire::MotorCommand::Mode::off);
  VERIFY_OK(BoardDictionary::read(link));
}

void TestCortexM3::unknownType_isRefusedAndTheNextIsAnswered() {
  const Emulator emulator(granted());
  BoardLink link = linkTo(emulator);
  const auto refused = link.ask(static_cast<wire::Type>(0x3e), std::span<const std::uint8_t>{}, {0.5, 10});
  QVERIFY(!refused);
  QVERIFY2(refused.error().fact.find("does not know") != std::string::npos, refused.error().message().c_str());
  VERIFY_OK(beat(link, 0));
}

void TestCortexM3::grantedClock_stopsWhereTheGrantEnds() {
  const Emulator emulator(granted());
  BoardLink link = linkTo(emulator);
  VERIFY_OK(BoardDictionary::read(link));
  VERIFY_OK(runTo(link, 100));
  QTest::qWait(400);
  auto told = beat(link, 100);
  VERIFY_OK(told);
  QCOMPARE(told->tick, 100u);
  told = beat(link, 1000000);
  VERIFY_OK(told);
  QCOMPARE(told->untilTick - 100u, 1000u);  // 200 ms at 5 kHz and no more
  QTest::qWait(2000);
  told = beat(link, 100);
  VERIFY_OK(told);
  QCOMPARE(told->tick, 1100u);
}

void TestCortexM3::currentLimit_isTheBoardsOwn() {
  const Emulator emulator(granted());
  BoardLink link = linkTo(emulator);
  const auto dictionary = BoardDictionary::read(link);
  VERIFY_OK(dictionary);
  const auto accepted = dictionary->write(link, {{"current_limit_A", 1e6}, {"velocity_kp_A_s_per_rad", 1e4}});
  VERIFY_OK(accepted);
  const auto trip = dictionary->values(link, {"current_trip_A"});
  VERIFY_OK(trip);
  QVERIFY((*accepted)[0] > 1.0 && (*accepted)[0] < (*trip)[0]);
  VERIFY_OK(command(link, wire::MotorCommand::Mode::current, 1e6f, dictionary->hello().latch));
  VERIFY_OK(dictionary->write(link, {{"telemetry_channels", double(wire::usualChannels)}, {"telemetry_every", 1.0}}));
  SampleDecoder decoder(dictionary->telemetry());
  std::vector<Sample> samples;
  link.listen([&](const wire::Frame& frame) {
    if (frame.type == static_cast<std::uint8_t>(wire::Type::telemetry)) decoder.take(frame.body, samples);
  });
  VERIFY_OK(runTo(link, 1000));
  double most_A = 0.0;
  for (const Sample& sample : samples) most_A = std::max(most_A, std::abs(sample.current_reference_A));
  QVERIFY2(samples.size() > 500, qPrintable(QString::number(samples.size())));
  QVERIFY2(most_A > 0.9 * (*accepted)[0] && most_A < 1.001 * (*accepted)[0], qPrintable(QString::number(most_A)));
}

void TestCortexM3::travelLimit_stopsAndLatches() {
  const Emulator emulator(granted());
  BoardLink link = linkTo(emulator);
  const auto dictionary = BoardDictionary::read(link);
  VERIFY_OK(dictionary);
  VERIFY_OK(dictionary->write(link, {{"travel_limit_rad", 1.0}}));
  const std::uint16_t latch = dictionary->hello().latch;
  VERIFY_OK(command(link, wire::MotorCommand::Mode::velocity, 20.0f, latch));
  VERIFY_OK(runTo(link, 1500));
  const auto stopped = fault(link);
  VERIFY_OK(stopped);
  QCOMPARE(stopped->code, wire::FaultCode::travel);
  const auto told = beat(link, 0);
  VERIFY_OK(told);
  QCOMPARE(told->mode, wire::MotorCommand::Mode::off);
  const auto again = command(link, wire::MotorCommand::Mode::velocity, 20.0f, latch);
  QVERIFY2(!again, "a command from before the fault moved the motor");
  VERIFY_OK(command(link, wire::MotorCommand::Mode::velocity, 20.0f, told->latch));
}

void TestCortexM3::leaseThatRunsOut_stopsWithinATick() {
  const Emulator emulator(realPace());
  BoardLink link = linkTo(emulator);
  const auto dictionary = BoardDictionary::read(link);
  VERIFY_OK(dictionary);
  QVERIFY(!dictionary->can(wire::Hello::grantedPace));
  VERIFY_OK(command(link, wire::MotorCommand::Mode::voltage, 1.5f, dictionary->hello().latch));
  auto told = beat(link, 0);
  VERIFY_OK(told);
  QCOMPARE(told->mode, wire::MotorCommand::Mode::voltage);
  QTest::qWait(1500);  // by the wall's clock; the board counts its own
  const auto stopped = fault(link);
  VERIFY_OK(stopped);
  QCOMPARE(stopped->code, wire::FaultCode::leaseExpired);
  const std::uint32_t lease = 1250;  // ticks in 250 ms
  const std::uint32_t lasted = stopped->tick - told->tick;
  QVERIFY2(lasted >= lease && lasted <= lease + 1, qPrintable(QString::number(lasted)));
}

void TestCortexM3::reconnecting_neverArms() {
  const Emulator emulator(realPace());
  std::uint16_t latch = 0;
  {
    BoardLink link = linkTo(emulator);
    const auto dictionary = BoardDictionary::read(link);
    VERIFY_OK(dictionary);
    latch = dictionary->hello().latch;
    VERIFY_OK(command(link, wire::MotorCommand::Mode::voltage, 1.5f, latch));
  }
  QTest::qWait(1500);
  BoardLink link = linkTo(emulator);
  VERIFY_OK(BoardDictionary::read(link));
  const auto told = beat(link, 0);
  VERIFY_OK(told);
  QCOMPARE(told->mode, wire::MotorCommand::Mode::off);
  QCOMPARE(told->fault, wire::FaultCode::leaseExpired);
  QVERIFY(!command(link, wire::MotorCommand::Mode::voltage, 1.5f, latch));
}

QTEST_GUILESS_MAIN(TestCortexM3)
#include "tst_cortex_m3.moc"
