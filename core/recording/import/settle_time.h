// A log's clock as times in s that increase, one per row.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace breakaway {

struct RawTime {
  std::vector<double> values;  ///< counted from `origin`, in the clock's unit
  double origin = 0.0;
  std::optional<double> unit_s;  ///< nothing: judged by the values
  bool clock = false;            ///< times of day or dates
  std::vector<size_t> newFile;   ///< rows with which a further file or part begins, in order
};

struct SettledTime {
  std::vector<double> time_s;  ///< strictly increasing
  std::vector<size_t> rows;    ///< the rows they belong to; all of them, as a rule
  std::vector<size_t> pauses;  ///< index into `rows` of the first row after each pause
  double unit_s = 1.0;         ///< s per unit of the values
  bool unitGuessed = false;
  std::vector<Message> remarks;
};

/// - Unit: ns, µs, ms or s since 1970, 100 ns since 1601 or the year 1, days since 1900 by the size of the stamps; else
/// whole numbers are ns from steps of a million on,
///   µs from 250 on, ms from 0.5 on; with decimals they are s, from steps of 10 on ms, from 250 on µs.
/// - A counter of 16, 24 or 32 bits that starts anew, and a clock at midnight, go on counting.
/// - Stamps that repeat are spread evenly up to the next one.
/// - A clock that begins anew (a board's reset, a further file) goes on 1 s after the row before.
/// - Stamps since 1970 and beyond 1e6 s are counted from the first row; so are times of day.
/// - A row without a time, and one of a hundred whose time falls back, are left out.
/// Each but the last is said. Errors, at `place`: no time at all; more times that don't increase.
Result<SettledTime> settleTime(RawTime raw, const std::string& place);

/// Adds how many pauses there are, and where the first one is, if there are any.
void sayPauses(const SettledTime& settled, std::vector<Message>& remarks);

/// Where a step is more than five of the usual ones, index of the row after it.
std::vector<size_t> pausesIn(const std::vector<double>& time_s);

}  // namespace breakaway
