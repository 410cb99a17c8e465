// A burst: every tick kept on the board at its full rate, and read afterwards.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "firmware_link/board_dictionary.h"
#include "firmware_link/board_link.h"
#include "firmware_link/wire/messages.h"
#include "recording/sample.h"

namespace breakaway {

struct BurstRequest {
  std::uint16_t samples = 200;  ///< the board takes fewer where it has no room
  int every = 1;                ///< ticks from one sample to the next, 1 to 255
  /// Starts the burst and holds while it runs; the motor is stopped afterwards. Off: the burst starts at once and the
  /// motor stays off. Position: rad from where the rotor stands in the encoder's count.
  wire::MotorCommand::Mode mode = wire::MotorCommand::Mode::off;
  double target = 0.0;  ///< V, A, rad/s or rad
};

struct CapturedBurst {
  std::vector<Sample> samples;
  std::string fault;  ///< why the board stopped the motor meanwhile, in words; empty: it didn't
};

/// Captures on a board that has been asked nothing else meanwhile. Errors: a board without bursts, a command that it
/// refuses, a burst that doesn't come to its end, the link's. The motor is off before and afterwards.
Result<CapturedBurst> captureBurst(BoardLink& link, const BoardDictionary& board, const BurstRequest& request);

}  // namespace breakaway
