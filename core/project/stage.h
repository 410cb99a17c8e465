// Where a run's folder is made before it is put in place whole: a kill leaves no half of it among the runs.
#pragma once

#include <cstddef>
#include <string>

#include "base/result.h"

namespace breakaway {

/// A folder of its own in the project, removed unless it was put in place.
class Stage {
 public:
  explicit Stage(const std::string& project);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  const std::string& path() const { return path_; }
  Result<void> make();
  /// On disk, and then under its name.
  Result<void> place(const std::string& at);

 private:
  std::string path_;
  bool placed_ = false;
};

/// Removes the stages that kills have left; how many. Precondition: nobody else puts something in.
size_t clearStages(const std::string& project);

}  // namespace breakaway
