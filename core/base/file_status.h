// What the system knows of a file without reading it.
#pragma once

#include <string>

namespace breakaway {

/// A text that is another one when the file at `path` has changed: its time of change, size and place on the disk.
/// Empty: there is no such file.
std::string stampOfFile(const std::string& path);

/// Whether this process may write to the file at `path`, or make files in the folder there.
bool mayBeWritten(const std::string& path);

}  // namespace breakaway
