#include "fuzz/fuzzed.h"
#include "recording/csv.h"
#include "recording/import.h"

using namespace breakaway;
using namespace breakaway::test;

/// What import makes of anything must be a recording in our own form.
static const Fuzzed import("import", [](std::string_view bytes) {
  if (bytes.starts_with("MATLAB ") || bytes.starts_with("\x89HDF")) return;  // fuzz_mat's
  const auto imported = importRecording(fileWith(bytes, "log.txt"));
  if (!imported) return requireOneLine(imported.error().message());
  for (const auto& remark : imported->remarks) requireOneLine(remark);
  const std::string path = fileWith("", "imported.csv");
  require(writeCsv(imported->recording, path).ok(), "a recording can be written");
  const auto again = readCsv(path);
  require(again.ok() && again->rows() == imported->recording.rows(), "what was imported reads as a recording");
  require(again->channels().size() == imported->recording.channels().size(), "every column reads back");
});
