// A current sensor that shows the same whatever the voltage.
#pragma once

#include <string>

#include "base/message.h"
#include "recording/sample.h"

namespace breakaway {

/// A converter dithers with its noise and follows what flows; one that shows the same number for seconds while the
/// voltage changes measures nothing.
class DeadSensor {
 public:
  /// Takes every sample; what is wrong in words, empty as long as nothing is.
  Message step(const Sample& sample);

 private:
  double shown_A_ = 0.0, energised_s_ = 0.0, before_s_ = 0.0;
  double low_V_ = 0.0, high_V_ = 0.0;
  bool begun_ = false;
};

}  // namespace breakaway
