#include <algorithm>
#include <cmath>
#include <memory>

#include "firmware_link/board/reference_board.h"
#include "fuzz/fuzzed.h"

using namespace breakaway;
using namespace breakaway::test;

static std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

static board::BoardHardware<float> smallHardware() {
  board::BoardHardware<float> hardware;
  hardware.loopRate_Hz = 5000.0f;
  hardware.countsPerRev = 4096;
  hardware.supply_V = 24.0f;
  hardware.sensorRange_A = 10.0f;
  hardware.pwmSteps = 4800;
  hardware.servo = {2e-4f, 1.5e-3f, {1.0f, 1e-3f, 0.07f, 300.0f}, 400.0f};
  hardware.watch.tick_s = 2e-4f;
  hardware.watch.count_rad = 1.5e-3f;
  hardware.watch.trip_A = 9.0f;
  hardware.watch.supply_V = 24.0f;
  hardware.watch.mostAcceleration_rad_per_s2 = 3e4f;
  hardware.start.current_limit_A = 4.0f;
  hardware.start.torqueConstant_Nm_per_A = 0.07f;
  hardware.start.inertia_kg_m2 = 6e-5f;
  hardware.mostCurrent_A = 8.0f;
  hardware.mostVelocity_rad_per_s = 300.0f;
  return hardware;
}

/// Frames of any type and body to the board, ticks in between: first byte the type, second the length of the body.
static const Fuzzed asked("wire_board", [](std::string_view bytes) {
  const auto portable = std::make_unique<board::ReferenceBoard<float>>(smallHardware());
  const auto all = bytesOf(bytes);
  std::uint16_t sequence = 0;
  std::uint8_t frame[wire::mostFrame], sent[1024];
  for (std::size_t at = 0; at + 2 <= all.size();) {
    const std::size_t length = std::min<std::size_t>(all[at + 1], all.size() - at - 2);
    const std::size_t size = wire::FrameEncoder::encode({all[at], ++sequence, all.subspan(at + 2, length)}, frame);
    portable->receive(std::span(frame).first(size));
    at += 2 + length;
    for (int k = 0; k < 3; ++k) {
      const auto drive = portable->tick({k, false, 0.1f, 24.0f, 20.0f});
      require(std::abs(drive.duty) <= 1.0f, "the duty stays within the supply");
    }
    while (portable->transmit(sent) > 0) continue;
  }
});
