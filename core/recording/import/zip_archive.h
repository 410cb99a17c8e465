// Members of a zip archive in memory.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace breakaway {

bool isZip(std::string_view bytes);

/// Reads members of the archive in `bytes`, which must live as long.
class ZipArchive {
 public:
  /// Error, at `name`: damaged.
  static Result<ZipArchive> open(std::string_view bytes, const std::string& name);
  ZipArchive(ZipArchive&& other) noexcept;
  ZipArchive& operator=(ZipArchive&&) = delete;
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;
  ~ZipArchive();

  std::vector<std::string> members() const;
  bool has(const std::string& member) const;
  /// Errors: no such member, damaged, encrypted, more than 1 GB with all that was read before.
  Result<std::string> read(const std::string& member) const;

 private:
  ZipArchive(void* archive, std::string name) : archive_(archive), name_(std::move(name)) {}
  void* archive_;
  std::string name_;
  mutable size_t unpacked_ = 0;  ///< bytes so far
};

}  // namespace breakaway
