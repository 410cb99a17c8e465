// Opens what carries a board's bytes.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "firmware_link/byte_stream.h"

namespace breakaway {

/// Opens `serial:PORT[@BAUD]` or `tcp:HOST:PORT` (see byte_address.h). The stream needs no event loop and reads ahead,
/// so that a busy listener loses nothing; it may be used in another thread than the one that opened it. A stream that
/// is gone stays gone: whoever wants the board back opens the URI again and meets it as it is then, which is how a
/// reconnection can't carry an armed motor over. Errors are one line: which port or host, what is wrong, and what to
/// do.
Result<std::unique_ptr<ByteStream>> openByteStream(const std::string& uri);

}  // namespace breakaway
