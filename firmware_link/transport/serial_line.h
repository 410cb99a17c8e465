// A serial line: opened for us alone, raw, 8N1, at the baud rate that was asked for or not at all.
#pragma once

#include <string>

#include "base/result.h"
#include "firmware_link/transport/descriptor_stream.h"

namespace breakaway {

/// Errors: no such port, one that is in use, that may not be opened (with the fix), that is no serial port, or that
/// runs at another rate than asked for.
Result<Descriptor> openSerialLine(const std::string& device, unsigned baud);

/// Sets an open terminal raw, 8N1, without flow control, and reads back what the driver made of it.
Result<void> setLine(int descriptor, unsigned baud, const std::string& place);

}  // namespace breakaway
