#include "base/line_log.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "base/atomic_file.h"

namespace breakaway {

namespace {

/// Cuts the open file after its last line end. False: the system refused, errno says why.
bool cutAfterLastEnd(int file) {
  off_t end = ::lseek(file, 0, SEEK_END);
  if (end < 0) return false;
  char byte = 0;
  off_t keep = end;
  while (keep > 0) {
    if (::pread(file, &byte, 1, keep - 1) != 1) return false;
    if (byte == '\n') break;
    --keep;
  }
  return keep == end || ::ftruncate(file, keep) == 0;
}

bool writeWhole(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

}  // namespace

Result<std::vector<std::string>> readWholeLines(const std::string& path) {
  std::vector<std::string> lines;
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) {
    if (std::filesystem::is_directory(path, code)) return Error{path, "is a folder, expected a file"};
    return lines;
  }
  const auto text = readFile(path);
  if (!text) return text.error();
  size_t from = 0;
  for (size_t end = text->find('\n'); end != std::string::npos; end = text->find('\n', from)) {
    lines.push_back(text->substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

Result<void> appendLine(const std::string& path, std::string_view line) {
  std::string text(line);
  text += '\n';
  std::error_code code;
  const bool stream = std::filesystem::exists(path, code) && !std::filesystem::is_regular_file(path, code);
  if (stream || isStandardOutput(path)) return writeFile(path, text);
  const auto failed = [&path](int number) {
    return Error{path, "cannot be written: " + std::error_code(number, std::generic_category()).message()};
  };
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return failed(errno);
  Result<void> done;
  if (::flock(file, LOCK_EX) != 0 || !cutAfterLastEnd(file) || !writeWhole(file, text) || ::fsync(file) != 0) {
    done = failed(errno);
    cutAfterLastEnd(file);  // a disk that is full leaves no half line
  }
  if (::close(file) != 0 && done) done = failed(errno);
  return done;
}

}  // namespace breakaway
