// Files packed by gzip, and what zlib packed within files.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace breakaway {

bool isGzip(std::string_view bytes);

/// The content, of all members one after the other. Errors, at `name`: damaged, cut short, more than 2 GB.
Result<std::string> unpackGzip(std::string_view bytes, const std::string& name);

/// Whether what zlib packed can't be unpacked, or isn't what its checksum says; its first gigabyte is looked at. A
/// missing end is no damage.
bool isDamagedZlib(std::string_view bytes);

}  // namespace breakaway
