// A file of whatever form as a raw table.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

struct ReadTable {
  RawTable table;
  std::vector<size_t> newPart;  ///< rows with which a further part begins whose clock is its own
};

/// Reads the file at `path`: its content tells what it is, not its name. Errors: what the readers say; a kind of file
/// that isn't read, with what converts it.
Result<ReadTable> readTable(const std::string& path);

/// The same from memory; `name` stands in errors.
Result<ReadTable> readTableBytes(std::string&& bytes, const std::string& name);

}  // namespace breakaway
