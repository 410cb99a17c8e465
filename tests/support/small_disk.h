// A disk of a few kilobytes, for what happens when it is full.
#pragma once

#include <cstddef>
#include <string>

namespace breakaway::test {

/// Gives this process mounts of its own, which vanish with it. To be called before there is a second thread. False: the
/// system doesn't allow it.
bool takeOwnMounts();

/// A file system in memory, mounted on a folder as long as this lives.
class SmallDisk {
 public:
  /// Precondition: takeOwnMounts(). Sizes are rounded up to whole pages.
  SmallDisk(std::string folder, std::size_t bytes);
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk();

  bool mounted() const { return mounted_; }

 private:
  std::string folder_;
  bool mounted_;
};

}  // namespace breakaway::test
