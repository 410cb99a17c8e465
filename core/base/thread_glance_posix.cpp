#include "base/thread_glance.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <fstream>
#include <string>

namespace breakaway {

namespace {

std::ifstream factsOf(int thread, const char* name) {
  return std::ifstream("/proc/self/task/" + std::to_string(thread) + "/" + name);
}

}  // namespace

WatchedThread::WatchedThread() : thread_(static_cast<int>(::syscall(SYS_gettid))) {
}

std::optional<double> WatchedThread::ran_s() const {
  double ran_ns = 0.0;
  if (!(factsOf(thread_, "schedstat") >> ran_ns)) return std::nullopt;
  return 1e-9 * ran_ns;
}

std::optional<bool> WatchedThread::ready() const {
  std::string line;
  if (!std::getline(factsOf(thread_, "stat"), line)) return std::nullopt;
  const size_t name = line.rfind(") ");  // the name may hold anything
  if (name == std::string::npos || name + 2 >= line.size()) return std::nullopt;
  return line[name + 2] == 'R';
}

}  // namespace breakaway
