#include <QTest>
#include <cmath>
#include <optional>
#include <random>

#include "firmware_link/simulated_firmware.h"
#include "support/firmware_stream.h"

using namespace breakaway;
using namespace breakaway::test;
using wire::Code;
using wire::FaultCode;
using wire::MotorCommand;
using wire::Type;

class TestReferenceBoard : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void silence_opensTheWindingsWithinTheLeaseAndATick_data();
  void silence_opensTheWindingsWithinTheLeaseAndATick();
  void heartbeats_keepTheMotorOn();
  void helloAfterALostLease_armsNothing();
  void staleCommandAfterAStop_isRefused();
  void grantedClock_runsAsFarAsGrantedAndNoFurther();
  void limits_holdWhateverIsAsked();
  void overSpeedTravelAndSupply_tripInTheTickInWhichTheyShow();
  void parameters_areTakenTogetherOrNotAtAll();
  void commandsOutOfOrder_areRefused();
  void unknownRequest_isAnsweredAndNothingElseHappens();
  void bridgesCurve_isCheckedUsedAndGivenBack();
  void staticFriction_pushesFromRestOnceItsChecksumFits();
  void fullOutbox_dropsSamplesAndCountsThem();
  void burst_keepsEveryTickFromTheCommandOn();
  void anyFrames_leaveTheBoardInItsLimits();
};

namespace {

/// The board and a rig, and a host that speaks to it in frames, tick by tick.
class Bench {
 public:
  explicit Bench(board::Pace pace, const Rig& rig = presetRig("servo")) : firmware_(rig, 1, pace, 77) {
    const auto hello = ask<wire::Hello>(Type::hello);
    latch = hello->latch;
  }

  template <typename Answer, typename... Question>
  std::optional<Answer> ask(Type type, const Question&... question) {
    send(type, question...);
    Answer answer;
    if (code != Code::ok || !wire::readMessage(std::span(answer_).subspan(1), answer)) return {};
    return answer;
  }

  /// Sends a frame and takes the answer's code; none came: unknown stays.
  template <typename... Question>
  void send(Type type, const Question&... question) {
    sendRaw(static_cast<std::uint8_t>(type), ++sequence, question...);
  }
  template <typename... Question>
  void sendRaw(std::uint8_t type, std::uint16_t number, const Question&... question) {
    std::uint8_t body[wire::mostBody], frame[wire::mostFrame];
    wire::Writer out(body);
    (out(question), ...);
    const std::size_t size = wire::FrameEncoder::encode({type, number, out.written()}, frame);
    answered = false;
    firmware_.receive(std::span(frame).first(size));
    collect();
  }

  std::optional<MotorCommand> command(MotorCommand::Mode mode, float target, std::uint8_t flags = 0) {
    MotorCommand wanted;
    wanted.mode = mode;
    wanted.target = target;
    wanted.flags = flags;
    wanted.latch = latch;
    return ask<MotorCommand>(Type::command, wanted);
  }
  void beat(std::uint32_t until = 0) { send(Type::heartbeat, wire::Heartbeat{until}); }
  void telemetry(std::uint32_t every = 1) {
    wire::ParameterList list;
    list.count = 1;
    list.value[0] = {static_cast<std::uint16_t>(board::Parameter::telemetryEvery), every};
    send(Type::writeParameters, list);
  }

  /// Runs ticks; true when the last one left the windings powered.
  bool run(std::size_t ticks) {
    std::vector<std::uint8_t> out;
    for (std::size_t k = 0; k < ticks && firmware_.board().mayTick(); ++k) {
      firmware_.run(1, out);
      collect(out);
      out.clear();
    }
    return firmware_.enabled();
  }
  /// Ticks until the windings are open, at most `most`.
  std::size_t ticksToOff(std::size_t most) {
    for (std::size_t k = 1; k <= most; ++k) {
      if (!run(1)) return k;
    }
    return most + 1;
  }

  SimulatedFirmware& firmware() { return firmware_; }
  std::optional<wire::Fault> fault() { return ask<wire::Fault>(Type::fault); }

  std::uint16_t latch = 0, sequence = 0;
  Code code = Code::unknown;
  bool answered = false;
  std::size_t samples = 0;
  std::uint32_t dropped = 0;
  std::optional<wire::BatchHeader> lastBatch;

 private:
  void collect() {
    std::vector<std::uint8_t> out;
    firmware_.transmit(out);
    collect(out);
  }
  void collect(const std::vector<std::uint8_t>& bytes) {
    for (const std::uint8_t byte : bytes) {
      if (!decoder_.take(byte)) continue;
      const wire::Frame frame = decoder_.frame();
      if (frame.type == static_cast<std::uint8_t>(Type::telemetry)) {
        wire::BatchHeader header;
        wire::readMessage(frame.body, header);
        samples += header.samples;
        dropped = header.dropped;
        lastBatch = header;
      } else if (frame.type < wire::unasked) {
        answer_.assign(frame.body.begin(), frame.body.end());
        code = static_cast<Code>(answer_.front());
        answered = true;
      }
    }
  }

  SimulatedFirmware firmware_;
  wire::FrameDecoder decoder_;
  std::vector<std::uint8_t> answer_;
};

constexpr std::size_t leaseTicks = 1250;  // 0.25 s at 5 kHz

}  // namespace

void TestReferenceBoard::initTestCase() {
  qputenv("BREAKAWAY_RESOURCES", qgetenv("BREAKAWAY_SOURCE_DIR") + "/resources");
}

void TestReferenceBoard::silence_opensTheWindingsWithinTheLeaseAndATick_data() {
  QTest::addColumn<int>("mode");
  QTest::addColumn<double>("target");
  QTest::newRow("voltage") << 1 << 1.0;
  QTest::newRow("current") << 2 << 0.5;
  QTest::newRow("velocity") << 3 << 30.0;
  QTest::newRow("position") << 4 << 2.0;
}

void TestReferenceBoard::silence_opensTheWindingsWithinTheLeaseAndATick() {
  QFETCH(int, mode);
  QFETCH(double, target);
  std::mt19937 random(5);
  for (int trial = 0; trial < 10; ++trial) {
    Bench bench(board::Pace::real);
    QVERIFY(bench.command(static_cast<MotorCommand::Mode>(mode), static_cast<float>(target), MotorCommand::fresh));
    for (int k = 0; k < 10; ++k) {
      bench.beat();
      QVERIFY(bench.run(200 + random() % 800));
    }
    bench.beat();
    const std::size_t ticks = bench.ticksToOff(5000);
    QVERIFY2(ticks > leaseTicks - 2 && ticks <= leaseTicks + 1, qPrintable(QString::number(ticks)));
    const auto fault = bench.fault();
    QVERIFY(fault && fault->code == FaultCode::leaseExpired);
    QVERIFY(!bench.run(5000));
  }
}

void TestReferenceBoard::heartbeats_keepTheMotorOn() {
  Bench bench(board::Pace::real);
  QVERIFY(bench.command(MotorCommand::Mode::velocity, 30.0f, MotorCommand::fresh));
  for (int k = 0; k < 100; ++k) {
    bench.beat();
    QVERIFY(bench.run(leaseTicks - 1));
  }
}

void TestReferenceBoard::helloAfterALostLease_armsNothing() {
  Bench bench(board::Pace::real);
  QVERIFY(bench.command(MotorCommand::Mode::velocity, 30.0f, MotorCommand::fresh));
  bench.run(2000);
  const auto hello = bench.ask<wire::Hello>(Type::hello);
  QVERIFY(hello && hello->latch != bench.latch);
  for (int k = 0; k < 20; ++k) {
    bench.beat();
    QVERIFY(!bench.run(500));
  }
  QVERIFY(!bench.command(MotorCommand::Mode::velocity, 30.0f));
  QCOMPARE(bench.code, Code::latched);
  QVERIFY(!bench.run(500));
  bench.latch = hello->latch;
  QVERIFY(bench.command(MotorCommand::Mode::velocity, 30.0f, MotorCommand::fresh));
  QVERIFY(bench.run(500));
}

void TestReferenceBoard::staleCommandAfterAStop_isRefused() {
  Bench bench(board::Pace::real);
  QVERIFY(bench.command(MotorCommand::Mode::voltage, 2.0f, MotorCommand::fresh));
  QVERIFY(bench.run(100));
  const auto alive = bench.ask<wire::Alive>(Type::stop);
  QVERIFY(alive && alive->latch != bench.latch);
  QVERIFY(!bench.run(1));
  QVERIFY(!bench.command(MotorCommand::Mode::voltage, 2.0f));
  QCOMPARE(bench.code, Code::latched);
  QVERIFY(!bench.run(100));
}

void TestReferenceBoard::grantedClock_runsAsFarAsGrantedAndNoFurther() {
  Bench bench(board::Pace::granted);
  QVERIFY(bench.command(MotorCommand::Mode::velocity, 30.0f, MotorCommand::fresh));
  bench.run(100);
  QCOMPARE(bench.firmware().board().ticks(), 0u);
  bench.beat(123);
  bench.run(10000);
  QCOMPARE(bench.firmware().board().ticks(), 123u);
  bench.beat(100000);  // at most 200 ms at once
  bench.run(100000);
  QCOMPARE(bench.firmware().board().ticks(), 1123u);
  bench.beat(500);  // one that comes late takes nothing back
  bench.run(100);
  QCOMPARE(bench.firmware().board().ticks(), 1123u);
  QVERIFY(bench.firmware().enabled());
}

void TestReferenceBoard::limits_holdWhateverIsAsked() {
  Bench bench(board::Pace::real);
  wire::ParameterList list;
  list.count = 2;
  list.value[0] = {static_cast<std::uint16_t>(board::Parameter::currentLimit), std::bit_cast<std::uint32_t>(1e6f)};
  list.value[1] = {static_cast<std::uint16_t>(board::Parameter::lease), std::bit_cast<std::uint32_t>(60.0f)};
  const auto accepted = bench.ask<wire::ParameterList>(Type::writeParameters, list);
  QVERIFY(accepted);
  const float limit_A = std::bit_cast<float>(accepted->value[0].word);
  QVERIFY(limit_A > 1.0f && limit_A < 13.0f);
  QCOMPARE(std::bit_cast<float>(accepted->value[1].word), 0.25f);
  const auto command = bench.command(MotorCommand::Mode::current, 1e9f, MotorCommand::fresh);
  QVERIFY(command);
  for (int k = 0; k < 50; ++k) {
    bench.beat();
    bench.run(20);
    QVERIFY(std::abs(bench.firmware().current_A()) < 1.1 * static_cast<double>(limit_A));
  }
  for (const float wrong : {std::nanf(""), INFINITY}) {
    QVERIFY(!bench.command(MotorCommand::Mode::current, wrong));
    QCOMPARE(bench.code, Code::notAValue);
  }
  QVERIFY(!bench.command(static_cast<MotorCommand::Mode>(9), 1.0f));
}

void TestReferenceBoard::overSpeedTravelAndSupply_tripInTheTickInWhichTheyShow() {
  const auto tripped = [](board::Parameter limit, float value, const Rig& rig = presetRig("servo")) {
    Bench bench(board::Pace::real, rig);
    wire::ParameterList list;
    list.count = 1;
    list.value[0] = {static_cast<std::uint16_t>(limit), std::bit_cast<std::uint32_t>(value)};
    bench.send(Type::writeParameters, list);
    bench.command(MotorCommand::Mode::voltage, 12.0f, MotorCommand::fresh);
    for (int k = 0; k < 40 && bench.firmware().enabled() | (k == 0); ++k) {
      bench.beat();
      bench.run(250);
    }
    const auto fault = bench.fault();
    return fault && !bench.firmware().enabled() ? fault->code : FaultCode::none;
  };
  QCOMPARE(tripped(board::Parameter::velocityTrip, 50.0f), FaultCode::overSpeed);
  QCOMPARE(tripped(board::Parameter::travelLimit, 3.0f), FaultCode::travel);
  QCOMPARE(tripped(board::Parameter::travelLimit, 1e6f), FaultCode::none);
  Rig sagging = presetRig("servo");
  RigFault fault;
  fault.kind = FaultKind::supplyDrop;
  fault.start_s = 0.5;
  fault.part = 0.4;
  sagging.faults = {fault};
  QCOMPARE(tripped(board::Parameter::travelLimit, 0.0f, sagging), FaultCode::supplyLow);
}

void TestReferenceBoard::parameters_areTakenTogetherOrNotAtAll() {
  Bench bench(board::Pace::real);
  wire::ParameterList list;
  list.count = 2;
  list.value[0] = {static_cast<std::uint16_t>(board::Parameter::velocityKp), std::bit_cast<std::uint32_t>(0.5f)};
  list.value[1] = {static_cast<std::uint16_t>(board::Parameter::velocityKi), std::bit_cast<std::uint32_t>(INFINITY)};
  QVERIFY(!bench.ask<wire::ParameterList>(Type::writeParameters, list));
  QCOMPARE(bench.code, Code::notAValue);
  auto now = bench.ask<wire::ParameterList>(Type::readParameters, list);
  QVERIFY(now && std::bit_cast<float>(now->value[0].word) != 0.5f);
  list.value[1].word = std::bit_cast<std::uint32_t>(0.25f);
  QVERIFY(bench.ask<wire::ParameterList>(Type::writeParameters, list));
  now = bench.ask<wire::ParameterList>(Type::readParameters, list);
  QVERIFY(now && std::bit_cast<float>(now->value[0].word) == 0.5f && std::bit_cast<float>(now->value[1].word) == 0.25f);
  list.value[1].id = 999;
  QVERIFY(!bench.ask<wire::ParameterList>(Type::writeParameters, list));
  QCOMPARE(bench.code, Code::noSuch);
}

void TestReferenceBoard::commandsOutOfOrder_areRefused() {
  Bench bench(board::Pace::real);
  QVERIFY(bench.command(MotorCommand::Mode::voltage, 1.0f, MotorCommand::fresh));
  QVERIFY(bench.command(MotorCommand::Mode::voltage, 2.0f));
  MotorCommand old;
  old.mode = MotorCommand::Mode::voltage;
  old.target = 9.0f;
  old.latch = bench.latch;
  bench.sendRaw(static_cast<std::uint8_t>(Type::command), static_cast<std::uint16_t>(bench.sequence - 1), old);
  QVERIFY(bench.answered);
  QCOMPARE(bench.code, Code::outdated);
  bench.run(5);
  QVERIFY(std::abs(bench.firmware().duty() - 2.0 / 24.0) < 0.01);
}

void TestReferenceBoard::unknownRequest_isAnsweredAndNothingElseHappens() {
  Bench bench(board::Pace::real);
  bench.sendRaw(0x3E, 50, std::uint32_t(1));
  QVERIFY(bench.answered);
  QCOMPARE(bench.code, Code::unknown);
  bench.sendRaw(0x85, 51, std::uint32_t(1));
  QVERIFY(!bench.answered);
  bench.sendRaw(static_cast<std::uint8_t>(Type::command), 52, std::uint8_t(1));
  QCOMPARE(bench.code, Code::malformed);
  QVERIFY(!bench.run(10));
}

void TestReferenceBoard::bridgesCurve_isCheckedUsedAndGivenBack() {
  Bench bench(board::Pace::real);
  wire::BridgeCurve curve;
  curve.count = 3;
  curve.point[0] = {0.02f, 0.0f};
  curve.point[1] = {0.3f, 0.2f};
  curve.point[2] = {0.7f, 0.6f};
  QVERIFY(bench.ask<wire::BridgeCurve>(Type::writeBridge, curve));
  const auto back = bench.ask<wire::BridgeCurve>(Type::readBridge);
  QVERIFY(back && back->count == 3 && back->point[1].input == 0.3f && back->point[2].output == 0.6f);
  const auto dutyFor = [&bench](float voltage) {
    bench.beat();
    bench.command(MotorCommand::Mode::voltage, voltage, MotorCommand::fresh);
    bench.run(1);
    return bench.firmware().duty();
  };
  const double step = 1.01 / 4800.0;  // the timer's
  QVERIFY(std::abs(dutyFor(2.4f) - (0.02 + 0.1 / 0.2 * 0.28)) < step);
  for (const float wrong : {0.19f, std::nanf("")}) {
    curve.point[2].output = wrong;
    QVERIFY(!bench.ask<wire::BridgeCurve>(Type::writeBridge, curve));
    QCOMPARE(bench.code, Code::notAValue);
  }
  QVERIFY(std::abs(dutyFor(2.4f) - 0.16) < step);
  QVERIFY(bench.ask<wire::BridgeCurve>(Type::writeBridge, wire::BridgeCurve{}));
  QVERIFY(std::abs(dutyFor(2.4f) - 0.1) < step);
}

void TestReferenceBoard::staticFriction_pushesFromRestOnceItsChecksumFits() {
  Bench bench(board::Pace::real);
  wire::Crc32c sum;
  wire::FrictionChunk chunk;
  chunk.count = 1;
  for (const auto& [curve, value] :
       {std::pair{0, 0.014f}, {1, 0.014f}, {2, 0.0f}, {3, 0.0f}, {4, 0.03f}, {5, 0.028f}}) {
    chunk.curve = static_cast<wire::FrictionCurve>(curve);
    chunk.value[0] = value;
    QVERIFY(bench.ask<wire::FrictionChunk>(Type::writeFriction, chunk));
    std::array<std::uint8_t, 4> bytes;
    wire::Writer out(bytes);
    out(value);
    sum.add(bytes);
  }
  wire::StaticFrictionUse use;
  use.table.bins = 1;
  use.table.blend_rad_per_s = 0.5f;
  use.stribeck_rad_per_s = 1.5f;
  use.table.checksum = sum.value() + 1;
  QVERIFY(!bench.ask<wire::StaticFrictionUse>(Type::useStatic, use));
  QCOMPARE(bench.code, Code::notAValue);
  const auto turnsBy = [&bench](float current) {
    bench.beat();
    bench.command(MotorCommand::Mode::current, current, MotorCommand::fresh);
    bench.run(600);
    const auto last = std::abs(bench.firmware().current_A());
    bench.command(MotorCommand::Mode::off, 0.0f);
    return last;
  };
  const double without = turnsBy(0.05f);
  use.table.checksum = sum.value();
  QVERIFY(bench.ask<wire::StaticFrictionUse>(Type::useStatic, use));
  const auto used = bench.ask<wire::StaticFrictionUse>(Type::staticUsed);
  QVERIFY(used && used->stribeck_rad_per_s == 1.5f && used->table.bins == 1 && used->table.checksum == sum.value());
  const auto moving = bench.ask<wire::FrictionUse>(Type::frictionUsed);
  QVERIFY(moving && moving->checksum != used->table.checksum);
  const double with = turnsBy(0.05f);
  QVERIFY2(with - without > 0.1, qPrintable(QString("%1 A, %2 A without").arg(with).arg(without)));
  chunk.curve = static_cast<wire::FrictionCurve>(6);
  QVERIFY(!bench.ask<wire::FrictionChunk>(Type::writeFriction, chunk));
  QCOMPARE(bench.code, Code::noSuch);
}

void TestReferenceBoard::fullOutbox_dropsSamplesAndCountsThem() {
  Bench bench(board::Pace::real);
  bench.telemetry();
  for (int k = 0; k < 20000; ++k) bench.firmware().tickWithoutSending();
  bench.run(100);
  QVERIFY(bench.lastBatch);
  QVERIFY(bench.dropped > 15000);
  const std::size_t seen = bench.samples + bench.dropped;
  QVERIFY2(seen <= 20100 && seen + 16 > 20100, qPrintable(QString::number(seen)));
}

void TestReferenceBoard::burst_keepsEveryTickFromTheCommandOn() {
  Bench bench(board::Pace::real);
  wire::Capture wanted;
  wanted.trigger = wire::Capture::Trigger::nextCommand;
  wanted.schema = wire::usualChannels;
  wanted.samples = 600;
  QVERIFY(bench.ask<wire::Capture>(Type::startCapture, wanted));
  bench.run(100);
  QVERIFY(bench.command(MotorCommand::Mode::voltage, 3.0f, MotorCommand::fresh));
  const std::uint32_t commandTick = bench.firmware().board().ticks();
  bench.run(1000);
  std::size_t got = 0;
  while (got < 600) {
    const auto body = [&] {
      struct Page {
        wire::CapturePage page;
        wire::BatchHeader header;
        static void pass(Page& p, wire::Reader& in) { in(p.page), in(p.header); }
      };
      return bench.ask<Page>(Type::readCapture, wire::CaptureAsked{static_cast<std::uint16_t>(got)});
    }();
    QVERIFY(body);
    QCOMPARE(body->page.taken, std::uint16_t(600));
    QCOMPARE(body->header.tick, commandTick + static_cast<std::uint32_t>(got));
    QVERIFY(body->header.samples > 0);
    got += body->header.samples;
  }
  QCOMPARE(got, std::size_t(600));
}

void TestReferenceBoard::anyFrames_leaveTheBoardInItsLimits() {
  std::mt19937 random(21);
  Bench bench(board::Pace::real);
  for (int k = 0; k < 30000; ++k) {
    std::uint8_t body[wire::mostBody], frame[wire::mostFrame];
    const std::size_t length = random() % 3 == 0 ? random() % wire::mostBody : random() % 24;
    for (std::size_t n = 0; n < length; ++n)
      body[n] = static_cast<std::uint8_t>(random() % 4 == 0 ? random() : random() % 6);
    const auto type = static_cast<std::uint8_t>(1 + random() % 0x12);
    const std::size_t size =
        wire::FrameEncoder::encode({type, static_cast<std::uint16_t>(k), std::span(body).first(length)}, frame);
    bench.firmware().receive(std::span(frame).first(size));
    bench.run(3);
    QVERIFY(std::abs(bench.firmware().current_A()) < 13.5 && std::abs(bench.firmware().duty()) <= 1.0);
  }
}

QTEST_APPLESS_MAIN(TestReferenceBoard)
#include "tst_reference_board.moc"
