// Whether the encoder's index still comes where homing found it.
#pragma once

#include <string>

#include "base/axis.h"
#include "base/message.h"
#include "recording/sample.h"

namespace breakaway {

/// The encoder's only means to show that no count was lost.
class IndexWatch {
 public:
  /// `indexAngle_rad` in the board's angle, any turn; `tolerance_rad` for the index' width and the encoder's rounding;
  /// 0 watches nothing.
  /// On a linear axis there is but one place.
  IndexWatch(double indexAngle_rad, double tolerance_rad, Axis axis = Axis::rotary)
      : index_rad_(indexAngle_rad), tolerance_rad_(tolerance_rad), axis_(axis) {}

  /// Takes every sample; what is wrong in words, empty as long as nothing is: the index seen elsewhere, or its place
  /// passed without it.
  Message step(const Sample& sample);

 private:
  double fromIndex(double angle_rad) const;
  double sideOf(double angle_rad) const;

  double index_rad_, tolerance_rad_;
  Axis axis_;
  double before_rad_ = 0.0;
  double side_ = 0.0;  ///< sideOf() when last well beside it
  bool begun_ = false, besideOnce_ = false, seen_ = false;
};

inline const Message invertedIndexText = message(
    "the index is seen nearly everywhere: its signal is inverted; swap its two wires, or the polarity in the board");

/// Tolerance for an encoder of that many counts: its index' width and rounding, and half a degree.
double indexTolerance_rad(double countsPerRev);

}  // namespace breakaway
