// Reads files of blocks: whatever lies between sound blocks is passed over and said.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include "base/open_file.h"
#include "recording/block_file.h"
#include "recording/block_form.h"

namespace breakaway {

namespace {

constexpr size_t firstLook_bytes = size_t{1} << 12U, mostLook_bytes = size_t{1} << 16U;  // at once, for the next mark
constexpr std::uint64_t firstMark_bytes = std::uint64_t{4} << 20U;  // within which a file of blocks has one

struct Block {
  BlockKind kind = BlockKind::head;
  std::vector<char> content;
};

/// Where the mark stands next, from `from` on and before `end`.
std::optional<std::uint64_t> nextMark(const OpenFile& file, std::uint64_t from, std::uint64_t end) {
  constexpr std::string_view mark = "BRKB";
  std::vector<char> part(firstLook_bytes);
  while (from + mark.size() <= end) {
    const auto bytes = static_cast<size_t>(std::min<std::uint64_t>(part.size(), end - from));
    if (!file.readAt(from, part.data(), bytes)) return std::nullopt;
    const size_t at = std::string_view(part.data(), bytes).find(mark);
    if (at != std::string_view::npos) return from + at;
    from += bytes - (mark.size() - 1);  // it may lie across
    part.resize(std::min(2 * part.size(), mostLook_bytes));
  }
  return std::nullopt;
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

std::uint64_t BlockSurvey::lost() const {
  std::uint64_t all = 0;
  for (const BlockGap& gap : gaps) all += gap.lost;
  return all;
}

std::uint64_t BlockSurvey::unreadable() const {
  std::uint64_t all = 0;
  for (const BlockHole& hole : holes) all += hole.bytes;
  return all;
}

struct BlockReader::State {
  explicit State(const std::string& path) : file(path, OpenFile::Purpose::reading) {}

  OpenFile file;
  std::uint64_t size = 0;
  std::uint64_t spare = 0;  ///< bytes that may be read in vain, so that no file of mere marks keeps us for ever
  Block block;
  BlockSurvey survey;

  void spend(std::uint64_t bytes) { spare -= std::min(spare, bytes); }
  bool take(std::uint64_t at);
  bool step();
  void begin(BlockHead head);
  void takeGap();
};

/// The block that begins there, whole and with the right checksum.
bool BlockReader::State::take(std::uint64_t at) {
  BlockFrame frame;
  if (size - at < sizeof frame || !file.readAt(at, reinterpret_cast<char*>(&frame), sizeof frame)) return false;
  const bool possible = frame.mark == blockMark && frame.kind >= static_cast<std::uint32_t>(BlockKind::head) &&
                        frame.kind <= static_cast<std::uint32_t>(BlockKind::end) && frame.bytes <= mostBlockContent &&
                        frame.bytes <= size - at - sizeof frame;
  if (!possible) return false;
  block.content.resize(frame.bytes);
  const bool sound = file.readAt(at + sizeof frame, block.content.data(), frame.bytes) &&
                     frame.checksum == checksumOf(frame, block.content.data());
  if (!sound) spend(frame.bytes);
  block.kind = static_cast<BlockKind>(frame.kind);
  return sound;
}

/// The next sound block. What is damaged before it is noted; behind the last one it is what a kill left.
bool BlockReader::State::step() {
  if (survey.ended) return false;
  std::optional<std::uint64_t> at = survey.sound;
  while (at && !take(*at)) {
    spend(firstLook_bytes);
    at = spare > 0 ? nextMark(file, *at + 1, size) : std::nullopt;
  }
  if (!at) return false;
  if (*at > survey.sound) survey.holes.push_back({survey.last_s, *at - survey.sound});
  survey.sound = *at + sizeof(BlockFrame) + block.content.size();
  survey.damaged = size - survey.sound;
  return true;
}

void BlockReader::State::begin(BlockHead head) {
  spare = 4 * size + (std::uint64_t{64} << 20U);
  survey = {};
  survey.head = std::move(head);
}

void BlockReader::State::takeGap() {
  std::array<double, 2> gap{};
  if (block.content.size() != sizeof gap) return;
  std::memcpy(gap.data(), block.content.data(), sizeof gap);
  const bool good = std::isfinite(gap[0]) && gap[1] >= 0.0 && gap[1] < 1e15;
  if (good) survey.gaps.push_back({gap[0], static_cast<std::uint64_t>(gap[1])});
}

BlockReader::BlockReader(std::unique_ptr<State> state) : state_(std::move(state)) {
}
BlockReader::BlockReader(BlockReader&&) noexcept = default;
BlockReader& BlockReader::operator=(BlockReader&&) noexcept = default;
BlockReader::~BlockReader() = default;

Result<BlockReader> BlockReader::open(const std::string& path) {
  auto state = std::make_unique<State>(path);
  if (!state->file.good()) return blockFileError(path, "cannot be read", state->file.failed());
  const auto size = state->file.size();
  if (!size) return Error{path, "is no file"};
  if (!isBlockFile(path)) return Error{path, "doesn't begin as a recording of blocks"};
  state->size = *size;
  state->begin({});
  bool headed = false;  // by the first one that is sound: all are the same
  while (!headed && state->step()) headed = state->block.kind == BlockKind::head;
  if (!headed) return Error{path, "has no head that is whole, which names its columns"};
  BlockHead head = headOf({state->block.content.begin(), state->block.content.end()});
  if (head.columns.empty() || head.columns.front() != "time_s") return Error{path, "has no column time_s in front"};
  state->begin(std::move(head));
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
  if (!file.good() || !file.readAt(0, reinterpret_cast<char*>(&found), sizeof found)) return false;
  if (found == blockMark) return true;
  // Its beginning may be damaged.
  return path.ends_with(".blocks") && nextMark(file, 0, std::min(file.size().value_or(0), firstMark_bytes)).has_value();
}

bool isBeingWritten(const std::string& path) {
  const OpenFile file(path, OpenFile::Purpose::reading);
  return file.good() && file.isLocked();
}

Result<BlockSurvey> mendBlocks(const std::string& path, const std::string& why) {
  const OpenFile file(path, OpenFile::Purpose::mending);
  if (!file.good()) return blockFileError(path, "cannot be mended", file.failed());
  if (file.lock() != 0) return Error{path, "is being written"};
  auto survey = surveyBlocks(path);
  if (!survey || survey->ended) return survey;
  int failed = file.cut(survey->sound);
  if (failed == 0) failed = file.write(framed(BlockKind::end, why));
  if (failed == 0) failed = file.sync();
  if (failed != 0) return blockFileError(path, "cannot be mended", failed);
  survey->why = why;
  return survey;
}

}  // namespace breakaway
