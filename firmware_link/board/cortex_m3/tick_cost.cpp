// Counts what the firmware's work costs on the chip: run in an emulator that gives each instruction the same time.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "emulated_rig_data.h"
#include "firmware_link/board/cortex_m3/cmsdk_uart.h"
#include "firmware_link/board/cortex_m3/emulated_bench.h"
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

  /// Everything on, `mode` with friction from a map of 180 bins, telemetry of all channels and a capture in every tick.
  void measure(const char* name, wire::MotorCommand::Mode mode, float target) {
    heartbeat();
    wire::MotorCommand command;
    command.mode = mode;
    command.latch = latch();
    command.target = target;
    command.flags = wire::MotorCommand::fresh;
    ask(wire::Type::command, command);
    wire::Capture capture;
    capture.schema = wire::allChannels;
    capture.samples = 0xffff;
    ask(wire::Type::startCapture, capture);
    run(500, nullptr);
    Cost tick, send;
    run(2500, &tick, &send);
    report(name, tick);
    if (mode == wire::MotorCommand::Mode::velocity) report("sending", send);
  }

  void measureAsked() {
    Cost beat;
    for (int k = 0; k < 50; ++k) {
      const std::uint32_t from = timer_.now();
      heartbeat();
      beat.add(SysTick::between(from, timer_.now()));
    }
    report("heartbeat", beat);
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
  void ask(wire::Type type, const Message& message) {
    std::array<std::uint8_t, wire::mostBody> body;
    wire::Writer out(body);
    out(message);
    std::array<std::uint8_t, wire::mostFrame> frame;
    const std::size_t length =
        wire::FrameEncoder::encode({static_cast<std::uint8_t>(type), ++sequence_, out.written()}, frame);
    board_.receive(std::span(frame).first(length));
  }

  void tellAll() {
    wire::ParameterList list;
    list.count = 2;
    list.value[0] = {static_cast<std::uint16_t>(board::Parameter::telemetryEvery), 1};
    list.value[1] = {static_cast<std::uint16_t>(board::Parameter::telemetryChannels), wire::allChannels};
    ask(wire::Type::writeParameters, list);
  }

  void upload() {
    constexpr std::uint16_t bins = 180;
    wire::Crc32c sum;
    for (std::uint8_t curve = 0; curve < 4; ++curve) {
      const float value = curve < 2 ? 0.017f : 2e-5f;
      for (std::uint16_t first = 0; first < bins; first = static_cast<std::uint16_t>(first + 90)) {
        wire::FrictionChunk chunk;
        chunk.curve = static_cast<wire::FrictionCurve>(curve);
        chunk.first = first;
        chunk.count = 90;
        for (int k = 0; k < 90; ++k) {
          chunk.value[k] = value * (1.0f + 0.001f * static_cast<float>(first + k));
          std::array<std::uint8_t, 4> bytes;
          wire::Writer out(bytes);
          out(chunk.value[k]);
          sum.add(out.written());
        }
        ask(wire::Type::writeFriction, chunk);
      }
    }
    wire::FrictionUse use;
    use.bins = bins;
    use.checksum = sum.value();
    use.blend_rad_per_s = 0.5f;
    use.cutoff_rad_per_s = 500.0f;
    ask(wire::Type::useFriction, use);
  }

  void heartbeat() {
    wire::Heartbeat beat;
    ask(wire::Type::heartbeat, beat);
    drain();
  }

  std::uint16_t latch() { return hardware().boot; }

  void drain() {
    while (board_.transmit(sent_) > 0) {
    }
  }

  void run(int ticks, Cost* tick, Cost* send = nullptr) {
    for (int k = 0; k < ticks; ++k) {
      const board::Readings<float> readings = bench_.readings();
      const std::uint32_t from = timer_.now();
      const board::Drive<float> drive = board_.tick(readings);
      const std::uint32_t middle = timer_.now();
      drain();
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
  bool moved_ = false;
};

}  // namespace

}  // namespace breakaway

/// Semihosting's SYS_EXIT; Arm, "Semihosting for AArch32 and AArch64", 2020.
static void leaveEmulator() {
  register int call asm("r0") = 0x18;
  register int reason asm("r1") = 0x20026;
  asm volatile("bkpt 0xab" : : "r"(call), "r"(reason) : "memory");
}

extern "C" void runImage() {
  using Mode = breakaway::wire::MotorCommand::Mode;
  static breakaway::TickCost cost;
  cost.measureTimer();
  cost.measure("off", Mode::off, 0.0f);
  cost.measure("voltage", Mode::voltage, 1.0f);
  cost.measure("current", Mode::current, 0.3f);
  cost.measure("velocity", Mode::velocity, 20.0f);
  cost.measure("position", Mode::position, 3.0f);
  cost.measureAsked();
  leaveEmulator();
}
