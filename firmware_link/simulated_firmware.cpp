#include "firmware_link/simulated_firmware.h"

#include <array>
#include <utility>

namespace breakaway {

namespace {

constexpr const char* firmwareName = "reference 0.1.0";

board::BoardHardware<float> hardware(const Rig& rig, const char* device, const char* serialNumber, board::Pace pace,
                                     std::uint16_t boot) {
  auto made = hardwareOf<float>(rig);
  made.device = device;
  made.serialNumber = serialNumber;
  made.firmware = firmwareName;
  made.pace = pace;
  made.boot = boot;
  return made;
}

}  // namespace

SimulatedFirmware::SimulatedFirmware(const Rig& rig, unsigned seed, board::Pace pace, std::uint16_t boot,
                                     std::string serialNumber)
    : rate_Hz_(rig.loopRate_Hz),
      device_("reference board, simulated rig " + rig.name),
      serialNumber_(std::move(serialNumber)),
      rig_(rig, seed),
      board_(std::make_unique<Board>(hardware(rig, device_.c_str(), serialNumber_.c_str(), pace, boot))) {
}

void SimulatedFirmware::tick() {
  const SimulatedRig::Reading seen = rig_.read();
  linkLost_ = seen.linkLost;
  board::Readings<float> readings;
  readings.count = static_cast<std::int32_t>(static_cast<std::uint32_t>(seen.count));
  readings.index = seen.index;
  readings.current_A = static_cast<float>(seen.current_A);
  readings.supply_V = static_cast<float>(seen.supply_V);
  current_A_ = seen.current_A;
  drive_ = board_->tick(readings);
  rig_.drive(drive_.enabled, static_cast<double>(drive_.duty));
}

void SimulatedFirmware::tickWithoutSending() {
  if (board_->mayTick()) tick();
}

std::size_t SimulatedFirmware::run(std::size_t ticks, std::vector<std::uint8_t>& out) {
  std::size_t ran = 0;
  while (ran < ticks && board_->mayTick()) {
    tick();
    transmit(out);
    ++ran;
  }
  return ran;
}

void SimulatedFirmware::transmit(std::vector<std::uint8_t>& out) {
  std::array<std::uint8_t, 512> part;
  while (const std::size_t size = board_->transmit(part)) {
    if (!linkLost_) out.insert(out.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(size));
  }
}

}  // namespace breakaway
