// The list of a batch and its results: one JSON object a line (resources/help/commands.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"

namespace breakaway {

struct BatchEntry {
  std::string id;  ///< as JSON: a text in quotes, or a number
  std::string bench;
  std::vector<std::string> recordings, heldout;
  std::vector<std::pair<std::string, std::string>> further;  ///< other fields that a result carries: name, JSON

  /// All that it rests on, in the order in which it is read, each once.
  std::vector<std::string> files() const;
};

/// All entries of the list's text; relative file names count from the folder of `path`, which stands in errors. Errors,
/// by line and field: no JSON, an id that is missing or there twice, no bench, no recordings.
Result<std::vector<BatchEntry>> readBatchList(std::string_view text, const std::string& path);

/// A line of results.
struct BatchResult {
  std::string id;  ///< as BatchEntry::id
  /// SHA-256 of each of the entry's files as it was then, in the order of files(), empty for one that couldn't be read;
  /// nothing where the line doesn't say, as an error's of earlier versions.
  std::optional<std::vector<std::string>> inputs;

  /// Whether the entry's files aren't what it rests on; `today` as `inputs`. A file that can't be read today, but could
  /// then, says nothing.
  bool isStale(const std::vector<std::string>& today) const;
  /// Whether one of them could be read then, but not today.
  bool restsOnGone(const std::vector<std::string>& today) const;
};

/// Reads lines of results. Errors, by line of `path`: no result, a diagnosis in another form (of a later version).
Result<std::vector<BatchResult>> readBatchResults(const std::vector<std::string>& lines, const std::string& path);

}  // namespace breakaway
