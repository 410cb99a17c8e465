#include "firmware_link/transport/open_board.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/made.h"
#include "firmware_link/board_drive.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/transport/byte_address.h"
#include "firmware_link/transport/open_byte_stream.h"
#include "firmware_link/vesc/vesc_drive.h"

namespace breakaway {

namespace {

constexpr const char* vescScheme = "vesc:";
constexpr double quick_s = 0.45;  // a board that runs answers far sooner
constexpr double waking_s = 2.5;  // one that starts anew when its port is opened, or an emulator that looks for a host

/// Takes `name=value&…` into the request.
Result<void> takeOptions(const std::string& options, BoardRequest& request) {
  const std::pair<const char*, std::optional<double> BoardRequest::*> known[] = {
      {"pole_pairs", &BoardRequest::polePairs},
      {"counts_per_rev", &BoardRequest::countsPerRev},
      {"current_limit_A", &BoardRequest::currentLimit_A}};
  for (size_t at = 0; at <= options.size();) {
    const size_t end = std::min(options.find('&', at), options.size());
    const std::string one = options.substr(at, end - at), name = one.substr(0, one.find('='));
    const std::string text = one.size() > name.size() ? one.substr(name.size() + 1) : std::string();
    at = end + 1;
    bool found = false;
    for (const auto& [field, member] : known) {
      if (name != field) continue;
      found = true;
      double value = 0.0;
      const auto [rest, code] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (code != std::errc() || rest != text.data() + text.size() || !(value > 0.0 && value < 1e9))
        return Error{"board " + request.uri, message("has {}=\"{}\", expected a positive number", name, text)};
      request.*member = value;
    }
    if (!found) {
      return Error{"board " + request.uri,
                   message("knows no option \"{}\", expected pole_pairs, counts_per_rev or current_limit_A", name)};
    }
  }
  return {};
}

Error nobody(const ByteAddress& address, bool vescOnly) {
  const Message fact = vescOnly ? message("nothing answers as a VESC")
                                : message("nothing answers as a board: neither Breakaway's firmware nor a VESC");
  const Message advice =
      address.kind == ByteAddress::Kind::serial
          ? message("; check that it has power, that this is its port, and the baud rate ({})", address.baud)
          : message("; check that it has power");
  return {address.words(), fact + advice};
}

Result<std::unique_ptr<Drive>> openOnWire(const std::string& uri, bool vescOnly, const BoardRequest& request) {
  const auto address = byteAddressOf(uri);
  if (!address) return Error{"board " + request.uri, address.error().fact};
  auto opened = openByteStream(uri);
  if (!opened) return opened.error();
  std::unique_ptr<ByteStream> stream = std::move(*opened);
  if (!vescOnly) {
    const auto ours = speaksWire(*stream, quick_s);
    if (!ours) return ours.error();
    if (*ours) return openBoardDrive(std::move(stream), {.place = address->words()});
  }
  VescOptions vesc;
  vesc.polePairs = request.polePairs;
  vesc.countsPerRev = request.countsPerRev;
  if (request.currentLimit_A) vesc.currentLimit_A = *request.currentLimit_A;
  auto drive = openVesc(stream, vesc);
  if (!drive || *drive != nullptr) return drive;
  if (!vescOnly) {
    const auto awake = speaksWire(*stream, waking_s);
    if (!awake) return awake.error();
    if (*awake) return openBoardDrive(std::move(stream), {.place = address->words()});
  }
  return nobody(*address, vescOnly);
}

Result<std::unique_ptr<Drive>> openByUri(const BoardRequest& request) {
  if (isSimulated(request.uri)) return openDrive(request.uri, request.seed);
  BoardRequest whole = request;
  const bool vescOnly = whole.uri.starts_with(vescScheme);
  std::string uri = vescOnly ? whole.uri.substr(std::string(vescScheme).size()) : whole.uri;
  if (const size_t mark = uri.find('?'); mark != std::string::npos) {
    if (auto taken = takeOptions(uri.substr(mark + 1), whole); !taken) return taken.error();
    uri.resize(mark);
  }
  return openOnWire(uri, vescOnly, whole);
}

}  // namespace

Result<std::unique_ptr<Drive>> openBoard(const BoardRequest& request) {
  auto drive = openByUri(request);
  if (!drive) return drive;
  const Identity& board = (*drive)->identity();
  noteDevice(MadeOn{board.device, board.serialNumber, board.firmware});
  return drive;
}

}  // namespace breakaway
