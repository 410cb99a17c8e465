#include "firmware_link/transport/descriptor_stream.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>

namespace breakaway {

namespace {

using Clock = std::chrono::steady_clock;
constexpr double patience_s = 1.0;                 // of a write that nobody takes
constexpr size_t mostAtOnce = size_t{256} * 1024;  // so that a stream that never pauses gives its reader a turn

/// Waits until `events` or the end of the wait; false when the time is over.
bool waitFor(int descriptor, short events, double wait_s) {
  const auto end = Clock::now() + std::chrono::duration<double>(std::max(0.0, wait_s));
  for (;;) {
    const double left_s = std::chrono::duration<double>(end - Clock::now()).count();
    const double whole_s = std::floor(std::max(0.0, left_s));
    const timespec left{static_cast<time_t>(whole_s),
                        static_cast<long>(1e9 * std::clamp(left_s - whole_s, 0.0, 0.999999999))};
    pollfd one{descriptor, events, 0};
    const int ready = ::ppoll(&one, 1, &left, nullptr);
    if (ready > 0) return true;
    if (ready == 0 || errno != EINTR) return false;
  }
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

DescriptorStream::DescriptorStream(Descriptor descriptor, std::string name)
    : descriptor_(std::move(descriptor)), name_(std::move(name)) {
  struct stat kind {};
  socket_ = ::fstat(descriptor_.number(), &kind) == 0 && S_ISSOCK(kind.st_mode);
}

Error DescriptorStream::gone(int reason) const {
  const bool hungUp = reason == 0 || reason == EIO || reason == EPIPE || reason == ECONNRESET;
  return {name_, hungUp ? "is gone: the other end hung up or the cable was pulled"
                        : std::string("is gone: ") + std::strerror(reason)};
}

Result<void> DescriptorStream::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t taken = socket_ ? ::send(descriptor_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL)
                                  : ::write(descriptor_.number(), bytes.data(), bytes.size());
    if (taken > 0) {
      bytes = bytes.subspan(static_cast<size_t>(taken));
    } else if (taken < 0 && errno == EAGAIN) {
      if (!waitFor(descriptor_.number(), POLLOUT, patience_s))
        return Error{name_, message("took nothing for a second")};
    } else if (taken == 0 || errno != EINTR) {
      return gone(taken == 0 ? 0 : errno);
    }
  }
  return {};
}

Result<void> DescriptorStream::read(std::vector<std::uint8_t>& bytes, double wait_s) {
  std::array<std::uint8_t, 16384> chunk;
  size_t got = 0;
  if (wait_s > 0.0 && !waitFor(descriptor_.number(), POLLIN, wait_s)) return {};
  while (got < mostAtOnce) {
    const ssize_t count = ::read(descriptor_.number(), chunk.data(), chunk.size());
    if (count > 0) {
      bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + count);
      got += static_cast<size_t>(count);
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else if (count < 0 && errno == EAGAIN) {
      return {};
    } else {
      // What came before the end is handed over first; the next read meets the end again.
      return got > 0 ? Result<void>{} : Result<void>(gone(count == 0 ? 0 : errno));
    }
  }
  return {};
}

}  // namespace breakaway
