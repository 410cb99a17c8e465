#include "firmware_link/transport/tcp_connection.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <fmt/core.h>
#include <cerrno>
#include <cstring>
#include <memory>

#include "firmware_link/transport/byte_address.h"

namespace breakaway {

namespace {

constexpr int unheard_ms = 2000;  // after which the system gives up on bytes that nobody acknowledged

struct FreeAddresses {
  void operator()(addrinfo* first) const { ::freeaddrinfo(first); }
};

/// 0, or why not.
int connectOne(const addrinfo& address, double wait_s, Descriptor& connection) {
  Descriptor fresh(
      ::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, address.ai_protocol));
  if (!fresh.open()) return errno;
  if (::connect(fresh.number(), address.ai_addr, address.ai_addrlen) != 0) {
    if (errno != EINPROGRESS) return errno;
    pollfd one{fresh.number(), POLLOUT, 0};
    if (::poll(&one, 1, static_cast<int>(1e3 * wait_s)) <= 0) return ETIMEDOUT;
    int reason = 0;
    socklen_t size = sizeof reason;
    if (::getsockopt(fresh.number(), SOL_SOCKET, SO_ERROR, &reason, &size) != 0) return errno;
    if (reason != 0) return reason;
  }
  const int yes = 1;
  ::setsockopt(fresh.number(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  ::setsockopt(fresh.number(), SOL_SOCKET, SO_KEEPALIVE, &yes, sizeof yes);
  ::setsockopt(fresh.number(), IPPROTO_TCP, TCP_USER_TIMEOUT, &unheard_ms, sizeof unheard_ms);
  connection = std::move(fresh);
  return 0;
}

Message whyNot(int reason, double wait_s) {
  switch (reason) {
    case ECONNREFUSED:
      return message("refuses the connection: nothing listens on that port");
    case ETIMEDOUT:
      return message("does not answer within {:.1f} s", wait_s);
    default:
      return message("cannot be reached: {}", std::strerror(reason));
  }
}

}  // namespace

Result<Descriptor> connectTcp(const std::string& host, std::uint16_t port, double wait_s) {
  ByteAddress named;
  named.kind = ByteAddress::Kind::tcp;
  named.host = host;
  named.port = port;
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int unknown = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (unknown != 0) return Error{named.words(), message("is no known host: {}", ::gai_strerror(unknown))};
  const std::unique_ptr<addrinfo, FreeAddresses> addresses(found);
  int reason = EHOSTUNREACH;
  for (const addrinfo* one = found; one != nullptr; one = one->ai_next) {
    Descriptor connection;
    reason = connectOne(*one, wait_s, connection);
    if (reason == 0) return connection;
  }
  return Error{named.words(), whyNot(reason, wait_s)};
}

}  // namespace breakaway
