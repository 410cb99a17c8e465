// A TCP connection to a board, or to what serves one.
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"
#include "firmware_link/transport/descriptor_stream.h"

namespace breakaway {

/// Waits at most `wait_s` for each of the host's addresses. Small writes go out at once. Errors: unknown host, refused,
/// no answer in time.
Result<Descriptor> connectTcp(const std::string& host, std::uint16_t port, double wait_s);

}  // namespace breakaway
