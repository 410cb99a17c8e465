// A file that lives in memory, for libraries and programs that write files only.
#pragma once

#include <string>

namespace breakaway {

class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return file_; }
  /// A name under which this process can open it.
  std::string path() const;
  /// All that was written, from its beginning.
  std::string content() const;

 private:
  int file_;
};

}  // namespace breakaway
