#include "firmware_link/sample_decoder.h"

#include "base/numbers.h"

namespace breakaway {

void SampleDecoder::begin(std::uint32_t tick) {
  next_ = tick;
  begun_ = true;
}

std::size_t SampleDecoder::passTo(std::uint32_t tick) {
  const auto ahead = static_cast<std::int32_t>(tick - static_cast<std::uint32_t>(next_));
  if (ahead <= 0) return 0;
  next_ += static_cast<std::uint64_t>(ahead);
  return static_cast<std::size_t>(ahead) / every_;
}

std::size_t SampleDecoder::take(std::span<const std::uint8_t> body, std::vector<Sample>& samples) {
  wire::Reader in(body);
  wire::BatchHeader header;
  in(header);
  const std::size_t size = wire::sampleSize(header.schema);
  if (!in.ok() || header.every == 0 || in.rest().size() < size * header.samples) return 0;
  if (!begun_) begin(header.tick);
  every_ = header.every;
  unzeroed_ = wire::carries(header.schema, wire::Channel::sensorCurrent);
  const auto ahead = static_cast<std::int32_t>(header.tick - static_cast<std::uint32_t>(next_));
  std::size_t lost = 0;
  if (ahead > 0) {
    // Where only some ticks are sampled, the first one after a start may be a few ticks on.
    lost = static_cast<std::size_t>(ahead) / every_;
    next_ += static_cast<std::uint64_t>(ahead);
  }
  for (std::uint32_t k = 0; k < header.samples; ++k) {
    wire::readSample(in, header.schema, board_.scale, newest_);
    const std::uint32_t tick = header.tick + k * header.every;
    if (static_cast<std::int32_t>(tick - static_cast<std::uint32_t>(next_)) < 0) continue;
    samples.push_back(sampleOf(newest_, next_));
    next_ += every_;
  }
  latched_ = (newest_.flags & wire::SampleFlag::latched) != 0;
  return lost;
}

double SampleDecoder::count_rad() const {
  return turn_rad / board_.countsPerRev;
}

Sample SampleDecoder::sampleOf(const wire::Measured<double>& measured, std::uint64_t tick) {
  using wire::Channel;
  const auto moved =
      static_cast<std::int32_t>(static_cast<std::uint32_t>(measured.angle_counts) - static_cast<std::uint32_t>(count_));
  count_ = counted_ ? count_ + moved : measured.angle_counts;
  counted_ = true;
  Sample sample;
  sample.time_s = static_cast<double>(tick) / board_.loopRate_Hz;
  sample.angle_rad = static_cast<double>(count_) * count_rad();
  sample.velocity_rad_per_s = measured[Channel::velocity];
  sample.current_A = measured[unzeroed_ ? Channel::sensorCurrent : Channel::current];
  sample.supply_V = measured[Channel::supply] > 0.0 ? measured[Channel::supply] : board_.supply_V;
  sample.voltage_V = measured[Channel::duty] * sample.supply_V;
  sample.current_reference_A = measured[Channel::currentReference];
  sample.velocity_reference_rad_per_s = measured[Channel::velocityReference];
  sample.angle_reference_rad = sample.angle_rad + measured[Channel::angleAhead];
  sample.disturbance_estimate_Nm = measured[Channel::disturbance];
  sample.index = (measured.flags & wire::SampleFlag::index) != 0;
  sample.enabled = (measured.flags & wire::SampleFlag::enabled) != 0;
  sample.legPhase = static_cast<std::uint8_t>(
      measured.flags & ~(wire::SampleFlag::enabled | wire::SampleFlag::index | wire::SampleFlag::latched));
  return sample;
}

}  // namespace breakaway
