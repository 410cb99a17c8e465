#include "base/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "base/file_in_pieces.h"
#include "base/made.h"

namespace breakaway {

namespace fs = std::filesystem;

namespace {
constexpr size_t mostFromStream = size_t{256} << 20;

Error systemError(const std::string& path, const std::string& what, int number) {
  return {path, what + ": " + std::error_code(number, std::generic_category()).message()};
}

std::optional<struct stat> statusOf(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

bool same(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

/// 0, or the system's reason.
int writeAll(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : EIO;
    text.remove_prefix(static_cast<size_t>(written));
  }
  return 0;
}

/// Where a chain of links ends, whether there is a file or not yet.
fs::path targetOf(const std::string& path) {
  fs::path target = path;
  std::error_code code;
  for (int k = 0; k < 40 && fs::is_symlink(target, code); ++k) {
    const fs::path next = fs::read_symlink(target, code);
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target;
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void syncFolder(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

using Pieces = std::function<Result<std::string>()>;

Result<void> writePieces(int file, const std::string& path, const Pieces& next) {
  for (;;) {
    const auto piece = next();
    if (!piece) return piece.error();
    if (piece->empty()) return {};
    if (const int failed = writeAll(file, *piece); failed != 0) return systemError(path, "cannot be written", failed);
  }
}

Result<void> writeThrough(const std::string& path, const Pieces& next) {
  if (isStandardOutput(path)) {
    std::fflush(stdout);
    return writePieces(STDOUT_FILENO, path, next);
  }
  const int file = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (file < 0) return systemError(path, "cannot be written", errno);
  auto done = writePieces(file, path, next);
  if (::close(file) != 0 && done) return systemError(path, "cannot be written", errno);
  return done;
}

constexpr std::string_view partBegins = ".breakaway-", partEnds = ".part";

/// What writers that were killed amidst replacing a file left in its folder. Of a living one's the lock isn't to be
/// had.
void removeLeftParts(const fs::path& folder) {
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(partBegins) || !name.ends_with(partEnds)) continue;
    const int file = ::open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
    ::close(file);
  }
}

/// A new file in the target's folder: without a name as long as it isn't whole, where the file system has such. Locked
/// until it is in its place.
class NewFile {
 public:
  explicit NewFile(const fs::path& target) {
    static std::atomic<unsigned> count{0};
    const fs::path folder = folderOf(target);
    name_ = folder / (std::string(partBegins) + std::to_string(::getpid()) + "-" + std::to_string(count++) +
                      std::string(partEnds));
    file_ = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    if (file_ < 0) {
      file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      named_ = file_ >= 0;
    }
    if (file_ >= 0) ::flock(file_, LOCK_EX | LOCK_NB);
  }
  ~NewFile() {
    if (file_ >= 0) ::close(file_);
    if (named_) ::unlink(name_.c_str());
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  bool open() const { return file_ >= 0; }
  /// These return 0, or the system's reason.
  int takeAfter(const std::optional<struct stat>& earlier) {
    if (earlier) {
      if (::fchown(file_, earlier->st_uid, earlier->st_gid) != 0 && ::fchown(file_, uid_t(-1), earlier->st_gid) != 0) {
        // another's file in a shared folder: it becomes ours
      }
      if (::fchmod(file_, earlier->st_mode & 07777) != 0) return errno;
    }
    return 0;
  }
  int descriptor() const { return file_; }
  int sync() { return ::fsync(file_) == 0 || errno == EINVAL ? 0 : errno; }
  int take(const fs::path& target) {
    const std::string self = "/proc/self/fd/" + std::to_string(file_);
    if (!named_ && ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, target.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      syncFolder(folderOf(target));  // there was none before: it has never had another name
      return 0;
    }
    if (!named_) {
      if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name_.c_str(), AT_SYMLINK_FOLLOW) != 0) return errno;
      named_ = true;
    }
    if (::rename(name_.c_str(), target.c_str()) != 0) return errno;
    named_ = false;
    removeLeftParts(folderOf(target));
    syncFolder(folderOf(target));
    return 0;
  }

 private:
  fs::path name_;
  int file_ = -1;
  bool named_ = false;
};

Result<void> checkTarget(const std::string& path) {
  const auto there = statusOf(path);
  if (there && S_ISDIR(there->st_mode)) return Error{path, "is a folder, expected a file"};
  if (there) {
    const bool protectedFile = S_ISREG(there->st_mode) && (there->st_mode & 0222) == 0;
    if (protectedFile || ::access(path.c_str(), W_OK) != 0)
      return Error{path, "cannot be written: it is protected against writing"};
    if (!S_ISREG(there->st_mode)) return {};
  }
  const fs::path folder = folderOf(targetOf(path));
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return systemError(path, "cannot be written", errno);
  return {};
}

}  // namespace

bool isStandardOutput(const std::string& path) {
  if (path == "-") return true;
  const auto there = statusOf(path);
  struct stat out {};
  return there && ::fstat(STDOUT_FILENO, &out) == 0 && same(*there, out);
}

bool isAmong(const std::string& path, const std::vector<std::string>& inputs) {
  const auto there = statusOf(path);
  if (!there || !S_ISREG(there->st_mode)) return false;
  return std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
    const auto read = statusOf(input);
    return read && same(*there, *read);
  });
}

Result<void> checkOutput(const std::string& path, const std::vector<std::string>& inputs) {
  if (path.empty()) return Error{"output", "has an empty name, expected a file"};
  if (path == "-") return {};
  if (path.ends_with('/')) return Error{path, "is the name of a folder, expected a file"};
  if (isAmong(path, inputs)) return Error{path, "is an input as well, expected another file to write"};
  if (isStandardOutput(path)) return {};
  return checkTarget(path);
}

Result<void> writeFile(const std::string& path, std::string_view content) {
  bool given = false;
  return writeFileInPieces(
      path, [&]() -> Result<std::string> { return std::exchange(given, true) ? std::string() : std::string(content); });
}

Result<void> writeFileInPieces(const std::string& path, const std::function<Result<std::string>()>& next) {
  if (auto good = checkOutput(path); !good) return good;
  const auto earlier = statusOf(path);
  if (isStandardOutput(path) || (earlier && !S_ISREG(earlier->st_mode))) return writeThrough(path, next);
  const fs::path target = targetOf(path);
  NewFile file(target);
  if (!file.open()) return systemError(path, "cannot be written", errno);
  int failed = file.takeAfter(earlier);
  if (failed == 0) {
    if (auto written = writePieces(file.descriptor(), path, next); !written) return written;
    failed = file.sync();
  }
  if (failed != 0) return systemError(path, "cannot be written", failed);
  if (failed = file.take(target); failed != 0) return systemError(path, "cannot be replaced", failed);
  return {};
}

void syncTree(const std::string& path) {
  std::error_code code;
  if (fs::is_directory(path, code)) {
    for (const auto& one : fs::directory_iterator(path, code)) {
      if (!one.is_symlink(code)) syncTree(one.path().string());
    }
    syncFolder(path);
    return;
  }
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

Result<std::string> readFile(const std::string& path) {
  std::error_code code;
  if (fs::is_directory(path, code)) return Error{path, "is a folder, expected a file"};
  std::FILE* file = path == "-" ? stdin : std::fopen(path.c_str(), "rb");
  if (file == nullptr) return systemError(path, "cannot be read", errno);
  std::string content;
  const auto size = fs::file_size(path, code);
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
  fs::create_directories(path, code);
  if (code) return Error{path, "cannot be created as a folder: " + code.message()};
  if (!fs::is_directory(path, code)) return Error{path, "is a file, expected a folder"};
  return {};
}

}  // namespace breakaway
