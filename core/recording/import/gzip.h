// Files packed by gzip.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace breakaway {

bool isGzip(std::string_view bytes);

/// The content, of all members one after the other. Errors, at `name`: damaged, cut short, more than 2 GB.
Result<std::string> unpackGzip(std::string_view bytes, const std::string& name);

}  // namespace breakaway
