// What a measured drive did between its readings.
#pragma once

#include <cstddef>
#include <vector>

#include "diagnose/simulate/track.h"

namespace breakaway {

/// A drive that was read `late_s` after the begin of what it stands for, at most one row. At 0 it acts in steps, each
/// from its row to the next; read at the row's instant, half a row late, it is a course through the readings. Negative:
/// it acts in steps, so much after its row.
class DriveReading {
 public:
  DriveReading(const Track& track, double late_s);

  /// What acted on average in rows [first, first + count), in units of the input: of a course the mean of the cubic
  /// through four readings, (−1, 13, 13, −1)/24; for the last row of the track what was read.
  std::vector<double> means(size_t first, size_t count) const;
  /// What a drive that rises within row k falls short of its mean, integrated twice over the row: units of the input
  /// times s². Precondition: there is a row k + 1.
  double lag(size_t k) const;

 private:
  const Track& track_;
  double late_s_, course_;  ///< course: 0 steps, 1 a course through the readings
};

}  // namespace breakaway
