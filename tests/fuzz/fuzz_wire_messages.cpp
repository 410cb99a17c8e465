#include <algorithm>

#include "firmware_link/sample_decoder.h"
#include "firmware_link/wire/leg_messages.h"
#include "firmware_link/wire/messages.h"
#include "fuzz/fuzzed.h"

using namespace breakaway;
using namespace breakaway::test;

static std::span<const std::uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

template <typename Message>
static void readAndWrite(std::span<const std::uint8_t> body) {
  Message message{};
  if (!wire::readMessage(body, message)) return;
  std::uint8_t room[wire::mostBody];
  wire::Writer out(room);
  out(message);
  require(out.ok() && std::equal(out.written().begin(), out.written().end(), body.begin()),
          "what was read writes the same bytes again");
}

/// Any body as every message, and as telemetry.
static const Fuzzed messages("wire_messages", [](std::string_view bytes) {
  const auto body = bytesOf(bytes);
  readAndWrite<wire::Hello>(body);
  readAndWrite<wire::SerialNumber>(body);
  readAndWrite<wire::DictionaryPage>(body);
  readAndWrite<wire::ParameterList>(body);
  readAndWrite<wire::MotorCommand>(body);
  readAndWrite<wire::Alive>(body);
  readAndWrite<wire::Fault>(body);
  readAndWrite<wire::FrictionChunk>(body);
  readAndWrite<wire::FrictionUse>(body);
  readAndWrite<wire::StaticFrictionUse>(body);
  readAndWrite<wire::BridgeCurve>(body);
  readAndWrite<wire::CapturePage>(body);
  readAndWrite<wire::StartHoming>(body);
  readAndWrite<wire::StartBreakaway>(body);
  readAndWrite<wire::StartSpeed>(body);
  SampleDecoder::Board board;
  board.loopRate_Hz = 5000.0;
  board.countsPerRev = 4096.0;
  SampleDecoder decoder(board);
  std::vector<Sample> samples;
  decoder.take(body, samples);
  const std::size_t first = samples.size();
  decoder.take(body, samples);
  require(samples.size() == first, "what came twice is taken once");
});
