// Legs that the board runs by itself: the same machines as on the host, begun once, ended with whatever stops the
// motor.
#include <QTest>
#include <cmath>
#include <set>

#include "experiment/timed_procedure.h"
#include "firmware_link/board_drive.h"
#include "firmware_link/leg_start.h"
#include "firmware_link/simulated_board.h"
#include "support/firmware_stream.h"
#include "support/temporary.h"

using namespace breakaway;
using namespace breakaway::test;

class TestBoardLegs : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void board_goesThroughTheStagesThatTheHostWould_data();
  void board_goesThroughTheStagesThatTheHostWould();
  void hostSaysLittleWhileTheBoardRuns();
  void stopInALeg_endsItForGood();
  void startSaidTwice_isOne();
  void planThatIsNoNumber_isRefused();
  void powerOfTwo_isExactEnoughForARamp();
  void rotorThatSlipsOverTheIndex_isHomed_data();
  void rotorThatSlipsOverTheIndex_isHomed();
};

namespace {

constexpr double countsPerRev = 14400.0;

/// Nothing but one leg.
class OneLeg final : public TimedProcedure {
 public:
  explicit OneLeg(const Leg& leg) : wanted_(leg) {}
  LegPhase ended = notBegun;

 private:
  Command run(const Sample&) override {
    if (isFirst()) beginLeg(wanted_, countsPerRev);
    if (legHasEnded(legPhase())) ended = legPhase(), endLeg(), finish();
    return {};
  }
  Progress progress() const override { return {0.0, 0.0, "on one leg"}; }
  Leg wanted_;
};

Leg homing() {
  return {HomingPlan<double>{3.0, 0.8, 0.25, 0.02, 1.5, 60.0, 3.0, 2}, 0.0, 0.0};
}
Leg speed(double run_s = 1.5) {
  return {SpeedPlan<double>{20.0, 0.015, 0.6, run_s, 2}, 0.0, 0.0};
}
Leg breaksAway(bool learning) {
  BreakawayPlan<double> plan{0, 0.01, 0.3, 0.03, 1.5, 0.12, 1.0, 0.075, true, 0.0, 1.2, 0.24, {}, 4, 0.15};
  plan.ramp = {learning ? 0.0 : 0.1, learning ? 0.0 : 0.3, 3.0, learning};
  return {plan, 0.7, 0.0};
}

struct Wired {
  std::shared_ptr<FirmwareStream::Far> far = std::make_shared<FirmwareStream::Far>(presetRig("servo"));
  std::unique_ptr<Drive> drive;
  std::vector<Sample> samples;

  Wired() {
    auto opened = openBoardDrive(std::make_unique<FirmwareStream>(far), {});
    if (!opened) qFatal("%s", opened.error().message().c_str());
    drive = std::move(*opened);
  }
  void run(const std::shared_ptr<OneLeg>& leg, double most_s) {
    drive->start(leg);
    for (double t = 0.0; t < most_s && leg->state() == Procedure::State::running; t += 0.1) {
      const auto lost = drive->advance(0.1, samples);
      if (!lost || *lost != 0) qFatal("samples were lost");
    }
  }
};

/// The board of a drive on the other end, spoken to without one.
struct Told {
  SimulatedFirmware firmware{presetRig("servo"), 1, board::Pace::real, 5};
  std::uint16_t sequence = 0;

  wire::Code send(wire::Type type, const std::vector<std::uint8_t>& body) {
    std::uint8_t frame[wire::mostFrame];
    const std::size_t size = wire::FrameEncoder::encode({static_cast<std::uint8_t>(type), ++sequence, body}, frame);
    firmware.receive(std::span(frame).first(size));
    std::vector<std::uint8_t> out;
    firmware.transmit(out);
    wire::FrameDecoder decoder;
    for (const std::uint8_t byte : out) {
      if (decoder.take(byte) && decoder.frame().type == (static_cast<std::uint8_t>(type) | wire::answerBit))
        return static_cast<wire::Code>(decoder.frame().body.front());
    }
    return wire::Code::unknown;
  }
  wire::Code start(const Leg& leg, std::uint8_t number, std::uint16_t latch) {
    const LegStart message =
        legStart(leg, {number, wire::MotorCommand::watched, latch, 0.0f}, 2.0 * M_PI / countsPerRev);
    return send(message.type, message.body);
  }
  void run(int ticks) {
    for (int k = 0; k < ticks; ++k) {
      if (k % 500 == 0) send(wire::Type::heartbeat, {0, 0, 0, 0});
      firmware.tickWithoutSending();
    }
  }
};

}  // namespace

void TestBoardLegs::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestBoardLegs::board_goesThroughTheStagesThatTheHostWould_data() {
  QTest::addColumn<int>("which");
  QTest::addColumn<int>("end");
  QTest::addColumn<int>("stages");
  QTest::newRow("homing") << 0 << static_cast<int>(HomingLeg<float>::done) << 4;
  QTest::newRow("speed") << 1 << static_cast<int>(SpeedLeg<float>::done) << 2;
  QTest::newRow("breakaway") << 2 << static_cast<int>(BreakawayLeg<float>::broke) << 3;
  QTest::newRow("breakaway, nothing expected") << 3 << static_cast<int>(BreakawayLeg<float>::broke) << 3;
}

void TestBoardLegs::board_goesThroughTheStagesThatTheHostWould() {
  QFETCH(int, which);
  QFETCH(int, end);
  QFETCH(int, stages);
  const Leg leg = which == 0 ? homing() : which == 1 ? speed() : breaksAway(which == 3);
  Wired wired;
  QVERIFY(wired.drive->identity().can.runsLegs);
  const auto procedure = std::make_shared<OneLeg>(leg);
  wired.run(procedure, 30.0);
  QCOMPARE(static_cast<int>(procedure->ended), end);
  // On what the board saw, in double precision.
  LegRunner host(countsPerRev);
  host.begin(leg);
  std::size_t seen = 0, differ = 0;
  std::set<int> met;
  for (const Sample& sample : wired.samples) {
    if (seen == 0 && sample.legPhase == notBegun) continue;
    ++seen;
    const LegPhase expected = host.step(sample);
    if (expected != sample.legPhase) ++differ;
    met.insert(sample.legPhase);
    if (legHasEnded(sample.legPhase)) break;
  }
  QCOMPARE(static_cast<int>(met.size()), stages + 1);
  // What floats is compared in single precision on the board, so that a stage may begin a look later.
  QVERIFY2(differ <= (which == 0 ? 0u : 8u), qPrintable(QString("%1 of %2").arg(differ).arg(seen)));
}

void TestBoardLegs::hostSaysLittleWhileTheBoardRuns() {
  Wired wired;
  const auto leg = std::make_shared<OneLeg>(speed(5.0));
  const std::uint32_t before = wired.far->board->board().received().good;
  wired.run(leg, 30.0);
  QCOMPARE(leg->ended, LegPhase(SpeedLeg<float>::done));
  const double lasted_s = wired.samples.back().time_s - wired.samples.front().time_s;
  const std::uint32_t said = wired.far->board->board().received().good - before;
  // Heartbeats every 50 ms, the start, and the off after its end.
  QVERIFY2(said < 22.0 * lasted_s + 20.0, qPrintable(QString("%1 frames in %2 s").arg(said).arg(lasted_s)));
  // The clock that is granted stood when the leg had ended: hardly any tick was lost until the next word.
  std::size_t after = 0;
  for (const Sample& sample : wired.samples) after = sample.enabled ? 0 : after + 1;
  QVERIFY2(after < 600, qPrintable(QString::number(after)));
}

void TestBoardLegs::stopInALeg_endsItForGood() {
  Told board;
  QCOMPARE(board.start(speed(), 1, 5), wire::Code::ok);
  board.run(3000);
  QVERIFY(board.firmware.enabled());
  QCOMPARE(board.send(wire::Type::stop, {}), wire::Code::ok);
  board.run(100);
  QVERIFY(!board.firmware.enabled());
  QCOMPARE(board.start(speed(), 2, 5), wire::Code::latched);
  board.run(100);
  QVERIFY(!board.firmware.enabled());
  QCOMPARE(board.start(speed(), 2, 6), wire::Code::ok);
  board.run(3000);
  QVERIFY(board.firmware.enabled());
  // Without a word the lease ends it as well.
  for (int k = 0; k < 1400; ++k) board.firmware.tickWithoutSending();
  QVERIFY(!board.firmware.enabled());
}

void TestBoardLegs::startSaidTwice_isOne() {
  Told board;
  QCOMPARE(board.start(speed(0.2), 1, 5), wire::Code::ok);
  for (int k = 0; k < 20; ++k) {
    board.run(1500);
    QCOMPARE(board.start(speed(0.2), 1, 5), wire::Code::ok);
  }
  QVERIFY(!board.firmware.enabled());  // begun anew each time it would never have come to its end
  QCOMPARE(board.start(speed(0.2), 2, 5), wire::Code::ok);
  board.run(100);
  QVERIFY(board.firmware.enabled());
}

void TestBoardLegs::planThatIsNoNumber_isRefused() {
  Told board;
  Leg bad = speed();
  std::get<SpeedPlan<double>>(bad.plan).wobble = std::nan("");
  QCOMPARE(board.start(bad, 1, 5), wire::Code::notAValue);
  board.run(100);
  QVERIFY(!board.firmware.enabled());
}

void TestBoardLegs::powerOfTwo_isExactEnoughForARamp() {
  for (int k = 0; k <= 30'000; ++k) {
    const double x = 1e-3 * k;
    QVERIFY(std::abs(powerOfTwo(x) / std::exp2(x) - 1.0) < 4.4e-6);
  }
  QCOMPARE(powerOfTwo(1e9), std::exp2(30.0));
}

void TestBoardLegs::rotorThatSlipsOverTheIndex_isHomed_data() {
  QTest::addColumn<double>("coasts_s");
  QTest::newRow("from rest") << 0.0;
  QTest::newRow("while it still coasts over an index or two") << 0.5;
}

/// It stands for 0.3 s, then slips by a third of a turn at nine times the speed of the search, over the index each
/// time: only what coasts from before the search is too fast to count.
void TestBoardLegs::rotorThatSlipsOverTheIndex_isHomed() {
  QFETCH(double, coasts_s);
  constexpr double tick_s = 1e-3, turn = 6.283185307179586, counts = 64.0, fast = 140.0, index_rad = 1.5 * turn / 3.0;
  HomingLeg<double> leg;
  leg.begin({14.7, 4.9, 1.0, 0.2, 2.2, 60.0, 3.0, 2}, {static_cast<std::int32_t>(counts)});
  double angle = 0.0, verified_s = 0.0, slipEnd = 0.0;
  LegPhase phase = notBegun;
  for (std::uint32_t k = 0; k < 60'000 && !legHasEnded(phase); ++k) {
    const double time_s = k * tick_s, in_s = time_s - 0.3 * std::floor(time_s / 0.3), before = angle;
    const double way = leg.ask().target < 0.0 ? -1.0 : 1.0;
    if (in_s < 0.5 * tick_s) slipEnd = angle + way * turn / 3.0;
    const bool slow = phase == HomingLeg<double>::backOff || phase == HomingLeg<double>::approach;
    const bool slips = time_s < coasts_s || (!slow && way * (slipEnd - angle) > 0.0);
    const double speed = slips ? way * fast : slow ? leg.ask().target : 0.0;
    angle += speed * tick_s;
    const bool index = std::floor((angle - index_rad) / turn) != std::floor((before - index_rad) / turn);
    phase = leg.step({k * 1000, static_cast<std::int32_t>(std::floor(angle / turn * counts)), index, speed, 24.0});
    if (phase == HomingLeg<double>::verify && verified_s == 0.0) verified_s = time_s;
  }
  QCOMPARE(int(phase), int(HomingLeg<double>::done));
  QVERIFY2(verified_s >= coasts_s, qPrintable(QString::number(verified_s)));
}

QTEST_APPLESS_MAIN(TestBoardLegs)
#include "tst_board_legs.moc"
