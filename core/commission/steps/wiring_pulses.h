// The wiring check as the bench job makes it, at its beginning and at its end.
#pragma once

#include <memory>

#include "commission/step.h"
#include "experiment/wiring_check.h"

namespace breakaway {

/// For the axis, the encoder's counts, the sensor's noise and the current limit at the bench.
std::shared_ptr<WiringCheck> wiringCheckOn(const OnBench& on);

}  // namespace breakaway
