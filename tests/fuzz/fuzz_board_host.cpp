#include <algorithm>

#include "firmware_link/board_drive.h"
#include "firmware_link/vesc/vesc_drive.h"
#include "firmware_link/wire/frame.h"
#include "firmware_link/wire/messages.h"
#include "fuzz/fuzzed.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

/// A board that says what was fuzzed, a piece per reading, and is gone afterwards. With `framed` each piece is the body
/// of an answer to what was asked last.
class Talker : public ByteStream {
 public:
  Talker(std::string_view bytes, bool framed) : left_(bytes), framed_(framed) {}
  Result<void> write(std::span<const std::uint8_t> bytes) override {
    for (const std::uint8_t byte : bytes) {
      if (asked_.take(byte)) type_ = asked_.frame().type, sequence_ = asked_.frame().sequence;
    }
    return {};
  }
  Result<void> read(std::vector<std::uint8_t>& bytes, double /*wait_s*/) override {
    if (left_.empty()) return Error{"board", "is gone"};
    const size_t size = std::min<size_t>(static_cast<unsigned char>(left_.front()), left_.size() - 1);
    const std::vector<std::uint8_t> body(left_.begin() + 1, left_.begin() + 1 + static_cast<std::ptrdiff_t>(size));
    left_.remove_prefix(size + 1);
    if (!framed_) {
      bytes.insert(bytes.end(), body.begin(), body.end());
      return {};
    }
    std::uint8_t frame[wire::mostFrame];
    const auto type = static_cast<std::uint8_t>(type_ | wire::answerBit);
    const size_t length =
        wire::FrameEncoder::encode({type, sequence_, std::span(body).first(std::min(size, wire::mostBody))}, frame);
    bytes.insert(bytes.end(), frame, frame + length);
    return {};
  }

 private:
  std::string_view left_;
  bool framed_;
  wire::FrameDecoder asked_;
  std::uint8_t type_ = 0;
  std::uint16_t sequence_ = 0;
};

}  // namespace

/// The host's side of our wire and of a VESC's, from the first hello on: a drive or one line.
static const Fuzzed boardHost("board_host", [](std::string_view bytes) {
  if (bytes.empty()) return;
  const char kind = bytes.front();
  bytes.remove_prefix(1);
  if (kind == 'v') {
    std::unique_ptr<ByteStream> stream = std::make_unique<Talker>(bytes, false);
    VescOptions options;
    options.polePairs = 7.0;
    options.answerWait_s = 0.001;
    if (const auto drive = openVesc(stream, options); !drive) requireOneLine(drive.error().message());
    return;
  }
  const auto drive = openBoardDrive(std::make_unique<Talker>(bytes, kind == 'w'), {});
  if (!drive) requireOneLine(drive.error().message());
});
