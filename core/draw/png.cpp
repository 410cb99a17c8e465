#include "draw/png.h"

#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/made.h"
#include "base/memory_file.h"
#include "base/subprocess.h"

namespace breakaway {

namespace {

constexpr const char* program = "rsvg-convert";

/// The program's exit status.
Result<int> statusOf(const std::vector<std::string>& options, const MemoryFile& out) {
  std::vector<std::string> words{program};
  words.insert(words.end(), options.begin(), options.end());
  auto status = runProgram(std::move(words), out);
  if (!status) return Error{program, status.error().fact + " (package librsvg2-bin)"};
  return status;
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
  const auto status =
      statusOf({"--format=png", "--background-color=#ffffff", "--zoom=" + std::to_string(scale), "--", svgPath}, drawn);
  if (!status) return status.error();
  if (*status != 0) return Error{svgPath, "cannot be drawn as PNG by rsvg-convert"};
  const auto picture = pictureWithMade(drawn.content(), pngPath);
  return picture ? writeFile(pngPath, *picture) : picture.error();
}

Result<void> pngCanBeWritten() {
  const auto status = statusOf({"--version"}, MemoryFile());
  if (!status) return status.error();
  return *status == 0 ? Result<void>() : Error{program, "cannot be run (package librsvg2-bin)"};
}

}  // namespace breakaway
