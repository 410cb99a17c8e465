// A VESC as a drive: asked for its values as often as it answers, commanded in current, duty, speed and position.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "experiment/drive.h"
#include "firmware_link/byte_stream.h"

namespace breakaway {

/// What a VESC doesn't tell of the motor and of what is coupled to it.
struct VescOptions {
  std::optional<double> polePairs;     ///< it speaks of electrical turns only
  std::optional<double> countsPerRev;  ///< of the encoder; without it the angle is the commutation's, 6 steps per pair
  double currentLimit_A = 5.0;         ///< that this side asks for at most, until configure() sets another
  double answerWait_s = 0.3;           ///< for the first answer
};

/// Asks who is there. A VESC takes `stream` over and becomes a drive, its motor released; when nothing answers as one,
/// the stream stays and the drive is null. Errors: one that answers but can't be used, and why; a stream that is gone.
///
/// The drive's time is this machine's, half way between question and answer. Currents are means since the last reading,
/// so nobody else may ask for values meanwhile. The motor is kept alive only while advance() is called: when it isn't,
/// the VESC releases the motor after its own time-out (1 s unless its maker's tool set another). A fault, a current a
/// quarter above the limit, or half a second without an answer ends what runs.
Result<std::unique_ptr<Drive>> openVesc(std::unique_ptr<ByteStream>& stream, const VescOptions& options);

}  // namespace breakaway
