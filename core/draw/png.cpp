#include "draw/png.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/atomic_file.h"
#include "base/made.h"
#include "base/memory_file.h"

namespace breakaway {

namespace {

constexpr const char* program = "rsvg-convert";

/// The program's exit status, or the system's reason why it could not be run. What it prints goes to `out`.
Result<int> statusOf(std::vector<std::string> words, const MemoryFile& out) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
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

/// An iTXt chunk (PNG, third edition, 11.3.3.4): `text` in UTF-8, not packed, under `keyword`.
std::string textChunk(const std::string& keyword, const std::string& text) {
  const auto bytesOf = [](std::uint32_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> static_cast<unsigned>(shift));
    return bytes;
  };
  const std::string named = "iTXt" + keyword + std::string(5, '\0') + text;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(named.data()), static_cast<uInt>(named.size()));
  return bytesOf(static_cast<std::uint32_t>(named.size() - 4)) + named + bytesOf(static_cast<std::uint32_t>(sum));
}

/// The picture for `path`, with where it comes from under the keyword `made`.
Result<std::string> pictureWithMade(std::string png, const std::string& path) {
  constexpr size_t afterHeader = 8 + 25;  // signature and IHDR
  if (png.size() < afterHeader) return Error{path, "is no whole PNG"};
  png.insert(afterHeader, textChunk("made", madeJson()));
  return png;
}

}  // namespace

Result<void> convertToPng(const std::string& svgPath, const std::string& pngPath, double scale) {
  const MemoryFile drawn;
  const auto status = statusOf(
      {program, "--format=png", "--background-color=#ffffff", "--zoom=" + std::to_string(scale), "--", svgPath}, drawn);
  if (!status) return status.error();
  if (*status != 0) return Error{svgPath, "cannot be drawn as PNG by rsvg-convert"};
  const auto picture = pictureWithMade(drawn.content(), pngPath);
  return picture ? writeFile(pngPath, *picture) : picture.error();
}

Result<void> pngCanBeWritten() {
  const auto status = statusOf({program, "--version"}, MemoryFile());
  if (!status) return status.error();
  return *status == 0 ? Result<void>() : Error{program, "cannot be run (package librsvg2-bin)"};
}

}  // namespace breakaway
