// The parts of a recording as CSV, for those who write it row by row.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace breakaway {

/// The `# key: value` lines and the header line.
std::string csvHead(const std::vector<std::pair<std::string, std::string>>& notes,
                    const std::vector<std::string>& columns);

/// One row with the shortest text that reads back to the same doubles; NaN is an empty cell.
void appendCsvRow(std::string& text, std::span<const double> row);

}  // namespace breakaway
