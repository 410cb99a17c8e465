// How a block lies in its file: what stands before its content, and the checksum of both.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "recording/block_file.h"

namespace breakaway {

inline constexpr std::uint32_t blockMark = 0x424b5242;  // "BRKB"
inline constexpr std::uint32_t mostBlockContent = 1U << 28U;
enum class BlockKind : std::uint32_t { head = 1, rows = 2, gap = 3, end = 4 };

/// What stands before each block's content.
struct BlockFrame {
  std::uint32_t mark = blockMark, kind = 0, bytes = 0, checksum = 0;
};

/// CRC-32 of kind, length and `frame.bytes` bytes of content.
std::uint32_t checksumOf(const BlockFrame& frame, const char* content);

/// A block as it is written.
std::string framed(BlockKind kind, std::string_view content);

/// The head as lines: "column NAME" and "note KEY: VALUE".
std::string headText(const BlockHead& head);
/// What headText() gave; other lines are passed over.
BlockHead headOf(const std::string& text);

/// `number` is the system's (errno).
Error blockFileError(const std::string& path, const std::string& what, int number);

}  // namespace breakaway
