#include "session/motor_test_curves.h"

#include <cmath>
#include <limits>

#include "commission/motor_tests.h"

namespace breakaway {

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// Whether nothing is missing between two blocks.
bool follows(const SpinBlock& before, const SpinBlock& here) {
  return here.end_s - before.end_s < 1.5 * here.duration_s;
}

}  // namespace

TestCurve speedOverTime(const std::vector<SpinBlock>& blocks) {
  TestCurve curve;
  for (size_t k = 1; k < blocks.size(); ++k) {
    const SpinBlock &before = blocks[k - 1], &here = blocks[k];
    const bool known = here.duration_s > 0.0 && follows(before, here);
    curve.x.push_back(here.end_s - 0.5 * here.duration_s - blocks.front().end_s);
    curve.y.push_back(known ? (here.angle_rad - before.angle_rad) / (here.end_s - before.end_s) : gap);
  }
  return curve;
}

TestCurve currentOverTime(const std::vector<SpinBlock>& blocks) {
  TestCurve curve;
  for (size_t k = 1; k < blocks.size(); ++k) {
    const SpinBlock& here = blocks[k];
    curve.x.push_back(here.end_s - 0.5 * here.duration_s - blocks.front().end_s);
    curve.y.push_back(follows(blocks[k - 1], here) ? here.current_A : gap);
  }
  return curve;
}

TestCurve foretoldSpeed(const std::vector<SpinBlock>& blocks, const Commission& known) {
  const double J = known.motor.inertia_kg_m2.value, Kt = known.motor.torquePerShownAmpere_Nm();
  const double F = known.motor.coulomb_Nm.value, B = known.motor.viscous_Nm_s_per_rad.value;
  const TestCurve measured = speedOverTime(blocks);
  TestCurve curve;
  if (!(J > 0.0)) return curve;
  double speed = gap;
  for (size_t k = 0; k < measured.x.size(); ++k) {
    const SpinBlock &before = blocks[k], &here = blocks[k + 1];
    const bool turned = before.current_A * here.current_A <= 0.0;
    if (turned || !std::isfinite(speed) || !std::isfinite(measured.y[k])) {
      curve.x.push_back(measured.x[k]);
      curve.y.push_back(gap);
      speed = measured.y[k];
    } else {
      // From the middle of one block to that of the next, implicitly in what damps.
      const double span_s = measured.x[k] - measured.x[k - 1], mean_A = 0.5 * (before.current_A + here.current_A);
      const double friction = speed == 0.0 ? 0.0 : std::copysign(F, speed);
      speed = (speed + span_s * (Kt * mean_A - friction) / J) / (1.0 + span_s * B / J);
    }
    curve.x.push_back(measured.x[k]);
    curve.y.push_back(speed);
  }
  return curve;
}

TestCurve currentLeft(const Commission& known) {
  TestCurve curve;
  if (known.tests == nullptr) return curve;
  const WindingLine& line = known.tests->winding.line;
  const double dead_V = line.deadZone_V.value, R = line.resistance_ohm.value;
  if (!(R > 0.0)) return curve;
  for (const WindingPoint& one : known.tests->bridge.standing) {
    const double beyond_V = std::max(0.0, std::abs(one.voltage_V) - dead_V);
    curve.x.push_back(one.voltage_V);
    curve.y.push_back(one.current_A - line.offset_A.value - std::copysign(beyond_V, one.voltage_V) / R);
  }
  return curve;
}

}  // namespace breakaway
