// From telemetry batches to samples in order, with what was lost between them counted.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firmware_link/wire/telemetry.h"
#include "recording/sample.h"

namespace breakaway {

class SampleDecoder {
 public:
  struct Board {
    double loopRate_Hz = 0.0;
    double countsPerRev = 0.0;
    double supply_V = 0.0;                  ///< where the telemetry carries none
    double scale[wire::channelCount] = {};  ///< of the channels of format int16
  };

  explicit SampleDecoder(const Board& board) : board_(board) {}

  /// How far a leg is of odd or even number, from a decoded sample's legPhase: that has the flags' upper bits still.
  static std::uint8_t phaseOf(std::uint8_t flags, bool odd) {
    using Flag = wire::SampleFlag;
    return ((flags & Flag::odd) != 0) == odd ? static_cast<std::uint8_t>(flags >> Flag::phaseShift & Flag::phaseBits)
                                             : 0;
  }

  /// Appends the samples of a telemetry frame's body that are newer than all before them. Returns how many are missing
  /// between those and these; a body that isn't whole is skipped and shows as a gap later.
  std::size_t take(std::span<const std::uint8_t> body, std::vector<Sample>& samples);
  /// The board has run up to `tick` and has sent what it had: what is missing up to there is lost. Returns how many.
  std::size_t passTo(std::uint32_t tick);

  bool begun() const { return begun_; }
  /// The tick that is expected next, since the board woke up.
  std::uint64_t next() const { return next_; }
  /// Begins with a board that stands at `tick`.
  void begin(std::uint32_t tick);
  double count_rad() const;
  /// Is the samples' current as the sensor reads it, its zero still in it?
  bool unzeroed() const { return unzeroed_; }
  /// Did the newest sample say that something has stopped the motor?
  bool latched() const { return latched_; }

 private:
  Sample sampleOf(const wire::Measured<double>& measured, std::uint64_t tick);

  Board board_;
  wire::Measured<double> newest_;
  std::uint64_t next_ = 0, every_ = 1;
  std::int64_t count_ = 0;
  bool begun_ = false, counted_ = false, latched_ = false, unzeroed_ = false;
};

}  // namespace breakaway
