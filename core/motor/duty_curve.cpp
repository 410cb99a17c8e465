#include "motor/duty_curve.h"

#include <cmath>
#include <cstddef>

namespace breakaway {

double DutyCurve::output(double input) const {
  const double asked = std::abs(input);
  if (!known()) return input;
  if (asked <= points.front().input) return 0.0;
  for (size_t k = 1; k < points.size(); ++k) {
    const DutyPoint &a = points[k - 1], &b = points[k];
    if (asked > b.input) continue;
    const double part = (asked - a.input) / (b.input - a.input);
    return std::copysign(a.output.value + part * (b.output.value - a.output.value), input);
  }
  return std::copysign(points.back().output.value + asked - points.back().input, input);
}

double DutyCurve::input(double output) const {
  const double wanted = std::abs(output);
  if (!known() || wanted == 0.0) return output;
  for (size_t k = 1; k < points.size(); ++k) {
    const DutyPoint &a = points[k - 1], &b = points[k];
    if (wanted > b.output.value) continue;
    const double part = (wanted - a.output.value) / (b.output.value - a.output.value);
    return std::copysign(a.input + part * (b.input - a.input), output);
  }
  return std::copysign(points.back().input + wanted - points.back().output.value, output);
}

bool DutyCurve::rises() const {
  if (!known()) return true;
  if (!(points.front().input >= 0.0) || points.front().output.value != 0.0) return false;
  for (size_t k = 1; k < points.size(); ++k) {
    if (!(points[k].input > points[k - 1].input) || !(points[k].output.value > points[k - 1].output.value))
      return false;
  }
  return true;
}

}  // namespace breakaway
