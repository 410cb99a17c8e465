#include "firmware_link/board_link.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>

namespace breakaway {

namespace {

using wire::Code;
using wire::Type;

constexpr std::pair<Type, const char*> requests[] = {{Type::hello, "hello"},
                                                     {Type::dictionary, "dictionary"},
                                                     {Type::serialNumber, "serial number"},
                                                     {Type::readParameters, "read parameters"},
                                                     {Type::writeParameters, "write parameters"},
                                                     {Type::command, "command"},
                                                     {Type::heartbeat, "heartbeat"},
                                                     {Type::stop, "stop"},
                                                     {Type::writeFriction, "friction table"},
                                                     {Type::readFriction, "friction table"},
                                                     {Type::useFriction, "friction table"},
                                                     {Type::useStatic, "friction table"},
                                                     {Type::frictionUsed, "friction table"},
                                                     {Type::staticUsed, "friction table"},
                                                     {Type::writeBridge, "bridge's curve"},
                                                     {Type::readBridge, "bridge's curve"},
                                                     {Type::startCapture, "burst"},
                                                     {Type::readCapture, "burst"}};

constexpr std::pair<Code, const char*> refusals[] = {
    {Code::unknown, "does not know the request"},
    {Code::malformed, "could not read the request"},
    {Code::notAValue, "refused a value"},
    {Code::latched, "has stopped the motor meanwhile and waits for a new start"},
    {Code::notPossible, "cannot do that"},
    {Code::noSuch, "has no such thing"},
    {Code::outdated, "has had a newer request before this one and refused it"}};

template <typename Key, std::size_t count>
const char* wordsOf(const std::pair<Key, const char*> (&words)[count], Key key, const char* otherwise) {
  const auto* found =
      std::find_if(std::begin(words), std::end(words), [&](const auto& one) { return one.first == key; });
  return found != std::end(words) ? found->second : otherwise;
}

const char* nameOf(Type type) {
  return wordsOf(requests, type, "request");
}

}  // namespace

Error BoardLink::refusal(wire::Type type, std::uint8_t code) const {
  return {place_,
          std::string(wordsOf(refusals, static_cast<Code>(code), "refused the request")) + " (" + nameOf(type) + ")"};
}

std::uint16_t BoardLink::prepare(wire::Type type, std::span<const std::uint8_t> body) {
  std::array<std::uint8_t, wire::mostFrame> frame;
  const std::size_t size = wire::FrameEncoder::encode({static_cast<std::uint8_t>(type), ++sequence_, body}, frame);
  going_.insert(going_.end(), frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size));
  return sequence_;
}

Result<void> BoardLink::flush() {
  if (going_.empty()) return {};
  auto written = stream_->write(going_);
  going_.clear();
  return written;
}

Result<std::uint16_t> BoardLink::post(wire::Type type, std::span<const std::uint8_t> body) {
  const std::uint16_t sequence = prepare(type, body);
  if (auto sent = flush(); !sent) return sent.error();
  return sequence;
}

Result<void> BoardLink::clear() {
  const std::uint8_t end[] = {0};
  return stream_->write(end);
}

Result<std::size_t> BoardLink::take(double wait_s) {
  came_.clear();
  if (auto read = stream_->read(came_, wait_s); !read) return read.error();
  std::size_t frames = 0;
  for (const std::uint8_t byte : came_) {
    if (!decoder_.take(byte)) continue;
    ++frames;
    heard_ = Clock::now();
    const wire::Frame frame = decoder_.frame();
    if (awaited_ != nullptr && frame.type == awaited_->type && frame.sequence == awaited_->sequence) {
      awaited_->body = Bytes(frame.body.begin(), frame.body.end());
    } else if (listener_) {
      listener_(frame);
    }
  }
  return frames;
}

Result<BoardLink::Bytes> BoardLink::ask(wire::Type type, std::span<const std::uint8_t> body, const Patience& patience) {
  Awaited awaited{static_cast<std::uint8_t>(static_cast<std::uint8_t>(type) | wire::answerBit), 0, {}};
  awaited_ = &awaited;
  const auto ended = [this](Result<Bytes> result) {
    awaited_ = nullptr;
    return result;
  };
  for (int tried = 0; tried < patience.tries; ++tried) {
    if (tried > 0) --sequence_;
    awaited.sequence = prepare(type, body);
    if (auto sent = flush(); !sent) return ended(sent.error());
    const auto until =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience.perTry_s));
    while (!awaited.body) {
      const double left_s = std::chrono::duration<double>(until - Clock::now()).count();
      if (left_s <= 0.0) break;
      if (auto took = take(left_s); !took) return ended(took.error());
    }
    if (!awaited.body) continue;
    if (awaited.body->empty()) return ended(Error{place_, message("gave an empty answer")});
    const std::uint8_t code = awaited.body->front();
    if (code != static_cast<std::uint8_t>(wire::Code::ok)) return ended(refusal(type, code));
    awaited.body->erase(awaited.body->begin());
    return ended(std::move(*awaited.body));
  }
  return ended(Error{place_, message("does not answer ({}, asked {} times in {:.1f} s)", nameOf(type), patience.tries,
                                     patience.tries * patience.perTry_s)});
}

}  // namespace breakaway
