// What the current sensor shows while the windings are open: its zero, and how far that has moved.
#pragma once

#include <string>

#include "experiment/drive.h"

namespace breakaway {

/// The mean of one stretch with open windings, and the way it moved against the one before.
class OpenCurrent {
 public:
  /// A new stretch begins.
  void begin();
  /// One sample of it; powered ones are left out.
  void take(const Sample& sample);
  /// Ends the stretch. In words how far the zero moved when that is more than `most_A`; empty otherwise. `rezeroed`:
  /// the board took the stretch before as its zero, so that this one's mean is the move itself.
  std::string moved(double most_A, bool rezeroed);

 private:
  double sum_A_ = 0.0, before_A_ = 0.0, start_s_ = 0.0, before_s_ = 0.0;
  size_t samples_ = 0;
  bool known_ = false;
};

}  // namespace breakaway
