// The steady line between bridge voltage and winding current at standstill.
#pragma once

#include <cstddef>
#include <vector>

#include "base/estimate.h"
#include "base/result.h"

namespace breakaway {

/// i = sgn(v)·max(0, |v| − V0)/R + i0: resistance, the bridge's dead zone, and what is left of the sensor's zero.
struct WindingLine {
  Estimate resistance_ohm;
  Estimate deadZone_V;
  Estimate offset_A;

  double voltageFor(double current_A) const;
};

struct WindingPoint {
  double voltage_V = 0.0;
  double current_A = 0.0;
};

/// Least squares of the line through points of a standing rotor, both signs of the voltage; the dead zone by search,
/// the rest linear. Errors: fewer than 20 points, or no current that stands out of the points' scatter.
Result<WindingLine> fitWindingLine(const std::vector<WindingPoint>& points);

}  // namespace breakaway
