#include <algorithm>

#include "fuzz/fuzzed.h"
#include "motor/batch_list.h"

using namespace breakaway;
using namespace breakaway::test;

/// A batch's list, and the same text as its results.
static const Fuzzed batchList("batch_list", [](std::string_view bytes) {
  std::vector<std::string> lines;
  for (std::string_view rest = bytes; !rest.empty(); rest.remove_prefix(std::min(lines.back().size() + 1, rest.size())))
    lines.emplace_back(rest.substr(0, rest.find('\n')));
  if (const auto results = readBatchResults(lines, "r.jsonl"); !results) requireOneLine(results.error().message());
  const auto read = readBatchList(bytes, "lists/l.jsonl");
  if (!read) return requireOneLine(read.error().message());
  for (const BatchEntry& entry : *read)
    require(!entry.id.empty() && !entry.recordings.empty(), "an entry has an id and recordings");
});
