#include <bit>
#include <cmath>
#include <cstdint>

#include "fuzz/fuzzed.h"
#include "recording/csv.h"

using namespace breakaway;
using namespace breakaway::test;

/// What is read must be a sound recording, and must read back the same after it was written.
static const Fuzzed csv("csv", [](std::string_view bytes) {
  const auto read = readCsvText(bytes, "f.csv");
  if (!read) return requireOneLine(read.error().message());
  for (size_t k = 1; k < read->rows(); ++k) require(read->time()[k] > read->time()[k - 1], "time increases");
  const std::string path = fileWith("", "csv.csv");
  require(writeCsv(*read, path).ok(), "a recording can be written");
  const auto again = readCsv(path);
  require(again.ok() && again->rows() == read->rows(), "what was written reads back");
  for (const Channel& one : read->channels()) {
    require(one.values.size() == read->rows(), "columns are equally long");
    const auto values = again->channel(one.name);
    for (size_t k = 0; k < read->rows(); ++k) {
      require(std::isnan(one.values[k]) ? std::isnan(values[k])
                                        : std::bit_cast<uint64_t>(one.values[k]) == std::bit_cast<uint64_t>(values[k]),
              "values read back the same");
    }
  }
});
