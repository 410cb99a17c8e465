// Files appear whole or not at all: written beside their final name and renamed.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace breakaway {

/// Writes `content` to `path` through a temporary name in the same folder. The error names the path and the system's
/// reason.
Result<void> writeFile(const std::string& path, std::string_view content);

/// The whole content of the file at `path`; "-" is standard input. A pipe or a device that gives more than 256 MB is an
/// error.
Result<std::string> readFile(const std::string& path);

/// Creates the folder (and its parents); an existing one is welcome.
Result<void> makeFolder(const std::string& path);

}  // namespace breakaway
