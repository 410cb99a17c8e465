// Fewer points for the screen without losing a peak: the least and the greatest value of each short bucket of time.
#pragma once

#include <optional>
#include <vector>

namespace breakaway {

struct TracePoint {
  double time_s = 0.0;
  double value = 0.0;  ///< NaN where samples are missing: a gap is shown as a gap
  bool operator==(const TracePoint&) const = default;
};

/// Takes samples in time order; each bucket yields its extremes in the order in which they came.
class Envelope {
 public:
  /// `bucket_s` is the bucket's length, `gap_s` the step of time from which on samples count as missing.
  Envelope(double bucket_s, double gap_s) : bucket_s_(bucket_s), gap_s_(gap_s) {}

  /// Points that became final are appended to `points`.
  void add(double time_s, double value, std::vector<TracePoint>& points);
  void reset();

 private:
  void close(std::vector<TracePoint>& points);

  double bucket_s_;
  double gap_s_;
  double start_s_ = 0.0;
  double last_s_ = 0.0;
  std::optional<TracePoint> least_, greatest_;
};

}  // namespace breakaway
