// What must hold of a log that was read, whatever its form.
#pragma once

#include "fuzz/fuzzed.h"
#include "recording/import/import.h"
#include "recording/import/read_table.h"

namespace breakaway::test {

/// A table that was read becomes a recording in our own form, or one line.
inline void requireSound(Result<ReadTable> read) {
  if (!read) return requireOneLine(read.error().message());
  for (const RawColumn& column : read->table.columns)
    require(column.channel.values.size() == read->table.rows(), "the file's columns are equally long");
  const auto imported = settleTable(std::move(read->table), {}, "log", read->newPart);
  if (!imported) return requireOneLine(imported.error().message());
  for (const auto& remark : imported->remarks) requireOneLine(Error{"", remark}.message());
  for (const auto& column : imported->columns)
    require(!column.from.empty() || !column.why.empty(), "each column is told");
  require(imported->recording.rows() > 0, "a recording has rows");
  for (const Channel& channel : imported->recording.channels())
    require(channel.values.size() == imported->recording.rows(), "columns are equally long");
}

inline void requireSound(Result<RawTable> read) {
  if (!read) return requireOneLine(read.error().message());
  requireSound(Result<ReadTable>(ReadTable{std::move(*read), {}}));
}

}  // namespace breakaway::test
