// Counts what the firmware's work costs on the chip: run in an emulator that gives each instruction the same time.
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "emulated_rig_data.h"
#include "firmware_link/board/cortex_m3/cmsdk_uart.h"
#include "firmware_link/board/cortex_m3/emulated_bench.h"
#include "firmware_link/board/cortex_m3/semihosting.h"
#include "firmware_link/board/cortex_m3/sys_tick.h"
#include "firmware_link/board/reference_board.h"

namespace breakaway {

namespace {

using Board = board::ReferenceBoard<float>;

/// The largest and the sum of what was timed, in clocks of the machine's timer.
struct Cost {
  std::uint32_t most = 0, sum = 0, count = 0;
  void add(std::uint32_t clocks) {
    most = clocks > most ? clocks : most;
    sum += clocks;
    ++count;
  }
};

class TickCost {
 public:
  TickCost() {
    tellAll();
    upload();
  }

  /// Everything on: `mode` with friction from a map of 180 bins, static friction in it, through the inverse of a
  /// bridge's curve, with all gains, telemetry of all channels, and a capture in every tick.
  void measure(const char* name, wire::MotorCommand::Mode mode, float target) {
    heartbeat();
    wire::MotorCommand command;
    command.mode = mode;
    command.latch = latch();
    command.target = target;
    command.flags = wire::MotorCommand::fresh;
    ask(wire::Type::command, command);
    const Cost send = timed(name);
    if (mode == wire::MotorCommand::Mode::velocity) report("sending", send);
  }

  /// The same on a leg that the board runs by itself.
  template <typename Start>
  void measure(const char* name, wire::Type type, Start start) {
    heartbeat();
    start.head.number = ++leg_;
    start.head.flags = wire::MotorCommand::fresh | wire::MotorCommand::watched;
    start.head.latch = latch();
    ask(type, start);
    timed(name);
  }

  void measureAsked() {
    Cost beat;
    for (int k = 0; k < 50; ++k) {
      ask(wire::Type::heartbeat, wire::Heartbeat{}, &beat);
    }
    report("heartbeat", beat);
    report("table", takingFriction_);
  }
  void tellRefused() {
    Cost refused;
    refused.add(refused_);
    report("refused", refused);
  }
  void measureTimer() {
    Cost empty;
    for (int k = 0; k < 1000; ++k) {
      const std::uint32_t from = timer_.now();
      empty.add(SysTick::between(from, timer_.now()));
    }
    report("timer", empty);
  }

 private:
  template <typename Message>
  void ask(wire::Type type, const Message& message, Cost* cost = nullptr) {
    std::array<std::uint8_t, wire::mostBody> body;
    wire::Writer out(body);
    out(message);
    std::array<std::uint8_t, wire::mostFrame> frame;
    const std::size_t length =
        wire::FrameEncoder::encode({static_cast<std::uint8_t>(type), ++sequence_, out.written()}, frame);
    const std::uint32_t from = timer_.now();
    board_.receive(std::span(frame).first(length));
    if (cost != nullptr) cost->add(SysTick::between(from, timer_.now()));
    drain();
  }

  void tellAll() {
    wire::ParameterList list;
    const auto set = [&list](board::Parameter which, std::uint32_t word) {
      list.value[list.count++] = {static_cast<std::uint16_t>(which), word};
    };
    const board::BoardHardware<float> made = hardware();
    const float kp = made.start.gains.velocity_kp_A_s_per_rad;
    set(board::Parameter::velocityKi, std::bit_cast<std::uint32_t>(2.0f * kp));
    set(board::Parameter::velocityKd, std::bit_cast<std::uint32_t>(1e-4f * kp));
    set(board::Parameter::positionKi, std::bit_cast<std::uint32_t>(2.0f * made.start.gains.position_kp_A_per_rad));
    set(board::Parameter::travelLimit, std::bit_cast<std::uint32_t>(1e4f));
    set(board::Parameter::telemetryEvery, 1);
    set(board::Parameter::telemetryChannels, wire::allChannels);
    ask(wire::Type::writeParameters, list);
  }

  void upload() {
    constexpr std::uint16_t bins = 180;
    constexpr std::array<float, wire::frictionCurves> means{0.017f, 0.017f, 2e-5f, 2e-5f, 0.022f, 0.021f};
    wire::Crc32c sum;
    for (std::uint8_t curve = 0; curve < wire::frictionCurves; ++curve) {
      for (std::uint16_t first = 0; first < bins; first = static_cast<std::uint16_t>(first + 90)) {
        wire::FrictionChunk chunk;
        chunk.curve = static_cast<wire::FrictionCurve>(curve);
        chunk.first = first;
        chunk.count = 90;
        for (int k = 0; k < 90; ++k) {
          chunk.value[k] = means[curve] * (1.0f + 0.001f * static_cast<float>(first + k));
          std::array<std::uint8_t, 4> bytes;
          wire::Writer out(bytes);
          out(chunk.value[k]);
          sum.add(out.written());
        }
        ask(wire::Type::writeFriction, chunk);
      }
    }
    wire::StaticFrictionUse use;
    use.table.bins = bins;
    use.table.checksum = sum.value();
    use.table.blend_rad_per_s = 0.5f;
    use.table.cutoff_rad_per_s = 500.0f;
    use.stribeck_rad_per_s = 1.5f;
    ask(wire::Type::useStatic, use, &takingFriction_);
    wire::BridgeCurve bridge;
    for (int k = 0; k < 6; ++k) {
      const float input = 0.01f + 0.03f * static_cast<float>(k * k);
      bridge.point[bridge.count++] = {input, 0.98f * (input - 0.01f)};
    }
    ask(wire::Type::writeBridge, bridge);
  }

  void heartbeat() {
    wire::Heartbeat beat;
    ask(wire::Type::heartbeat, beat);
  }

  std::uint16_t latch() { return hardware().boot; }

  /// Returns what sending costs.
  Cost timed(const char* name) {
    run(500, nullptr);
    Cost tick, send;
    run(2500, &tick, &send);
    report(name, tick);
    return send;
  }

  /// Takes what the board sends, and counts what it refused: a figure without the table would be another one.
  void drain() {
    while (const std::size_t size = board_.transmit(sent_)) {
      for (const std::uint8_t byte : std::span(sent_).first(size)) {
        if (!decoder_.take(byte)) continue;
        const wire::Frame frame = decoder_.frame();
        const bool answer = (frame.type & wire::unasked) == wire::answerBit;
        if (answer && !frame.body.empty() && frame.body[0] != 0) ++refused_;
      }
    }
  }
  /// What a port's sending takes off the board.
  void empty() {
    std::array<std::uint8_t, 512> part;
    while (board_.transmit(part) > 0) {
    }
  }

  void capture() {
    wire::Capture wanted;
    wanted.schema = wire::allChannels;
    wanted.samples = 0xffff;
    ask(wire::Type::startCapture, wanted);
  }

  void run(int ticks, Cost* tick, Cost* send = nullptr) {
    for (int k = 0; k < ticks; ++k) {
      if (k % 200 == 0) capture();  // there is room for 248 samples
      const board::Readings<float> readings = bench_.readings();
      const std::uint32_t from = timer_.now();
      const board::Drive<float> drive = board_.tick(readings);
      const std::uint32_t middle = timer_.now();
      empty();
      const std::uint32_t to = timer_.now();
      if (tick != nullptr) tick->add(SysTick::between(from, middle));
      if (send != nullptr) send->add(SysTick::between(middle, to));
      bench_.advance(drive);
      if (k % 250 == 0) heartbeat();
    }
    moved_ = board_.acts();
  }

  void say(const char* text) const {
    for (; *text != '\0'; ++text) {
      while (!uart_.hasRoom()) {
      }
      uart_.send(static_cast<std::uint8_t>(*text));
    }
  }
  void say(std::uint32_t number) const {
    std::array<char, 11> digits{};
    std::size_t at = digits.size() - 1;
    do {
      digits[--at] = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number > 0);
    say(&digits[at]);
  }
  void report(const char* name, const Cost& cost) const {
    say(name);
    say(" mean ");
    say(cost.sum / cost.count);
    say(" most ");
    say(cost.most);
    say(moved_ ? " acts 1\n" : " acts 0\n");
  }

  static board::BoardHardware<float> hardware() {
    board::BoardHardware<float> made = emulatedHardware;
    made.boot = 1;
    return made;
  }

  CmsdkUart uart_;
  SysTick timer_;
  Board board_{hardware()};
  EmulatedBench bench_{emulatedRig, 1};
  std::array<std::uint8_t, 1024> sent_{};
  std::uint16_t sequence_ = 0;
  std::uint8_t leg_ = 0;
  Cost takingFriction_;
  wire::FrameDecoder decoder_;
  std::uint32_t refused_ = 0;
  bool moved_ = false;
};

}  // namespace

}  // namespace breakaway

namespace {

breakaway::wire::StartSpeed slowSpeed() {
  breakaway::wire::StartSpeed start;
  start.plan.target_rad_per_s = 2.0f;
  start.plan.wobble = 0.015f;
  start.plan.settle_s = 0.01f;
  start.plan.run_s = 100.0f;
  return start;
}

breakaway::wire::StartHoming slowHoming() {
  breakaway::wire::StartHoming start;
  start.plan = {2.0f, 0.8f, 0.25f, 0.02f, 1.5f, 60.0f, 3.0f, 3};
  return start;
}

/// A ramp that nothing ends, but for the windings' clamp.
breakaway::wire::StartBreakaway ramp() {
  breakaway::wire::StartBreakaway start;
  start.plan.ways = breakaway::wire::StartBreakaway::growing | breakaway::wire::StartBreakaway::learning;
  start.plan.restSpeed_rad_per_s = 1e3f;
  start.plan.mostDwell_s = 1.0f;
  start.plan.resistance_ohm = 1.2f;
  start.plan.deadZone_V = 0.24f;
  start.plan.rampTop_A = 100.0f;
  start.plan.motionCounts = 60'000;
  return start;
}

}  // namespace

extern "C" void runImage() {
  using Mode = breakaway::wire::MotorCommand::Mode;
  using breakaway::wire::Type;
  static breakaway::TickCost cost;
  cost.measureTimer();
  cost.measure("off", Mode::off, 0.0f);
  cost.measure("voltage", Mode::voltage, 1.0f);
  cost.measure("current", Mode::current, 0.3f);
  cost.measure("velocity", Mode::velocity, 20.0f);
  cost.measure("slow", Mode::velocity, 2.0f);
  cost.measure("position", Mode::position, 3.0f);
  cost.measure("homing", Type::startHoming, slowHoming());
  cost.measure("speed-leg", Type::startSpeed, slowSpeed());
  cost.measure("ramp", Type::startBreakaway, ramp());
  cost.measureAsked();
  cost.tellRefused();
  breakaway::leaveEmulator();
}
