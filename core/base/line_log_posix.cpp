#include "base/line_log.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

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

Error notWritten(const std::string& path, int number) {
  return {path, "cannot be written: " + std::error_code(number, std::generic_category()).message()};
}

bool isStream(const std::string& path) {
  std::error_code code;
  return isStandardOutput(path) ||
         (std::filesystem::exists(path, code) && !std::filesystem::is_regular_file(path, code));
}

/// Appends to the open file; a disk that is full leaves no half line.
Result<void> appendTo(int file, const std::string& path, std::string_view text) {
  if (cutAfterLastEnd(file) && writeWhole(file, text) && ::fsync(file) == 0) return {};
  const Error failed = notWritten(path, errno);
  cutAfterLastEnd(file);
  return failed;
}

/// Whether the open file is still the one at `path`.
bool standsAt(int file, const std::string& path) {
  struct stat mine {
  }, there{};
  return ::fstat(file, &mine) == 0 && ::stat(path.c_str(), &there) == 0 && mine.st_ino == there.st_ino &&
         mine.st_dev == there.st_dev;
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

Result<OwnLineLog> OwnLineLog::open(const std::string& path) {
  OwnLineLog log(path);
  if (isStream(path)) return log;
  if (auto taken = log.take(); !taken) return taken.error();
  return log;
}

OwnLineLog::OwnLineLog(OwnLineLog&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {
}

OwnLineLog::~OwnLineLog() {
  if (file_ >= 0) ::close(file_);
}

Result<void> OwnLineLog::take() {
  const int file = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return notWritten(path_, errno);
  const bool locked = ::flock(file, LOCK_EX | LOCK_NB) == 0;
  const int why = errno;
  if (locked && standsAt(file, path_)) {
    if (file_ >= 0) ::close(file_);
    file_ = file;
    return {};
  }
  ::close(file);
  if (!locked && why != EWOULDBLOCK) return notWritten(path_, why);
  return Error{path_, "is written by another process, expected a file that is not"};
}

Result<void> OwnLineLog::append(std::string_view line) const {
  const std::string text = std::string(line) + "\n";
  return file_ < 0 ? writeFile(path_, text) : appendTo(file_, path_, text);
}

Result<void> OwnLineLog::replace(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  if (auto written = writeFile(path_, text); !written) return written;
  return file_ < 0 ? Result<void>() : take();
}

Result<void> appendLine(const std::string& path, std::string_view line) {
  const std::string text = std::string(line) + "\n";
  if (isStream(path)) return writeFile(path, text);
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return notWritten(path, errno);
  Result<void> done = ::flock(file, LOCK_EX) == 0 ? appendTo(file, path, text) : notWritten(path, errno);
  if (::close(file) != 0 && done) done = notWritten(path, errno);
  return done;
}

}  // namespace breakaway
