// A project's lock: shared by those who put something in, alone for who clears away what a kill left.
#pragma once

#include <string>

namespace breakaway {

class ProjectLock {
 public:
  enum class Way { shared, alone };

  /// `shared` waits; `alone` is got at once or not.
  ProjectLock(const std::string& project, Way way);
  ~ProjectLock();
  ProjectLock(const ProjectLock&) = delete;
  ProjectLock& operator=(const ProjectLock&) = delete;

  bool held() const { return held_; }

 private:
  int file_ = -1;
  bool held_ = false;
};

}  // namespace breakaway
