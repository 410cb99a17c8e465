#include "base/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <array>

namespace breakaway {

MemoryFile::MemoryFile() : file_(::memfd_create("breakaway", MFD_CLOEXEC)) {
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
