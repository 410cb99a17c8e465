#include "recording/block_file.h"

#include <algorithm>
#include <array>

#include "base/open_file.h"
#include "recording/block_form.h"

namespace breakaway {

namespace {

/// Of one block: what a full disk or a damaged place costs at most beside itself.
constexpr size_t mostRows_bytes = size_t{1} << 16U;

/// How much lies between two heads at most: where the first one is damaged, another says what the columns are.
constexpr std::uint64_t headEvery_bytes = std::uint64_t{1} << 20U;

std::string_view asBytes(std::span<const double> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace

struct BlockWriter::State {
  explicit State(const std::string& at) : path(at), file(at, OpenFile::Purpose::making) {}

  std::string path;
  OpenFile file;
  std::string head;
  size_t width = 0;
  std::uint64_t bytes = 0, headAt = 0;  ///< written so far; where the last head begins

  Result<void> put(BlockKind kind, std::string_view content);
  Result<void> putHead();
};

/// All of it or, as far as the system lets it, nothing.
Result<void> BlockWriter::State::put(BlockKind kind, std::string_view content) {
  const std::string block = framed(kind, content);
  if (const int failed = file.write(block); failed != 0) {
    file.cut(bytes);
    return blockFileError(path, "cannot be written", failed);
  }
  bytes += block.size();
  return {};
}

Result<void> BlockWriter::State::putHead() {
  headAt = bytes;
  return put(BlockKind::head, head);
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
  if (!state->file.good()) return blockFileError(path, "cannot be written", state->file.failed());
  BlockWriter writer(std::move(state));
  if (const int failed = writer.state_->file.lock(); failed != 0)
    return blockFileError(path, "cannot be locked", failed);
  writer.state_->head = headText(head);
  if (auto put = writer.state_->putHead(); !put) return put.error();
  if (auto synced = writer.sync(); !synced) return synced.error();
  return writer;
}

Result<void> BlockWriter::append(std::span<const double> rows) {
  const size_t most = std::max<size_t>(1, mostRows_bytes / sizeof(double) / state_->width) * state_->width;
  while (!rows.empty()) {
    if (state_->bytes - state_->headAt > headEvery_bytes) {
      if (auto put = state_->putHead(); !put) return put;
    }
    const auto part = rows.first(std::min(rows.size(), most));
    if (auto put = state_->put(BlockKind::rows, asBytes(part)); !put) return put;
    rows = rows.subspan(part.size());
  }
  return {};
}

Result<void> BlockWriter::appendGap(const BlockGap& gap) {
  const std::array<double, 2> content{gap.after_s, static_cast<double>(gap.lost)};
  return state_->put(BlockKind::gap, asBytes(content));
}

Result<void> BlockWriter::sync() {
  if (const int failed = state_->file.sync(); failed != 0)
    return blockFileError(state_->path, "cannot be written", failed);
  return {};
}

Result<void> BlockWriter::end(const std::string& why) {
  if (auto put = state_->put(BlockKind::end, why); !put) return put;
  return sync();
}

const std::string& BlockWriter::path() const {
  return state_->path;
}

std::uint64_t BlockWriter::bytes() const {
  return state_->bytes;
}

}  // namespace breakaway
