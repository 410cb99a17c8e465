// What the winding test tells of the motor.
#pragma once

#include <algorithm>
#include <array>

#include "base/estimate.h"
#include "base/result.h"
#include "experiment/winding_test.h"
#include "motor/winding_line.h"

namespace breakaway {

struct WindingFit {
  WindingLine line;
  Estimate timeConstant_s;             ///< L/R
  std::array<double, 2> expected_A{};  ///< first look at the breakaway current, by Way

  double friction_A() const { return std::max(expected_A[0], expected_A[1]); }
};

/// Of a finished test. Errors: those of fitWindingLine() and fitTimeConstant().
Result<WindingFit> fitWinding(const WindingTest& test);

}  // namespace breakaway
