// The inverse of the bridge's duty curve, as a feed-forward behind every mode. Freestanding; the board runs it too.
#pragma once

#include "control/magnitude.h"

namespace breakaway {

/// Output duty over input duty, straight between its points, of slope one beyond the last, odd. The first point is the
/// dead zone's end with an output of zero; both rise strictly.
template <typename Scalar>
struct DutyTable {
  static constexpr int mostPoints = 16;

  int points = 0;  ///< 0: the bridge gives what it is asked for
  Scalar input[mostPoints] = {};
  Scalar output[mostPoints] = {};
};

/// What to ask of a bridge with such a curve. What a tick would have to divide is divided when the curve comes.
template <typename Scalar>
class DutyInverse {
 public:
  void take(const DutyTable<Scalar>& table) {
    table_ = table;
    for (int k = 1; k < table.points; ++k)
      slope_[k] = (table.input[k] - table.input[k - 1]) / (table.output[k] - table.output[k - 1]);
    lost_ = known() ? table.input[table.points - 1] - table.output[table.points - 1] : Scalar(0);
  }

  bool known() const { return table_.points > 0; }
  /// What the bridge keeps of a full duty.
  Scalar lost() const { return lost_; }

  /// The duty to ask for so that the windings get `wanted`; 0 for 0.
  Scalar inputFor(Scalar wanted) const {
    if (!known() || isZero(wanted)) return wanted;
    const Scalar size = magnitude(wanted);
    int k = 1;
    while (k < table_.points && exceeds(size, table_.output[k])) ++k;
    const Scalar asked =
        k < table_.points ? table_.input[k - 1] + (size - table_.output[k - 1]) * slope_[k] : size + lost_;
    return isNegative(wanted) ? -asked : asked;
  }

 private:
  DutyTable<Scalar> table_;
  Scalar slope_[DutyTable<Scalar>::mostPoints] = {};  ///< of the piece that ends at a point
  Scalar lost_ = 0;
};

}  // namespace breakaway
