// The wiring check as the bench job makes it, at its beginning, at its end and when it ends early.
#pragma once

#include <memory>

#include "commission/step.h"
#include "experiment/wiring_check.h"

namespace breakaway {

/// For the axis, the encoder's counts, the sensor's noise and the current limit at the bench.
/// `coast_s`: what turns is left to
/// come to rest that long before, at least.
std::shared_ptr<WiringCheck> wiringCheckOn(const OnBench& on, double coast_s = 0.0);

}  // namespace breakaway
