// What a file held, before its names and units were understood.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "recording/recording.h"

namespace breakaway {

struct RawColumn {
  Channel channel;             ///< name as in the file, values in the file's unit
  std::optional<Error> fault;  ///< the first cell that is text; an error only if the column is used
};

struct RawTable {
  std::vector<RawColumn> columns;  ///< all of the same length
  std::vector<std::pair<std::string, std::string>> notes;
  std::vector<std::string> remarks;  ///< what was left out or assumed, in words
};

}  // namespace breakaway
