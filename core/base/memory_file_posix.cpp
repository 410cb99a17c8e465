#include "base/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace breakaway {

MemoryFile::MemoryFile() : file_(::memfd_create("breakaway", MFD_CLOEXEC)), good_(file_ >= 0) {
}

MemoryFile::MemoryFile(std::string_view content) : MemoryFile() {
  while (good_ && !content.empty()) {
    const ssize_t written = ::write(file_, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    good_ = written > 0;
    if (good_) content.remove_prefix(static_cast<size_t>(written));
  }
}

MemoryFile::~MemoryFile() {
  if (file_ >= 0) ::close(file_);
}

std::string MemoryFile::path() const {
  return "/proc/self/fd/" + std::to_string(file_);
}

std::string MemoryFile::content() const {
  std::string bytes;
  std::array<char, 1 << 16> block;
  ssize_t got = 0;
  while ((got = ::pread(file_, block.data(), block.size(), static_cast<off_t>(bytes.size()))) > 0)
    bytes.append(block.data(), static_cast<size_t>(got));
  return bytes;
}

}  // namespace breakaway
