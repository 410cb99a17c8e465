// The portable board with a simulated rig beneath it: bytes in, bytes out, in the pace that is wanted.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "firmware_link/board/reference_board.h"
#include "firmware_link/simulated_rig.h"
#include "plant/rig.h"

namespace breakaway {

/// The firmware in single precision, as the board's processor runs it.
class SimulatedFirmware {
 public:
  static constexpr std::size_t outboxBytes = 16384, burstBytes = 1u << 20;
  using Board = board::ReferenceBoard<float, outboxBytes, burstBytes>;

  /// `serialNumber`: what the board tells; empty: none.
  SimulatedFirmware(const Rig& rig, unsigned seed, board::Pace pace, std::uint16_t boot, std::string serialNumber = {});

  void receive(std::span<const std::uint8_t> bytes) {
    if (!linkLost_) board_->receive(bytes);
  }
  /// Runs at most `ticks`, fewer where the pace is granted; what the board wants to send is appended to `out` tick by
  /// tick. Returns how many ticks it ran.
  std::size_t run(std::size_t ticks, std::vector<std::uint8_t>& out);
  /// Appends what the board wants to send.
  void transmit(std::vector<std::uint8_t>& out);

  double tick_s() const { return 1.0 / rate_Hz_; }
  const Board& board() const { return *board_; }
  /// What the last tick made of the bridge, and the current that its sensor saw.
  bool enabled() const { return drive_.enabled; }
  double duty() const { return static_cast<double>(drive_.duty); }
  double current_A() const { return current_A_; }
  /// One tick, what it has to send stays in the board's outbox; where that is full, samples are dropped and counted.
  void tickWithoutSending();

 private:
  void tick();

  double rate_Hz_;
  std::string device_, serialNumber_;
  SimulatedRig rig_;
  std::unique_ptr<Board> board_;
  board::Drive<float> drive_;
  double current_A_ = 0.0;
  bool linkLost_ = false;
};

}  // namespace breakaway
