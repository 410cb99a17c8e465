// Samples gathered into a batch as the wire carries it. Freestanding, no heap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware_link/wire/telemetry.h"

namespace breakaway::board {

template <typename Scalar>
class SampleBatch {
 public:
  void begin(std::uint16_t schema, std::uint8_t every, std::uint32_t period_ns) {
    header_ = {};
    header_.schema = schema;
    header_.every = every;
    header_.period_ns = period_ns;
  }

  void add(const wire::Measured<Scalar>& sample, std::uint32_t tick, std::uint32_t time_us,
           const Scalar (&perUnit)[wire::channelCount]) {
    if (header_.samples == 0) {
      header_.tick = tick;
      header_.time_us = time_us;
    }
    wire::Writer out{std::span(body_).subspan(end())};
    wire::writeSample(sample, header_.schema, perUnit, out);
    ++header_.samples;
  }

  std::uint8_t samples() const { return header_.samples; }
  bool full() const { return header_.samples >= wire::mostSamples(header_.schema); }
  std::uint32_t firstTick() const { return header_.tick; }

  /// The body of a telemetry frame; empties the batch.
  std::span<const std::uint8_t> finish(std::uint32_t dropped) {
    header_.dropped = dropped;
    wire::Writer out{std::span(body_).first(wire::BatchHeader::size)};
    out(header_);
    const std::size_t used = end();
    header_.samples = 0;
    return std::span(body_).first(used);
  }

 private:
  std::size_t end() const { return wire::BatchHeader::size + header_.samples * wire::sampleSize(header_.schema); }

  wire::BatchHeader header_;
  std::uint8_t body_[wire::mostBody] = {};
};

}  // namespace breakaway::board
