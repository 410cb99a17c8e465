// What the technician says about a log: it comes before any guess.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// One column: value = scale × old value + offset, under the name `to`; or its unit, instead of scale and offset.
struct ColumnRule {
  std::string to;
  double scale = 1.0;
  double offset = 0.0;
  std::string unit = {};  ///< may need counts_per_rev or pole_pairs
};

struct ImportMap {
  std::map<std::string, ColumnRule> columns;  ///< by the column's name in the file
  std::optional<double> sample_time_s;        ///< rows are this far apart; no column is the time
  std::optional<double> counts_per_rev;       ///< for columns that count
  std::optional<double> pole_pairs;           ///< for columns that speak of electrical turns
  std::optional<double> gear_ratio;           ///< motor turns per turn of what was measured
  std::string integrate;                      ///< the column, in the file, of which the angle is made
  std::string differentiate;                  ///< the column of which the speed is made
  std::vector<std::string> join;              ///< further files, beside the first, that go on where it ends
  std::string split;                          ///< the column whose values part the log
  std::map<std::string, double> sign;         ///< −1 turns a column, by its name in the file or in the recording

  bool empty() const;
};

/// The map as readImportMapText() reads it.
std::string importMapText(const ImportMap& map);

Result<ImportMap> readImportMap(const std::string& path);
Result<ImportMap> readImportMapText(const std::string& text, const std::string& place);

}  // namespace breakaway
