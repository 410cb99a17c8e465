// The entries of a batch: which are to be done, and doing them.
#pragma once

#include <string>
#include <vector>

#include "base/line_log.h"
#include "base/result.h"
#include "motor/batch_list.h"

namespace breakaway::cli {

/// What is done how.
struct BatchPlan {
  std::vector<const BatchEntry*> todo;
  std::string out;      ///< the file of results; reports lead from its folder
  std::string reports;  ///< folder for a report of each entry; empty: none
  size_t jobs = 1;      ///< entries done at the same time
};

/// What earlier results are worth today.
struct EarlierResults {
  std::vector<BatchEntry const*> todo;  ///< entries of the shard without a result that holds
  std::vector<std::string> kept;        ///< lines that hold, as they are
  size_t stale = 0;                     ///< lines left out of them: their inputs have changed
  size_t unchecked = 0;                 ///< entries whose inputs can't be read any more: their results are kept
};

/// Holds lines of results against the entries' files as they are now. Error, by line of `path`: no result.
Result<EarlierResults> checkEarlier(const std::vector<std::string>& lines, const std::string& path,
                                    const std::vector<const BatchEntry*>& entries);

/// Does the plan's entries, each one's line appended when it is done. Error: of the results, which ends it.
Result<void> doEntries(const BatchPlan& plan, const OwnLineLog& results);

/// The folder of an entry's report within the folder of all: its id where that is a plain name, else what is left of
/// it with a part of its hash. `id` as JSON.
std::string reportFolderOf(const std::string& id);

}  // namespace breakaway::cli
