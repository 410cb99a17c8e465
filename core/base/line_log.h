// A log of lines that long runs append to: a kill loses at most the line that was being written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// The whole lines of the file at `path`, without their ends; none when there is no such file, or a device. A last line
/// that doesn't end was cut short by a kill and is left out. Errors: the file can't be read.
Result<std::vector<std::string>> readWholeLines(const std::string& path);

/// Appends `line` and its end in one go, creating the file and cutting away a last line that was cut short. Several
/// processes may append to the same file. Precondition: `line` holds no line end.
Result<void> appendLine(const std::string& path, std::string_view line);

}  // namespace breakaway
