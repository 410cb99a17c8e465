#include "firmware_link/transport/open_byte_stream.h"

#include <filesystem>
#include <utility>

#include "firmware_link/transport/byte_address.h"
#include "firmware_link/transport/descriptor_stream.h"
#include "firmware_link/transport/read_ahead.h"
#include "firmware_link/transport/serial_line.h"
#include "firmware_link/transport/serial_ports.h"
#include "firmware_link/transport/tcp_connection.h"

namespace breakaway {

namespace {

constexpr double connectWait_s = 2.0;

/// The error of a port that isn't there, with those that are.
Error withThosePresent(const Error& error) {
  std::string all;
  for (const SerialPort& one : serialPorts()) all += (all.empty() ? "" : ", ") + one.words();
  return {error.place,
          error.fact + "; " + (all.empty() ? message("none is plugged in") : message("there are: {}", all))};
}

Result<Descriptor> openDescriptor(const ByteAddress& address) {
  if (address.kind == ByteAddress::Kind::tcp) return connectTcp(address.host, address.port, connectWait_s);
  auto line = openSerialLine(address.device, address.baud);
  std::error_code code;
  if (!line && !std::filesystem::exists(address.device, code)) return withThosePresent(line.error());
  return line;
}

}  // namespace

Result<std::unique_ptr<ByteStream>> openByteStream(const std::string& uri) {
  const auto address = byteAddressOf(uri);
  if (!address) return address.error();
  auto descriptor = openDescriptor(*address);
  if (!descriptor) return descriptor.error();
  auto stream = std::make_unique<DescriptorStream>(std::move(*descriptor), address->words());
  return std::unique_ptr<ByteStream>(std::make_unique<ReadAhead>(std::move(stream)));
}

}  // namespace breakaway
