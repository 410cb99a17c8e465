// How many telemetry frames a core encodes and decodes per second, beside what a line can carry.
#include <cstdio>
#include <vector>

#include "firmware_link/sample_decoder.h"
#include "firmware_link/wire/messages.h"
#include "support/processor_time.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

constexpr int frames = 100'000;
constexpr double line_Bd = 3e6, bitsPerByte = 10.0;  // 8N1

}  // namespace

int main() {
  float perUnit[wire::channelCount];
  for (float& one : perUnit) one = 1000.0f;
  constexpr std::size_t perFrame = wire::mostSamples(wire::usualChannels);
  std::vector<std::uint8_t> sent;
  sent.reserve(static_cast<std::size_t>(frames) * wire::mostFrame);
  const ProcessorTime encoding;
  for (std::uint32_t k = 0; k < frames; ++k) {
    std::uint8_t body[wire::mostBody], frame[wire::mostFrame];
    wire::Writer out(body);
    wire::BatchHeader header;
    header.schema = wire::usualChannels;
    header.samples = perFrame;
    header.tick = k * perFrame;
    out(header);
    for (std::uint32_t n = 0; n < perFrame; ++n) {
      wire::Measured<float> sample;
      sample.angle_counts = static_cast<std::int32_t>(k * perFrame + n);
      for (std::size_t c = 0; c < wire::channelCount; ++c)
        sample.value[c] = 1e-3f * static_cast<float>((k + n * c) % 9001);
      wire::writeSample(sample, wire::usualChannels, perUnit, out);
    }
    const std::size_t size = wire::FrameEncoder::encode(
        {static_cast<std::uint8_t>(wire::Type::telemetry), static_cast<std::uint16_t>(k), out.written()}, frame);
    sent.insert(sent.end(), frame, frame + size);
  }
  const double encoding_s = encoding.elapsed_s();
  SampleDecoder::Board board;
  board.loopRate_Hz = 1e4;
  board.countsPerRev = 14400.0;
  SampleDecoder decoder(board);
  wire::FrameDecoder line;
  std::vector<Sample> samples;
  std::size_t lost = 0, decoded = 0;
  const ProcessorTime decoding;
  for (const std::uint8_t byte : sent) {
    if (!line.take(byte)) continue;
    lost += decoder.take(line.frame().body, samples);
    decoded += samples.size();
    samples.clear();
  }
  const double decoding_s = decoding.elapsed_s();
  const double perFrame_B = static_cast<double>(sent.size()) / frames;
  const double carried = line_Bd / bitsPerByte / perFrame_B;
  std::printf("frames of %zu samples of %zu channels, %.0f bytes on the wire each\n", perFrame,
              static_cast<std::size_t>(wire::channelCount - 2), perFrame_B);
  std::printf("encoded %9.0f frames/s (%.0f MB/s)\n", frames / encoding_s,
              1e-6 * static_cast<double>(sent.size()) / encoding_s);
  std::printf("decoded %9.0f frames/s (%.0f MB/s), %zu samples, %zu lost\n", frames / decoding_s,
              1e-6 * static_cast<double>(sent.size()) / decoding_s, decoded, lost);
  std::printf("a line of 3 Mbaud carries %.0f frames/s, %.0f samples/s: %.1f %% of a core to decode\n", carried,
              carried * perFrame, 100.0 * carried * decoding_s / frames);
  return decoded == frames * perFrame && lost == 0 ? 0 : 1;
}
