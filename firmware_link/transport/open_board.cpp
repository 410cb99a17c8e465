#include "firmware_link/transport/open_board.h"

#include "firmware_link/board_drive.h"
#include "firmware_link/presets.h"
#include "firmware_link/simulated_board.h"
#include "firmware_link/transport/byte_address.h"
#include "firmware_link/transport/open_byte_stream.h"

namespace breakaway {

Result<std::unique_ptr<Drive>> openBoard(const BoardRequest& request) {
  if (isSimulated(request.uri)) return openDrive(request.uri, request.seed);
  if (!carriesBytes(request.uri)) {
    return Error{
        "board " + request.uri,
        "is no known board, expected simulated[:PRESET or FILE.rig.json], serial:PORT[@BAUD] or tcp:HOST:PORT"};
  }
  const auto address = byteAddressOf(request.uri);
  if (!address) return address.error();
  auto stream = openByteStream(request.uri);
  if (!stream) return stream.error();
  return openBoardDrive(std::move(*stream), {.place = address->words()});
}

}  // namespace breakaway
