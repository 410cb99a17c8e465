// What the current sensor shows while the windings are open: its zero, and how far that has moved.
#pragma once

#include <string>

#include "base/message.h"
#include "experiment/drive.h"

namespace breakaway {

/// In words that the sensor's zero moved by `move_A` within `passed_s`, if that is more than `most_A`; empty otherwise.
Message zeroMoved(double move_A, double passed_s, double most_A);

/// The mean of one stretch with open windings, and the way it moved against the one before.
class OpenCurrent {
 public:
  /// A new stretch begins.
  void begin();
  /// One sample of it; powered ones are left out.
  void take(const Sample& sample);
  /// Ends the stretch; zeroMoved() since the one before, between which the board took no new zero, beyond what the
  /// sensor's noise leaves of both means.
  Message moved(double most_A);

 private:
  double sum_A_ = 0.0, squares_A2_ = 0.0, before_A_ = 0.0, beforeError_A_ = 0.0, start_s_ = 0.0, before_s_ = 0.0;
  size_t samples_ = 0;
  bool known_ = false;
};

}  // namespace breakaway
