// Samples gathered into a telemetry frame, packed as they come. Freestanding, no heap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware_link/wire/frame.h"
#include "firmware_link/wire/messages.h"
#include "firmware_link/wire/telemetry.h"

namespace breakaway::board {

/// What a batch begins with is known at its first sample, how many will follow too. So each is packed, summed and
/// stuffed in its own tick, and no tick has to do it for all of them.
class SampleBatch {
 public:
  /// For the batches from now on; empties the present one.
  void begin(std::uint16_t schema, std::uint8_t every, std::uint32_t period_ns) {
    header_ = {};
    header_.schema = schema;
    header_.every = every;
    header_.period_ns = period_ns;
    size_ = wire::sampleSize(schema);
    most_ = static_cast<std::uint8_t>(wire::mostSamples(schema));
    taken_ = 0;
  }

  /// What a batch's first sample is told.
  struct Start {
    std::uint32_t tick, time_us, dropped;
    std::uint32_t samples;  ///< that are to follow before it has to go, with the first; at least 1
    std::uint16_t sequence;
  };
  void add(const wire::WireSample& sample, const Start& start) {
    if (taken_ == 0) {
      header_.samples = start.samples < most_ ? static_cast<std::uint8_t>(start.samples) : most_;
      header_.tick = start.tick;
      header_.time_us = start.time_us;
      header_.dropped = start.dropped;
      sequence_ = start.sequence;
      beginFrame();
    }
    std::uint8_t* to = body_ + wire::BatchHeader::size + taken_ * size_;
    wire::writeSample(sample, header_.schema, to);
    encoder_.add({to, size_});
    ++taken_;
  }

  std::uint16_t schema() const { return header_.schema; }
  std::uint8_t samples() const { return taken_; }
  bool full() const { return taken_ > 0 && taken_ >= header_.samples; }

  /// The frame, until the next sample; empties the batch. One that ends before its time is packed anew.
  std::span<const std::uint8_t> finish() {
    if (taken_ < header_.samples) {
      header_.samples = taken_;
      beginFrame();
      encoder_.add({body_ + wire::BatchHeader::size, taken_ * size_});
    }
    taken_ = 0;
    return {frame_, encoder_.end()};
  }

 private:
  void beginFrame() {
    wire::Writer out{std::span(body_).first(wire::BatchHeader::size)};
    out(header_);
    encoder_ = wire::FrameEncoder(frame_, static_cast<std::uint8_t>(wire::Type::telemetry), sequence_);
    encoder_.add(out.written());
  }

  wire::BatchHeader header_;
  wire::FrameEncoder encoder_;
  std::size_t size_ = 0;
  std::uint8_t most_ = 0, taken_ = 0;
  std::uint16_t sequence_ = 0;
  std::uint8_t body_[wire::mostBody] = {}, frame_[wire::mostFrame] = {};
};

}  // namespace breakaway::board
