#include "base/file_status.h"

#include <sys/stat.h>
#include <unistd.h>

namespace breakaway {

std::string stampOfFile(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return {};
  std::string nanoseconds = std::to_string(status.st_mtim.tv_nsec);
  nanoseconds.insert(0, 9 - nanoseconds.size(), '0');
  return std::to_string(status.st_mtim.tv_sec) + "." + nanoseconds + " " + std::to_string(status.st_size) + " " +
         std::to_string(status.st_ino);
}

bool mayBeWritten(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return false;
  return ::access(path.c_str(), S_ISDIR(status.st_mode) ? W_OK | X_OK : W_OK) == 0;
}

}  // namespace breakaway
