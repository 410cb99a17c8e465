#include "base/contained.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace breakaway {

namespace {

bool writeAll(int file, const char* data, size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(file, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    data += written;
    size -= static_cast<size_t>(written);
  }
  return true;
}

/// Bytes of address space that this process has taken already.
[[maybe_unused]] size_t addressSpace() {
  size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<size_t>(::sysconf(_SC_PAGESIZE));
}

/// Whatever handles this process's signals is not for the child: after damage in a library a handler that allocates
/// may wait for ever.
void forgetHandlers() {
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// The child's whole life: its length and then its bytes go down the pipe.
[[noreturn]] void beTheChild(const std::function<std::string()>& work, int pipe, const ContainedLimits& limits) {
  forgetHandlers();
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  const rlimit computing{limits.computing_s, limits.computing_s}, core{0, 0};
  ::setrlimit(RLIMIT_CPU, &computing);
  ::setrlimit(RLIMIT_CORE, &core);
  ::alarm(4 * limits.computing_s);  // and where it only waits
#ifndef __SANITIZE_ADDRESS__        // whose shadow alone needs more
  const rlim_t most = addressSpace() + limits.memory_bytes;
  const rlimit memory{most, most};
  ::setrlimit(RLIMIT_AS, &memory);
#endif
  bool done = false;
  try {
    const std::string bytes = work();
    const uint64_t size = bytes.size();
    done =
        writeAll(pipe, reinterpret_cast<const char*>(&size), sizeof size) && writeAll(pipe, bytes.data(), bytes.size());
  } catch (...) {
    done = false;
  }
  ::_exit(done ? 0 : 1);
}

std::string readAll(int file) {
  std::string bytes;
  std::array<char, 1 << 16> block;
  while (true) {
    const ssize_t got = ::read(file, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return bytes;
    bytes.append(block.data(), static_cast<size_t>(got));
  }
}

}  // namespace

Result<std::string> runContained(const std::function<std::string()>& work, const std::string& place,
                                 const ContainedLimits& limits) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    return Error{place, std::string("no pipe to read it through: ") + std::strerror(errno)};
  const pid_t child = ::fork();
  if (child < 0) {
    ::close(ends[0]);
    ::close(ends[1]);
    return Error{place, std::string("no process to read it in: ") + std::strerror(errno)};
  }
  if (child == 0) beTheChild(work, ends[1], limits);
  ::close(ends[1]);
  std::string bytes = readAll(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  uint64_t size = 0;
  if (bytes.size() >= sizeof size) std::memcpy(&size, bytes.data(), sizeof size);
  if (bytes.size() < sizeof size || bytes.size() - sizeof size != size)
    return Error{place, "is damaged, reading it ended early"};
  return bytes.substr(sizeof size);
}

}  // namespace breakaway
