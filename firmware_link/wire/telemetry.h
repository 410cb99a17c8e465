// Samples on the wire: channels, how a sample is laid out, batches. Freestanding.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware_link/wire/bytes.h"
#include "firmware_link/wire/frame.h"
#include "firmware_link/wire/nearest.h"

namespace breakaway::wire {

/// How a number is written. An int16 is value/scale, rounded and held within ±32767; −32768 says that there is none.
enum class Format : std::uint8_t { uint8 = 1, int16 = 2, int32 = 3, uint32 = 4, float32 = 5 };

constexpr std::size_t sizeOf(Format format) {
  switch (format) {
    case Format::uint8:
      return 1;
    case Format::int16:
      return 2;
    case Format::int32:
    case Format::uint32:
    case Format::float32:
      return 4;
  }
  return 0;
}

/// What a sample can carry. Channel k stands in a sample when bit k of the batch's schema is set, in this order.
enum class Channel : std::uint8_t {
  angle,              ///< encoder counts since the board woke up, wrapping
  flags,              ///< SampleFlag
  current,            ///< A, the sensor's zero taken off
  duty,               ///< of the bridge as the timer makes it; × supply it is the mean voltage
  supply,             ///< V
  velocity,           ///< rad/s, the board's estimate
  currentReference,   ///< A, after the limit
  velocityReference,  ///< rad/s
  angleAhead,         ///< rad, the angle's reference less the angle
  disturbance,        ///< Nm, the disturbance observer's estimate
  sensorCurrent,      ///< A, as the sensor reads
  temperature         ///< °C
};
inline constexpr std::size_t channelCount = 12;
inline constexpr std::uint16_t allChannels = (1u << channelCount) - 1;
/// What a Drive's samples are made of. The current comes as the sensor reads it, so that whoever zeroes from the other
/// end of a line knows to the sample what it was zeroed with.
inline constexpr std::uint16_t usualChannels = allChannels & ~(1u << static_cast<unsigned>(Channel::current)) &
                                               ~(1u << static_cast<unsigned>(Channel::temperature));

/// The upper five bits tell how far a leg is: its phase, and whether its number is odd. 0: none was started since the
/// last command, stop or fault.
struct SampleFlag {
  static constexpr std::uint8_t enabled = 1, index = 2, latched = 4, odd = 128;
  static constexpr unsigned phaseShift = 3;
  static constexpr std::uint8_t phaseBits = 15;
};

struct ChannelForm {
  const char* name;
  Format format;
};
inline constexpr ChannelForm channelForms[channelCount] = {
    {"angle_counts", Format::int32},
    {"flags", Format::uint8},
    {"current_A", Format::int16},
    {"duty", Format::int16},
    {"supply_V", Format::int16},
    {"velocity_rad_per_s", Format::float32},
    {"current_reference_A", Format::int16},
    {"velocity_reference_rad_per_s", Format::float32},
    {"angle_ahead_rad", Format::float32},
    {"disturbance_Nm", Format::float32},
    {"sensor_current_A", Format::int16},
    {"temperature_degC", Format::int16},
};

constexpr bool carries(std::uint16_t schema, Channel channel) {
  return (schema >> static_cast<unsigned>(channel) & 1u) != 0;
}

/// Bytes of one sample.
constexpr std::size_t sampleSize(std::uint16_t schema) {
  std::size_t size = 0;
  for (std::size_t k = 0; k < channelCount; ++k) {
    if ((schema >> k & 1u) != 0) size += sizeOf(channelForms[k].format);
  }
  return size;
}

/// What stands before a batch's samples.
struct BatchHeader {
  std::uint16_t schema = 0;     ///< a bit for each channel
  std::uint8_t samples = 0;     ///< in this batch
  std::uint8_t every = 1;       ///< ticks from one sample to the next
  std::uint32_t tick = 0;       ///< of the first sample, counted since the board woke up, wrapping
  std::uint32_t time_us = 0;    ///< of the first sample, wrapping
  std::uint32_t period_ns = 0;  ///< from one sample to the next
  std::uint32_t dropped = 0;    ///< samples that the board had no room for, since it woke up

  static constexpr std::size_t size = 20;
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.schema), io(s.samples), io(s.every), io(s.tick), io(s.time_us), io(s.period_ns), io(s.dropped);
  }
};

constexpr std::size_t mostSamples(std::uint16_t schema) {
  const std::size_t size = sampleSize(schema), most = (mostBody - BatchHeader::size) / (size > 0 ? size : 1);
  return most < 255 ? most : 255;
}

/// One sample's numbers, by channel; angle and flags stand apart because a float can't hold them.
template <typename Scalar>
struct Measured {
  std::int32_t angle_counts = 0;
  std::uint8_t flags = 0;
  Scalar value[channelCount] = {};

  Scalar& operator[](Channel channel) { return value[static_cast<std::size_t>(channel)]; }
  Scalar operator[](Channel channel) const { return value[static_cast<std::size_t>(channel)]; }
};

inline constexpr std::int16_t missing16 = -32768;

template <typename Scalar>
std::int16_t scaled16(Scalar value, Scalar perUnit) {
  const Scalar steps = value * perUnit;
  const std::int32_t whole = nearest(steps);
  if (whole >= -32767 && whole <= 32767) return static_cast<std::int16_t>(whole);
  return steps != steps ? missing16 : whole < 0 ? std::int16_t(-32767) : std::int16_t(32767);
}

/// A sample's channels as they stand on the wire, each in the low bytes of its word.
struct WireSample {
  std::uint32_t word[channelCount] = {};
};

/// The channels of `schema`; `perUnit` is 1/scale of each channel of format int16.
template <typename Scalar>
void convertSample(const Measured<Scalar>& sample, std::uint16_t schema, const Scalar (&perUnit)[channelCount],
                   WireSample& out) {
  for (std::size_t k = 0; k < channelCount; ++k) {
    if ((schema >> k & 1u) == 0) continue;
    switch (channelForms[k].format) {
      case Format::uint8:
        out.word[k] = sample.flags;
        break;
      case Format::int32:
      case Format::uint32:
        out.word[k] = static_cast<std::uint32_t>(sample.angle_counts);
        break;
      case Format::int16:
        out.word[k] = static_cast<std::uint16_t>(scaled16(sample.value[k], perUnit[k]));
        break;
      case Format::float32:
        out.word[k] = std::bit_cast<std::uint32_t>(static_cast<float>(sample.value[k]));
        break;
    }
  }
}

/// The sample's sampleSize(schema) bytes.
inline void writeSample(const WireSample& sample, std::uint16_t schema, std::uint8_t* to) {
  for (std::size_t k = 0; k < channelCount; ++k) {
    if ((schema >> k & 1u) == 0) continue;
    const std::uint32_t word = sample.word[k];
    const std::size_t size = sizeOf(channelForms[k].format);
    *to++ = static_cast<std::uint8_t>(word);
    if (size > 1) *to++ = static_cast<std::uint8_t>(word >> 8);
    if (size < 4) continue;
    *to++ = static_cast<std::uint8_t>(word >> 16);
    *to++ = static_cast<std::uint8_t>(word >> 24);
  }
}

template <typename Scalar>
void writeSample(const Measured<Scalar>& sample, std::uint16_t schema, const Scalar (&perUnit)[channelCount],
                 Writer& out) {
  WireSample converted;
  convertSample(sample, schema, perUnit, converted);
  std::uint8_t bytes[4 * channelCount];
  writeSample(converted, schema, bytes);
  for (std::size_t k = 0; k < sampleSize(schema); ++k) out(bytes[k]);
}

/// The other way; `scale` of each channel of format int16. A channel that isn't carried keeps its value.
inline void readSample(Reader& in, std::uint16_t schema, const double (&scale)[channelCount],
                       Measured<double>& sample) {
  for (std::size_t k = 0; k < channelCount; ++k) {
    if ((schema >> k & 1u) == 0) continue;
    std::int16_t steps = 0;
    float value = 0;
    switch (channelForms[k].format) {
      case Format::uint8:
        in(sample.flags);
        break;
      case Format::int32:
      case Format::uint32:
        in(sample.angle_counts);
        break;
      case Format::int16:
        in(steps);
        sample.value[k] = steps == missing16 ? __builtin_nan("") : steps * scale[k];
        break;
      case Format::float32:
        in(value);
        sample.value[k] = static_cast<double>(value);
        break;
    }
  }
}

}  // namespace breakaway::wire
