#include "firmware_link/vesc/vesc_frame.h"

#include <algorithm>
#include <cassert>

namespace breakaway {

namespace {
constexpr std::uint8_t shortStart = 2, longStart = 3, end = 3;
}

std::uint16_t crc16Xmodem(std::span<const std::uint8_t> bytes) {
  unsigned crc = 0;
  for (const std::uint8_t byte : bytes) {
    crc ^= static_cast<unsigned>(byte) << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000u) != 0 ? (crc << 1) ^ 0x1021u : crc << 1;
    crc &= 0xffffu;
  }
  return static_cast<std::uint16_t>(crc);
}

std::vector<std::uint8_t> vescFrame(std::span<const std::uint8_t> payload) {
  assert(!payload.empty() && payload.size() <= mostVescPayload);
  std::vector<std::uint8_t> frame;
  frame.reserve(payload.size() + 6);
  if (payload.size() <= 255) {
    frame.push_back(shortStart);
  } else {
    frame.push_back(longStart);
    frame.push_back(static_cast<std::uint8_t>(payload.size() >> 8));
  }
  frame.push_back(static_cast<std::uint8_t>(payload.size() & 0xff));
  frame.insert(frame.end(), payload.begin(), payload.end());
  const std::uint16_t crc = crc16Xmodem(payload);
  frame.push_back(static_cast<std::uint8_t>(crc >> 8));
  frame.push_back(static_cast<std::uint8_t>(crc & 0xff));
  frame.push_back(end);
  return frame;
}

void VescDecoder::drop(size_t count) {
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
  dropped_ += count;
}

std::optional<std::vector<std::uint8_t>> VescDecoder::rescue() {
  while (!waiting_.empty()) {
    drop(1);
    if (auto found = next()) return found;
  }
  return {};
}

std::optional<std::vector<std::uint8_t>> VescDecoder::next() {
  for (;;) {
    const auto start = std::find_if(waiting_.begin(), waiting_.end(),
                                    [](std::uint8_t byte) { return byte == shortStart || byte == longStart; });
    drop(static_cast<size_t>(start - waiting_.begin()));
    const size_t head = !waiting_.empty() && waiting_[0] == longStart ? 3 : 2;
    if (waiting_.size() < head) return {};
    const size_t length = head == 2 ? waiting_[1] : static_cast<size_t>(waiting_[1]) << 8 | waiting_[2];
    // The long form is for what the short one can't hold; anything else is no frame.
    if (length == 0 || length > mostVescPayload || (head == 3 && length < 255)) {
      drop(1);
      continue;
    }
    if (waiting_.size() < head + length + 3) return {};
    const std::span<const std::uint8_t> payload(waiting_.data() + head, length);
    const std::uint8_t* tail = payload.data() + length;
    if (tail[2] != end || crc16Xmodem(payload) != (tail[0] << 8 | tail[1])) {
      drop(1);
      continue;
    }
    std::vector<std::uint8_t> found(payload.begin(), payload.end());
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(head + length + 3));
    return found;
  }
}

}  // namespace breakaway
