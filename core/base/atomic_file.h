// Files appear whole or not at all: written without a name, or beside their final one, and renamed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// Writes `content` to `path`, on the disk when it returns. A symbolic link is followed and stays; a file that is there
/// keeps its mode and owner; a FIFO, a device, standard output (also as "-") is written to as such. The error names the
/// path and the system's reason; then nothing has changed.
Result<void> writeFile(const std::string& path, std::string_view content);

/// Whether writeFile() has a chance, asked before the work that fills the file. Errors: an empty name, a folder, a
/// protected file, no folder to write in, the same file as one of `inputs`.
Result<void> checkOutput(const std::string& path, const std::vector<std::string>& inputs = {});

/// Whether `path` names standard output: "-", or the file that it leads to.
bool isStandardOutput(const std::string& path);

/// Whether `path` is one of `inputs`, whatever links lead there.
bool isAmong(const std::string& path, const std::vector<std::string>& inputs);

/// Puts a file or folder and what is in it on the disk, as far as the file system does.
void syncTree(const std::string& path);

/// The whole content of the file at `path`; "-" is standard input. A pipe or a device that gives more than 256 MB is an
/// error.
Result<std::string> readFile(const std::string& path);

/// Creates the folder (and its parents); an existing one is welcome.
Result<void> makeFolder(const std::string& path);

}  // namespace breakaway
