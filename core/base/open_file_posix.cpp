#include "base/open_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace breakaway {

namespace {

int flagsFor(OpenFile::Purpose purpose) {
  switch (purpose) {
    case OpenFile::Purpose::reading:
      return O_RDONLY;
    case OpenFile::Purpose::mending:
      return O_RDWR;
    case OpenFile::Purpose::making:
      return O_RDWR | O_CREAT | O_EXCL;
  }
  return O_RDONLY;
}

}  // namespace

OpenFile::OpenFile(const std::string& path, Purpose purpose)
    : file_(::open(path.c_str(), flagsFor(purpose) | O_CLOEXEC, 0666)), failed_(file_ < 0 ? errno : 0) {
}

OpenFile::~OpenFile() {
  if (file_ >= 0) ::close(file_);
}

std::optional<std::uint64_t> OpenFile::size() const {
  struct stat status {};
  if (::fstat(file_, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

bool OpenFile::read(char* into, size_t bytes) const {
  while (bytes > 0) {
    const ssize_t got = ::read(file_, into, bytes);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    into += got;
    bytes -= static_cast<size_t>(got);
  }
  return true;
}

bool OpenFile::readAt(std::uint64_t from, char* into, size_t bytes) const {
  while (bytes > 0) {
    const ssize_t got = ::pread(file_, into, bytes, static_cast<off_t>(from));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    into += got;
    from += static_cast<std::uint64_t>(got);
    bytes -= static_cast<size_t>(got);
  }
  return true;
}

int OpenFile::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : EIO;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return 0;
}

int OpenFile::cut(std::uint64_t bytes) const {
  const auto end = static_cast<off_t>(bytes);
  return ::ftruncate(file_, end) == 0 && ::lseek(file_, end, SEEK_SET) == end ? 0 : errno;
}

int OpenFile::sync() const {
  return ::fdatasync(file_) == 0 || errno == EINVAL ? 0 : errno;
}

int OpenFile::lock() const {
  return ::flock(file_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
}

bool OpenFile::isLocked() const {
  return lock() == EWOULDBLOCK;
}

}  // namespace breakaway
