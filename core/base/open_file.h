// An open file that closes itself, with a lock and the disk behind it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace breakaway {

/// Functions that return a number give 0, or the system's reason (errno).
class OpenFile {
 public:
  /// `making`: there must be none yet.
  enum class Purpose { reading, mending, making };

  OpenFile(const std::string& path, Purpose purpose);
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  bool good() const { return file_ >= 0; }
  /// Why it could not be opened.
  int failed() const { return failed_; }
  /// In bytes; none where it is no file: a folder, a device, a pipe.
  std::optional<std::uint64_t> size() const;
  /// True: all of them. False: the file ends before, or can't be read.
  bool read(char* into, size_t bytes) const;
  /// The same from `from` on, wherever read() and write() stand.
  bool readAt(std::uint64_t from, char* into, size_t bytes) const;
  /// All of it; where that fails, a part may have been written.
  int write(std::string_view bytes) const;
  /// Leaves the first `bytes` of it and goes on behind them.
  int cut(std::uint64_t bytes) const;
  /// Puts what was written on the disk, as far as the file system does.
  int sync() const;
  /// Takes the file's one lock, without waiting, until it is closed.
  int lock() const;
  /// Whether another one holds the lock.
  bool isLocked() const;

 private:
  int file_ = -1;
  int failed_ = 0;
};

}  // namespace breakaway
