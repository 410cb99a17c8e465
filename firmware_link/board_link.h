// Questions and answers with a board over a byte stream, and what the board says unasked.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "firmware_link/byte_stream.h"
#include "firmware_link/wire/messages.h"

namespace breakaway {

/// One host's end of the wire. Used by one thread.
class BoardLink {
 public:
  using Clock = std::chrono::steady_clock;
  using Bytes = std::vector<std::uint8_t>;
  /// Gets every frame that answers no ask().
  using Listener = std::function<void(const wire::Frame&)>;
  struct Patience {
    double perTry_s = 0.2;
    int tries = 10;  ///< a board that is an emulator on a busy machine takes its time
  };

  /// `place` is what errors call the board ("board tcp:127.0.0.1:7000").
  BoardLink(std::unique_ptr<ByteStream> stream, std::string place)
      : stream_(std::move(stream)), place_(std::move(place)) {}

  void listen(Listener listener) { listener_ = std::move(listener); }

  /// Sends the question, again and again with the same sequence until an answer comes. Returns the answer's body behind
  /// the code. Errors: no answer, refused, the stream's.
  Result<Bytes> ask(wire::Type type, std::span<const std::uint8_t> body, const Patience& patience = {0.2, 10});
  /// The same with messages.
  template <typename Answer, typename Question>
  Result<Answer> ask(wire::Type type, const Question& question, const Patience& patience = {0.2, 10});
  /// A question without a body.
  template <typename Answer>
  Result<Answer> ask(wire::Type type, const Patience& patience = {0.2, 10});

  /// Sends without waiting; the answer goes to the listener. Returns the sequence.
  Result<std::uint16_t> post(wire::Type type, std::span<const std::uint8_t> body);
  /// The same, but goes out with the next one.
  std::uint16_t prepare(wire::Type type, std::span<const std::uint8_t> body);
  Result<void> flush();

  /// Takes what has come, waiting at most `wait_s` for the first byte. Returns how many frames that were.
  Result<std::size_t> take(double wait_s);
  /// Ends whatever half a frame the other side may hold.
  Result<void> clear();

  const wire::FrameCounts& counts() const { return decoder_.counts(); }
  double silent_s() const { return std::chrono::duration<double>(Clock::now() - heard_).count(); }
  const std::string& place() const { return place_; }

 private:
  struct Awaited {
    std::uint8_t type;
    std::uint16_t sequence;
    std::optional<Bytes> body;
  };
  template <typename Answer>
  Result<Answer> answerIn(const Result<Bytes>& body) const;
  Error refusal(wire::Type type, std::uint8_t code) const;

  std::unique_ptr<ByteStream> stream_;
  std::string place_;
  Listener listener_;
  wire::FrameDecoder decoder_;
  Bytes came_, going_;
  Awaited* awaited_ = nullptr;
  std::uint16_t sequence_ = 0;
  Clock::time_point heard_ = Clock::now();
};

template <typename Message>
BoardLink::Bytes bodyOf(const Message& message) {
  BoardLink::Bytes room(wire::mostBody);
  wire::Writer out(room);
  out(message);
  room.resize(out.written().size());
  return room;
}

template <typename Answer>
Result<Answer> BoardLink::answerIn(const Result<Bytes>& body) const {
  if (!body) return body.error();
  Answer answer;
  if (!wire::readMessage(*body, answer))
    return Error{place_, message("gave an answer that is too short for what was asked")};
  return answer;
}

template <typename Answer, typename Question>
Result<Answer> BoardLink::ask(wire::Type type, const Question& question, const Patience& patience) {
  return answerIn<Answer>(ask(type, std::span<const std::uint8_t>(bodyOf(question)), patience));
}

template <typename Answer>
Result<Answer> BoardLink::ask(wire::Type type, const Patience& patience) {
  return answerIn<Answer>(ask(type, std::span<const std::uint8_t>{}, patience));
}

}  // namespace breakaway
