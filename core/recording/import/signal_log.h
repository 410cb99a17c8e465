// Logs that have one value per entry, each with its own stamp, as a table.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// A stamp in two parts, so that 19 digits lose nothing.
struct Stamp {
  int64_t whole = 0;
  double rest = 0.0;

  bool operator<=(const Stamp& other) const {
    return whole < other.whole || (whole == other.whole && rest <= other.rest);
  }
};

struct Signal {
  std::string name, unit;
  std::vector<Stamp> stamps;  ///< as they came
  std::vector<double> values;
};

/// The stamps' name, unit and kind, as a column's.
struct StampColumn {
  std::string name, unit;
  bool clock = false;
};

/// Rows at the stamps of the angle with the most values, else of the longest signal; the others hold their last value.
/// `what`: how the log is called in remarks. Error: no signal has two values.
Result<RawTable> tableOfSignals(const std::vector<Signal>& signals, const StampColumn& time, const Message& what,
                                const std::string& name);

}  // namespace breakaway
