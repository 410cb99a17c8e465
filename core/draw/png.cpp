#include "draw/png.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "base/atomic_file.h"
#include "base/made.h"

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

/// The picture at `path`, with where it comes from under the keyword `made`.
Result<std::string> pictureWithMade(const std::string& path) {
  const std::string chunk = textChunk("made", madeJson());
  const OwnInputs ours;  // the picture is no input
  auto png = readFile(path);
  constexpr size_t afterHeader = 8 + 25;  // signature and IHDR
  if (png && png->size() < afterHeader) return Error{path, "is no whole PNG"};
  if (png) png->insert(afterHeader, chunk);
  return png;
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
  const auto picture = pictureWithMade(temporary);
  std::remove(temporary.c_str());
  return picture ? writeFile(pngPath, *picture) : picture.error();
}

Result<void> pngCanBeWritten() {
  const auto status = statusOf({program, "--version"});
  if (!status) return status.error();
  return *status == 0 ? Result<void>() : Error{program, "cannot be run (package librsvg2-bin)"};
}

}  // namespace breakaway
