#include "recording/block_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "base/open_file.h"

namespace breakaway {

static_assert(std::endian::native == std::endian::little, "blocks are written as they lie in memory");

namespace {

constexpr std::uint32_t mark = 0x424b5242;  // "BRKB"
constexpr std::uint32_t mostPayload = 1U << 28U;
enum class BlockKind : std::uint32_t { head = 1, rows = 2, gap = 3, end = 4 };

/// What stands before each block's content.
struct Frame {
  std::uint32_t mark = breakaway::mark, kind = 0, bytes = 0, checksum = 0;
};

std::uint32_t checksumOf(const Frame& frame, const char* content) {
  auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(&frame.kind), sizeof frame.kind + sizeof frame.bytes);
  return static_cast<std::uint32_t>(::crc32(sum, reinterpret_cast<const Bytef*>(content), frame.bytes));
}

std::string framed(BlockKind kind, const char* content, size_t bytes) {
  Frame frame;
  frame.kind = static_cast<std::uint32_t>(kind);
  frame.bytes = static_cast<std::uint32_t>(bytes);
  frame.checksum = checksumOf(frame, content);
  std::string text(sizeof frame + bytes, '\0');
  std::memcpy(text.data(), &frame, sizeof frame);
  if (bytes > 0) std::memcpy(text.data() + sizeof frame, content, bytes);
  return text;
}

Error systemError(const std::string& path, const std::string& what, int number) {
  return {path, what + ": " + std::error_code(number, std::generic_category()).message()};
}

/// The head as lines: "column NAME" and "note KEY: VALUE".
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

struct Block {
  BlockKind kind = BlockKind::head;
  std::vector<char> content;
};

/// The next block, whole and with the right checksum; false at the end of what is sound.
bool nextBlock(const OpenFile& file, std::uint64_t left, Block& block) {
  Frame frame;
  if (left < sizeof frame || !file.read(reinterpret_cast<char*>(&frame), sizeof frame)) return false;
  if (frame.mark != mark || frame.bytes > mostPayload || frame.bytes > left - sizeof frame) return false;
  block.content.resize(frame.bytes);
  if (!file.read(block.content.data(), frame.bytes)) return false;
  block.kind = static_cast<BlockKind>(frame.kind);
  return frame.checksum == checksumOf(frame, block.content.data());
}

/// Leaves out rows whose time doesn't grow, which no recording may have.
void takeRows(const Block& block, BlockSurvey& survey, std::vector<double>& rows) {
  const size_t width = survey.head.columns.size();
  rows.resize(block.content.size() / sizeof(double));
  if (!rows.empty()) std::memcpy(rows.data(), block.content.data(), rows.size() * sizeof(double));
  size_t kept = 0;
  for (size_t k = 0; k + width <= rows.size(); k += width) {
    const double time_s = rows[k];
    if (!std::isfinite(time_s) || (survey.rows > 0 && time_s <= survey.last_s)) {
      ++survey.repeated;
      continue;
    }
    if (survey.rows++ == 0) survey.first_s = time_s;
    survey.last_s = time_s;
    if (kept != k)
      std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(k), width,
                  rows.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += width;
  }
  rows.resize(kept);
}

}  // namespace

struct BlockWriter::State {
  explicit State(const std::string& at) : path(at), file(at, OpenFile::Purpose::making) {}

  std::string path;
  OpenFile file;
  size_t width = 0;
  std::uint64_t bytes = 0;

  Result<void> put(BlockKind kind, const char* content, size_t size);
};

/// All of it or, as far as the system lets it, nothing.
Result<void> BlockWriter::State::put(BlockKind kind, const char* content, size_t size) {
  const std::string block = framed(kind, content, size);
  if (const int failed = file.write(block); failed != 0) {
    file.cut(bytes);
    return systemError(path, "cannot be written", failed);
  }
  bytes += block.size();
  return {};
}

BlockWriter::BlockWriter(std::unique_ptr<State> state) : state_(std::move(state)) {
}
BlockWriter::BlockWriter(BlockWriter&&) noexcept = default;
BlockWriter& BlockWriter::operator=(BlockWriter&&) noexcept = default;

BlockWriter::~BlockWriter() = default;

Result<BlockWriter> BlockWriter::create(const std::string& path, const BlockHead& head) {
  if (head.columns.empty() || head.columns.front() != "time_s")
    return Error{path, "a recording's first column is not time_s"};
  auto state = std::make_unique<State>(path);
  state->width = head.columns.size();
  if (!state->file.good()) return systemError(path, "cannot be written", state->file.failed());
  BlockWriter writer(std::move(state));
  if (const int failed = writer.state_->file.lock(); failed != 0) return systemError(path, "cannot be locked", failed);
  const std::string text = headText(head);
  if (auto put = writer.state_->put(BlockKind::head, text.data(), text.size()); !put) return put.error();
  if (auto synced = writer.sync(); !synced) return synced.error();
  return writer;
}

Result<void> BlockWriter::append(std::span<const double> rows) {
  const size_t most = mostPayload / sizeof(double) / state_->width * state_->width / 16;
  while (!rows.empty()) {
    const auto part = rows.first(std::min(rows.size(), most));
    if (auto put = state_->put(BlockKind::rows, reinterpret_cast<const char*>(part.data()), part.size_bytes()); !put)
      return put;
    rows = rows.subspan(part.size());
  }
  return {};
}

Result<void> BlockWriter::appendGap(const BlockGap& gap) {
  const std::array<double, 2> content{gap.after_s, static_cast<double>(gap.lost)};
  return state_->put(BlockKind::gap, reinterpret_cast<const char*>(content.data()), sizeof content);
}

Result<void> BlockWriter::sync() {
  if (const int failed = state_->file.sync(); failed != 0)
    return systemError(state_->path, "cannot be written", failed);
  return {};
}

Result<void> BlockWriter::end(const std::string& why) {
  if (auto put = state_->put(BlockKind::end, why.data(), why.size()); !put) return put;
  return sync();
}

const std::string& BlockWriter::path() const {
  return state_->path;
}

std::uint64_t BlockWriter::bytes() const {
  return state_->bytes;
}

std::uint64_t BlockSurvey::lost() const {
  std::uint64_t all = 0;
  for (const BlockGap& gap : gaps) all += gap.lost;
  return all;
}

struct BlockReader::State {
  explicit State(const std::string& path) : file(path, OpenFile::Purpose::reading) {}

  OpenFile file;
  std::uint64_t size = 0;
  Block block;
  BlockSurvey survey;

  bool step() {
    if (survey.ended || !nextBlock(file, size - survey.sound, block)) return false;
    survey.sound += sizeof(Frame) + block.content.size();
    survey.damaged = size - survey.sound;
    return true;
  }
  void takeGap() {
    std::array<double, 2> gap{};
    if (block.content.size() != sizeof gap) return;
    std::memcpy(gap.data(), block.content.data(), sizeof gap);
    const bool good = std::isfinite(gap[0]) && gap[1] >= 0.0 && gap[1] < 1e15;
    if (good) survey.gaps.push_back({gap[0], static_cast<std::uint64_t>(gap[1])});
  }
};

BlockReader::BlockReader(std::unique_ptr<State> state) : state_(std::move(state)) {
}
BlockReader::BlockReader(BlockReader&&) noexcept = default;
BlockReader& BlockReader::operator=(BlockReader&&) noexcept = default;
BlockReader::~BlockReader() = default;

Result<BlockReader> BlockReader::open(const std::string& path) {
  auto state = std::make_unique<State>(path);
  if (!state->file.good()) return systemError(path, "cannot be read", state->file.failed());
  const auto size = state->file.size();
  if (!size) return Error{path, "is no file"};
  state->size = *size;
  if (!state->step() || state->block.kind != BlockKind::head)
    return Error{path, "doesn't begin as a recording of blocks"};
  state->survey.head = headOf({state->block.content.begin(), state->block.content.end()});
  const auto& columns = state->survey.head.columns;
  if (columns.empty() || columns.front() != "time_s") return Error{path, "has no column time_s in front"};
  return BlockReader(std::move(state));
}

bool BlockReader::next(std::vector<double>& rows) {
  State& state = *state_;
  while (state.step()) {
    if (state.block.kind == BlockKind::rows) {
      takeRows(state.block, state.survey, rows);
      if (!rows.empty()) return true;
    } else if (state.block.kind == BlockKind::gap) {
      state.takeGap();
    } else if (state.block.kind == BlockKind::end) {
      state.survey.ended = true;
      state.survey.why.assign(state.block.content.begin(), state.block.content.end());
    }
  }
  return false;
}

const BlockSurvey& BlockReader::survey() const {
  return state_->survey;
}

Result<BlockSurvey> surveyBlocks(const std::string& path) {
  auto reader = BlockReader::open(path);
  if (!reader) return reader.error();
  std::vector<double> rows;
  while (reader->next(rows)) continue;
  return reader->survey();
}

bool isBlockFile(const std::string& path) {
  // A FIFO is opened once, by who reads it: one that opens and closes it before ends who writes into it.
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return false;
  const OpenFile file(path, OpenFile::Purpose::reading);
  std::uint32_t found = 0;
  return file.good() && file.read(reinterpret_cast<char*>(&found), sizeof found) && found == mark;
}

bool isBeingWritten(const std::string& path) {
  const OpenFile file(path, OpenFile::Purpose::reading);
  return file.good() && file.isLocked();
}

Result<BlockSurvey> mendBlocks(const std::string& path, const std::string& why) {
  const OpenFile file(path, OpenFile::Purpose::mending);
  if (!file.good()) return systemError(path, "cannot be mended", file.failed());
  if (file.lock() != 0) return Error{path, "is being written"};
  auto survey = surveyBlocks(path);
  if (!survey || survey->ended) return survey;
  int failed = file.cut(survey->sound);
  if (failed == 0) failed = file.write(framed(BlockKind::end, why.data(), why.size()));
  if (failed == 0) failed = file.sync();
  if (failed != 0) return systemError(path, "cannot be mended", failed);
  survey->why = why;
  return survey;
}

}  // namespace breakaway
