// Keeps a simulated board running at the far end of a line.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "firmware_link/far_end.h"
#include "firmware_link/simulated_firmware.h"

namespace breakaway {

class BoardServer {
 public:
  /// Both outlive it.
  BoardServer(SimulatedFirmware& firmware, FarEnd& line, board::Pace pace)
      : firmware_(firmware), line_(line), pace_(pace) {}

  /// Does what is due and waits for more, a few milliseconds at most where the pace is real. A signal ends the wait.
  void turn();
  /// Board time that was given up because this machine could not keep up, in real pace.
  double late_s() const { return late_s_; }

 private:
  using Clock = std::chrono::steady_clock;
  void listen(double wait_s);
  void runGranted();
  void runReal();
  void gather();
  bool send(double wait_s);

  SimulatedFirmware& firmware_;
  FarEnd& line_;
  board::Pace pace_;
  std::vector<std::uint8_t> came_, going_;
  std::size_t sent_ = 0;  ///< of `going_`
  Clock::time_point due_ = Clock::now(), taken_ = due_;
  double late_s_ = 0.0;
};

}  // namespace breakaway
