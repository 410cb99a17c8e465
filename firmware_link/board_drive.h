// A board that speaks the wire, as a drive.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/result.h"
#include "experiment/drive.h"
#include "firmware_link/byte_stream.h"
#include "firmware_link/wire/telemetry.h"

namespace breakaway {

struct BoardDriveOptions {
  /// What errors call it ("board tcp:127.0.0.1:7000").
  std::string place = "board";
  /// Board time that is granted at once while a procedure runs from here: how late it may react.
  double slice_s = 0.001;
  /// Where the pace is real: without a byte for that long the link counts as gone.
  double silence_s = 0.5;
  /// What telemetry carries, at least what samples are made of: a bit per wire::Channel.
  std::uint16_t channels = wire::usualChannels;
};

/// Asks whether a board that speaks the wire is there, every 0.15 s for at most `most_s`. Errors: the stream's.
Result<bool> speaksWire(ByteStream& stream, double most_s);

/// Says hello, reads the dictionary, stops the motor and turns telemetry on. Where the board's pace is real, advance()
/// waits and sends the heartbeat: whoever no longer calls it lets the lease run out. Where it is granted, the board's
/// clock runs in advance() alone. Procedures run on this side, a slice of samples late. Errors: one line of what did
/// not answer as it should, and what to look for.
Result<std::unique_ptr<Drive>> openBoardDrive(std::unique_ptr<ByteStream> stream, const BoardDriveOptions& options);

}  // namespace breakaway
