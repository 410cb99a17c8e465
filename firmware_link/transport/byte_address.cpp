#include "firmware_link/transport/byte_address.h"

#include <charconv>
#include <optional>

namespace breakaway {

namespace {

constexpr const char* serialScheme = "serial:";
constexpr const char* tcpScheme = "tcp:";
constexpr unsigned mostBaud = 20'000'000;

std::optional<unsigned> wholeNumber(const std::string& text, unsigned least, unsigned most) {
  unsigned value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size() || value < least || value > most) return {};
  return value;
}

Result<ByteAddress> serialAddress(const std::string& uri, const std::string& rest) {
  ByteAddress address;
  const size_t at = rest.rfind('@');
  const std::string name = rest.substr(0, at);
  if (name.empty()) return Error{"board " + uri, message("names no port, expected serial:PORT or serial:PORT@BAUD")};
  address.device = name.find('/') == std::string::npos ? "/dev/" + name : name;
  if (at == std::string::npos) return address;
  const std::string rate = rest.substr(at + 1);
  const auto baud = wholeNumber(rate, 1, mostBaud);
  if (!baud) {
    return Error{"board " + uri,
                 message("has the baud rate \"{}\", expected a whole number of bits per second such as 921600", rate)};
  }
  address.baud = *baud;
  return address;
}

Result<ByteAddress> tcpAddress(const std::string& uri, const std::string& rest) {
  ByteAddress address;
  address.kind = ByteAddress::Kind::tcp;
  const size_t colon = rest.rfind(':');
  const std::string port = colon == std::string::npos ? rest : rest.substr(colon + 1);
  address.host = colon == std::string::npos ? std::string() : rest.substr(0, colon);
  if (address.host.size() > 1 && address.host.front() == '[' && address.host.back() == ']')
    address.host = address.host.substr(1, address.host.size() - 2);
  if (address.host.empty()) address.host = "127.0.0.1";
  const auto number = wholeNumber(port, 1, 65535);
  if (!number)
    return Error{"board " + uri, message("has the port \"{}\", expected tcp:HOST:PORT with 1 to 65535", port)};
  address.port = static_cast<std::uint16_t>(*number);
  return address;
}

}  // namespace

std::string ByteAddress::words() const {
  if (kind == Kind::serial) return "serial port " + device;
  return (host.find(':') == std::string::npos ? host : "[" + host + "]") + ":" + std::to_string(port);
}

bool carriesBytes(const std::string& uri) {
  return uri.starts_with(serialScheme) || uri.starts_with(tcpScheme);
}

Result<ByteAddress> byteAddressOf(const std::string& uri) {
  const auto rest = [&uri](const char* scheme) { return uri.substr(std::string(scheme).size()); };
  if (uri.starts_with(serialScheme)) return serialAddress(uri, rest(serialScheme));
  if (uri.starts_with(tcpScheme)) return tcpAddress(uri, rest(tcpScheme));
  return Error{"board " + uri, message("is no known board, expected simulated, serial:PORT[@BAUD] or tcp:HOST:PORT")};
}

}  // namespace breakaway
