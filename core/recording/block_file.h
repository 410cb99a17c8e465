// A recording on disk while it runs: blocks that are only ever appended, each with its checksum. Whatever ends the
// writing, what was written before can be read.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "recording/recording.h"

namespace breakaway {

/// What stands at the beginning: column names, `time_s` the first, and the `key: value` notes of a recording.
struct BlockHead {
  std::vector<std::string> columns;
  std::vector<std::pair<std::string, std::string>> notes;
};

/// Samples that were lost on the way.
struct BlockGap {
  double after_s = 0.0;  ///< the last row's time before them
  std::uint64_t lost = 0;
};

/// Bytes that can't be read, between blocks that can: a disk's fault, say.
struct BlockHole {
  double after_s = 0.0;  ///< the last row's time before them
  std::uint64_t bytes = 0;
};

/// Appends to one file, which others may read meanwhile. Numbers are little-endian.
class BlockWriter {
 public:
  /// Creates the file, locks it and writes the head. Errors: it is there already, the disk is full.
  static Result<BlockWriter> create(const std::string& path, const BlockHead& head);
  BlockWriter(BlockWriter&&) noexcept;
  BlockWriter& operator=(BlockWriter&&) noexcept;
  ~BlockWriter();

  /// Rows one after the other, each as wide as the head. After an error those that the disk had room for are there.
  Result<void> append(std::span<const double> rows);
  Result<void> appendGap(const BlockGap& gap);
  /// To the disk itself, which a loss of power needs; a killed process leaves what was appended.
  Result<void> sync();
  /// The last block; `why`: what ended the recording, empty if somebody did.
  Result<void> end(const std::string& why);
  const std::string& path() const;
  std::uint64_t bytes() const;

 private:
  struct State;
  explicit BlockWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// What a file of blocks holds, without its rows.
struct BlockSurvey {
  BlockHead head;
  std::uint64_t rows = 0;
  double first_s = 0.0, last_s = 0.0;
  std::vector<BlockGap> gaps;
  std::vector<BlockHole> holes;
  bool ended = false;          ///< with its last block
  std::string why;             ///< what the last block says
  std::uint64_t sound = 0;     ///< bytes up to the end of the last block that is whole
  std::uint64_t damaged = 0;   ///< bytes behind them
  std::uint64_t repeated = 0;  ///< rows whose time doesn't grow: they are left out by the readers

  std::uint64_t lost() const;
  /// Bytes of all holes.
  std::uint64_t unreadable() const;
};

/// Goes through a file block by block, also while it grows: up to where it ended at the opening. Damage is passed over,
/// up to the next block that is whole.
class BlockReader {
 public:
  /// Errors: it can't be read, or doesn't begin as such a file.
  static Result<BlockReader> open(const std::string& path);
  BlockReader(BlockReader&&) noexcept;
  BlockReader& operator=(BlockReader&&) noexcept;
  ~BlockReader();

  /// The rows of the next block that has some, one after the other; false at the end.
  bool next(std::vector<double>& rows);
  /// What was met so far.
  const BlockSurvey& survey() const;

 private:
  struct State;
  explicit BlockReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// What is in the file, read to its end. Errors: BlockReader::open()'s.
Result<BlockSurvey> surveyBlocks(const std::string& path);

/// Whether a file is one of blocks, by its beginning; one of that name also by what follows.
bool isBlockFile(const std::string& path);

/// Whether somebody writes into it now.
bool isBeingWritten(const std::string& path);

/// Cuts away what a kill left half written at its end and appends the last block, with `why`. Errors: it is being
/// written, or isn't of blocks.
Result<BlockSurvey> mendBlocks(const std::string& path, const std::string& why);

/// The recording in memory. Gaps, and how it ended, are in its notes.
Result<Recording> readBlocks(const std::string& path);

/// A recording in either form, of blocks or as CSV; an input of the run (base/made.h).
Result<Recording> readRecording(const std::string& path);

/// A file of blocks as CSV, with flat memory however long it is. Errors: it holds no sample, `csv` can't be written.
Result<void> writeBlocksAsCsv(const std::string& path, const std::string& csv);

}  // namespace breakaway
