// Zeroing the current sensor with the windings open.
#pragma once

#include "base/estimate.h"
#include "experiment/open_current.h"
#include "experiment/timed_procedure.h"

namespace breakaway {

struct CurrentZeroingOptions {
  double settle_s = 0.05;  ///< lets the winding's current die first
  double duration_s = 1.0;
  double mostDrift_A = 0.05;  ///< from the first half of the time to the second
  double turns_rad = 0.05;    ///< with the windings open: something else than the motor drives
  Axis axis = Axis::rotary;
};

/// Takes the sensor's mean as its zero, which the board then subtracts, and measures the noise. Fails in words when the
/// sensor drifts meanwhile, and when the shaft
/// turns by itself.
class CurrentZeroing : public TimedProcedure {
 public:
  explicit CurrentZeroing(const CurrentZeroingOptions& options = {}) : options_(options) {}

  /// The zero relative to the earlier one, in A, with its standard error.
  Estimate zero_A() const;
  double noiseRms_A() const;

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override {
    return timed(elapsed_s_, options_.settle_s + options_.duration_s, message("zeroing the current sensor"));
  }

 private:
  CurrentZeroingOptions options_;
  double elapsed_s_ = 0.0, sum_ = 0.0, squares_ = 0.0;
  size_t count_ = 0;
  double first_rad_ = 0.0;
  OpenCurrent half_A_;
  bool second_ = false;
};

}  // namespace breakaway
