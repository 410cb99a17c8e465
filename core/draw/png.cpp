#include "draw/png.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

namespace breakaway {

namespace {

constexpr const char* program = "rsvg-convert";

/// The program's exit status, or the system's reason why it could not be run. What it prints leads nowhere.
Result<int> statusOf(std::vector<std::string> words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const int failed = posix_spawnp(&child, program, &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    return Error{program, std::string("cannot be run (package librsvg2-bin): ") + std::strerror(failed)};
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return Error{program, std::strerror(errno)};
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

}  // namespace

Result<void> convertToPng(const std::string& svgPath, const std::string& pngPath, double scale) {
  const std::string temporary = pngPath + ".part-" + std::to_string(getpid());
  const auto status = statusOf({program, "--format=png", "--background-color=#ffffff",
                                "--zoom=" + std::to_string(scale), "--output=" + temporary, "--", svgPath});
  if (!status || *status != 0) {
    std::remove(temporary.c_str());
    return status ? Error{svgPath, "cannot be drawn as PNG by rsvg-convert"} : status.error();
  }
  if (std::rename(temporary.c_str(), pngPath.c_str()) != 0) {
    const Error error{pngPath, std::string("cannot be written: ") + std::strerror(errno)};
    std::remove(temporary.c_str());
    return error;
  }
  return {};
}

Result<void> pngCanBeWritten() {
  const auto status = statusOf({program, "--version"});
  if (!status) return status.error();
  return *status == 0 ? Result<void>() : Error{program, "cannot be run (package librsvg2-bin)"};
}

}  // namespace breakaway
