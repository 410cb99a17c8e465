// A file that lives in memory, for libraries and programs that know files only.
#pragma once

#include <string>
#include <string_view>

namespace breakaway {

class MemoryFile {
 public:
  MemoryFile();
  /// One that holds `content`.
  explicit MemoryFile(std::string_view content);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// Whether the system gave the file, with all that it should hold.
  bool good() const { return good_; }
  int descriptor() const { return file_; }
  /// A name under which this process can open it.
  std::string path() const;
  /// All that was written, from its beginning.
  std::string content() const;

 private:
  int file_;
  bool good_;
};

}  // namespace breakaway
