// One recording as the fit and the simulation see it: SI arrays, gaps filled, what can't be used masked.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

/// All vectors have one entry per row. On a linear axis read m for rad and N for Nm.
struct Track {
  std::string name;
  std::vector<double> time;      ///< s since the first row
  std::vector<double> position;  ///< rad as recorded; rows without one hold the last value and are not `seen`
  std::vector<double> input;     ///< volts, amperes or torque that act from the row to the next
  std::vector<char> seen;        ///< the row has a position
  std::vector<char> connected;   ///< windings not open
  std::vector<double> current;   ///< measured current in A where voltage or duty drives and it was recorded; else empty
  double origin_s = 0.0;         ///< time_s of the first row
  double noise = 0.0;            ///< standard deviation of one position reading: quantisation and what exceeds it
  std::vector<std::string> remarks;

  size_t rows() const { return time.size(); }
};

/// Reads what `input` and `axis` need from the recording. `count` is one encoder count in rad or m (0: unknown).
/// Errors: a needed column is missing or has no value at all; fewer than two rows.
Result<Track> makeTrack(const Recording& recording, Axis axis, DriveInput input, std::optional<double> supply_V,
                        double count);

}  // namespace breakaway
