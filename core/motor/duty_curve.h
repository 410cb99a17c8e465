// What a bridge gives of the duty it is asked for: output duty over input duty, and back.
#pragma once

#include <vector>

#include "base/estimate.h"

namespace breakaway {

struct DutyPoint {
  double input = 0.0;  ///< duty that is commanded, part of the supply
  Estimate output;     ///< mean voltage over the windings, part of the supply
};

/// Straight between its points, of slope one beyond the last, odd in the duty. The first point is the dead zone's end
/// with an output of zero; inputs and outputs rise strictly. No point: the bridge gives what it is asked for.
struct DutyCurve {
  std::vector<DutyPoint> points;

  bool known() const { return !points.empty(); }
  double output(double input) const;
  /// The inverse; 0 gives 0, although the whole dead zone does.
  double input(double output) const;
  /// Whether inputs and outputs rise strictly from an output of zero at a dead zone of 0 or more.
  bool rises() const;
};

}  // namespace breakaway
