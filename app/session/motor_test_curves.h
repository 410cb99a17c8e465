// What the steps of an identification show over time or over voltage: as measured, and as the identified motor has it.
#pragma once

#include <vector>

#include "commission/known.h"
#include "experiment/spin_block.h"

namespace breakaway {

/// Points in order; NaN in y is a gap.
struct TestCurve {
  std::vector<double> x, y;
};

/// Mean speed of each block over the time from the first block on, s and rad/s (m/s on a linear axis); a gap where
/// blocks don't follow each other.
TestCurve speedOverTime(const std::vector<SpinBlock>& blocks);
/// Mean current of each block, A.
TestCurve currentOverTime(const std::vector<SpinBlock>& blocks);
/// The speed that the identified motor would have by the measured current: J dω/dt = T − F sign ω − B ω, begun anew at
/// the measured speed where the current turns, where it is switched, and where the measurement has a gap.
TestCurve foretoldSpeed(const std::vector<SpinBlock>& blocks, const Commission& known);
/// What the winding's line leaves of the standing motor's current, A over V.
TestCurve currentLeft(const Commission& known);

}  // namespace breakaway
