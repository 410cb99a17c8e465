#include "project/project_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace breakaway {

ProjectLock::ProjectLock(const std::string& project, Way way) {
  file_ = ::open((project + "/project.json").c_str(), O_RDONLY | O_CLOEXEC);
  held_ = file_ >= 0 && ::flock(file_, way == Way::shared ? LOCK_SH : LOCK_EX | LOCK_NB) == 0;
}

ProjectLock::~ProjectLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace breakaway
