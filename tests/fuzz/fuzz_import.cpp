#include "fuzz/fuzzed.h"
#include "recording/csv.h"
#include "recording/import/import.h"
#include "recording/import/read_table.h"

using namespace breakaway;
using namespace breakaway::test;

/// What import makes of anything must be a recording in our own form.
static const Fuzzed import("import", [](std::string_view bytes) {
  if (bytes.starts_with("MATLAB ") || bytes.starts_with("\x89HDF")) return;  // fuzz_mat's
  auto table = readTableBytes(std::string(bytes), "log");
  if (!table) return requireOneLine(table.error().message());
  const auto imported = settleTable(std::move(table->table), {}, "log", table->newPart);
  if (!imported) return requireOneLine(imported.error().message());
  for (const auto& remark : imported->remarks) requireOneLine(Error{"", remark}.message());
  for (const auto& column : imported->columns)
    require(!column.from.empty() || !column.why.empty(), "each column is told");
  require(imported->recording.rows() > 0, "a recording has rows");
  for (const Channel& channel : imported->recording.channels())
    require(channel.values.size() == imported->recording.rows(), "columns are equally long");
});
