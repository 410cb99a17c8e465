#include "base/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "base/made.h"

namespace breakaway {

namespace {
constexpr size_t mostFromStream = size_t{256} << 20;

Error systemError(const std::string& path, const std::string& what, int number) {
  return {path, what + ": " + std::error_code(number, std::generic_category()).message()};
}
}  // namespace

Result<void> writeFile(const std::string& path, std::string_view content) {
  const std::string temporary = path + ".part" + std::to_string(::getpid());
  std::FILE* file = std::fopen(temporary.c_str(), "wb");
  if (file == nullptr) return systemError(path, "cannot be written", errno);
  const bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const int writeError = errno;
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed) {
    std::remove(temporary.c_str());
    return systemError(path, "cannot be written", written ? errno : writeError);
  }
  if (std::rename(temporary.c_str(), path.c_str()) != 0) {
    const int renameError = errno;
    std::remove(temporary.c_str());
    return systemError(path, "cannot be replaced", renameError);
  }
  return {};
}

Result<std::string> readFile(const std::string& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return Error{path, "is a folder, expected a file"};
  std::FILE* file = path == "-" ? stdin : std::fopen(path.c_str(), "rb");
  if (file == nullptr) return systemError(path, "cannot be read", errno);
  std::string content;
  const auto size = std::filesystem::file_size(path, code);
  if (!code) content.reserve(size);
  char block[1 << 16];
  size_t got = 0;
  const bool endless = !std::filesystem::is_regular_file(path, code);
  while ((got = std::fread(block, 1, sizeof block, file)) > 0) {
    content.append(block, got);
    if (!endless || content.size() <= mostFromStream) continue;
    if (file != stdin) std::fclose(file);
    return Error{path, "gives more than 256 MB without an end, expected a file"};
  }
  const bool failed = std::ferror(file) != 0;
  if (file != stdin) std::fclose(file);
  if (failed) return Error{path, "cannot be read to its end"};
  noteInput(path, content);
  return content;
}

Result<void> makeFolder(const std::string& path) {
  std::error_code code;
  std::filesystem::create_directories(path, code);
  if (code) return Error{path, "cannot be created as a folder: " + code.message()};
  if (!std::filesystem::is_directory(path, code)) return Error{path, "is a file, expected a folder"};
  return {};
}

}  // namespace breakaway
