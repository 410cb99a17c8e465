#include "recording/block_form.h"

#include <zlib.h>

#include <bit>
#include <cstring>
#include <system_error>

namespace breakaway {

static_assert(std::endian::native == std::endian::little, "blocks are written as they lie in memory");

std::uint32_t checksumOf(const BlockFrame& frame, const char* content) {
  auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(&frame.kind), sizeof frame.kind + sizeof frame.bytes);
  if (frame.bytes > 0) sum = ::crc32(sum, reinterpret_cast<const Bytef*>(content), frame.bytes);
  return static_cast<std::uint32_t>(sum);
}

std::string framed(BlockKind kind, std::string_view content) {
  BlockFrame frame;
  frame.kind = static_cast<std::uint32_t>(kind);
  frame.bytes = static_cast<std::uint32_t>(content.size());
  frame.checksum = checksumOf(frame, content.data());
  std::string text(sizeof frame, '\0');
  std::memcpy(text.data(), &frame, sizeof frame);
  return text.append(content);
}

std::string headText(const BlockHead& head) {
  const auto line = [](std::string text) {
    for (char& c : text) c = c == '\n' || c == '\r' ? ' ' : c;
    return text + "\n";
  };
  std::string text;
  for (const std::string& column : head.columns) text += line("column " + column);
  for (const auto& [key, value] : head.notes) text += line("note " + key + ": " + value);
  return text;
}

BlockHead headOf(const std::string& text) {
  BlockHead head;
  size_t from = 0;
  for (size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', from)) {
    const std::string line = text.substr(from, end - from);
    from = end + 1;
    if (line.starts_with("column ")) head.columns.push_back(line.substr(7));
    const size_t colon = line.find(": ");
    if (line.starts_with("note ") && colon != std::string::npos)
      head.notes.emplace_back(line.substr(5, colon - 5), line.substr(colon + 2));
  }
  return head;
}

Error blockFileError(const std::string& path, const std::string& what, int number) {
  return {path, what + ": " + std::error_code(number, std::generic_category()).message()};
}

}  // namespace breakaway
