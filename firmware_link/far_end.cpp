#include "firmware_link/far_end.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace breakaway {

namespace {

Error systemError(const std::string& place) {
  return {place, std::string("cannot be opened: ") + std::strerror(errno)};
}

bool ready(int descriptor, short events, double wait_s) {
  const double whole_s = std::floor(std::max(0.0, wait_s));
  const timespec left{static_cast<time_t>(whole_s), static_cast<long>(1e9 * std::max(0.0, wait_s - whole_s))};
  pollfd one{descriptor, events, 0};
  return ::ppoll(&one, 1, &left, nullptr) > 0;
}

}  // namespace

Result<FarEnd> FarEnd::pseudoTerminal() {
  const int line = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
  std::array<char, 128> name{};
  if (line < 0 || ::grantpt(line) != 0 || ::unlockpt(line) != 0 || ::ptsname_r(line, name.data(), name.size()) != 0)
    return systemError("pseudo terminal");
  const int kept = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios form{};
  if (kept < 0 || ::tcgetattr(kept, &form) != 0) return systemError(name.data());
  ::cfmakeraw(&form);
  ::tcsetattr(kept, TCSANOW, &form);
  return FarEnd(-1, line, kept, std::string("serial:") + name.data());
}

Result<FarEnd> FarEnd::loopback(std::uint16_t port) {
  const std::string place = "127.0.0.1:" + std::to_string(port);
  const int listening = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (listening < 0) return systemError(place);
  const int yes = 1;
  ::setsockopt(listening, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* general = reinterpret_cast<sockaddr*>(&address);
  socklen_t size = sizeof address;
  if (::bind(listening, general, size) != 0 || ::listen(listening, 1) != 0 ||
      ::getsockname(listening, general, &size) != 0) {
    const Error error = systemError(place);
    ::close(listening);
    return error;
  }
  return FarEnd(listening, -1, -1, "tcp:127.0.0.1:" + std::to_string(ntohs(address.sin_port)));
}

FarEnd::FarEnd(FarEnd&& other) noexcept
    : listening_(std::exchange(other.listening_, -1)),
      line_(std::exchange(other.line_, -1)),
      kept_(std::exchange(other.kept_, -1)),
      uri_(std::move(other.uri_)) {
}

FarEnd::~FarEnd() {
  for (const int one : {listening_, line_, kept_}) {
    if (one >= 0) ::close(one);
  }
}

void FarEnd::hangUp() {
  if (listening_ < 0) return;  // a pseudo terminal stays
  ::close(line_);
  line_ = -1;
}

void FarEnd::read(std::vector<std::uint8_t>& bytes, double wait_s) {
  if (line_ < 0) {
    if (!ready(listening_, POLLIN, wait_s)) return;
    line_ = ::accept4(listening_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    const int yes = 1;
    if (line_ >= 0) ::setsockopt(line_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    return;
  }
  if (!ready(line_, POLLIN, wait_s)) return;
  std::array<std::uint8_t, 4096> part;
  const ssize_t size = ::read(line_, part.data(), part.size());
  if (size > 0) {
    bytes.insert(bytes.end(), part.begin(), part.begin() + size);
  } else if (size == 0 || (errno != EAGAIN && errno != EINTR)) {
    hangUp();
  }
}

std::size_t FarEnd::write(std::span<const std::uint8_t> bytes, double wait_s) {
  if (line_ < 0 || bytes.empty()) return bytes.size();
  const auto once = [&] {
    return listening_ < 0 ? ::write(line_, bytes.data(), bytes.size())
                          : ::send(line_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  };
  ssize_t taken = once();
  if (taken < 0 && errno == EAGAIN && wait_s > 0.0 && ready(line_, POLLOUT, wait_s)) taken = once();
  if (taken >= 0) return static_cast<std::size_t>(taken);
  if (errno == EAGAIN || errno == EINTR) return 0;
  hangUp();
  return bytes.size();
}

}  // namespace breakaway
