#include "plant/rig_coupling.h"

#include <cmath>

#include "base/json_object.h"

namespace breakaway {

namespace {
constexpr double fastest_rad_per_s = 3e4;  // what a plant of 1.5 µs steps can follow
}

double RigCoupling::resonance_rad_per_s(double motorInertia_kg_m2) const {
  return present() ? std::sqrt(stiffness_Nm_per_rad * (1.0 / motorInertia_kg_m2 + 1.0 / loadInertia_kg_m2)) : 0.0;
}

double RigCoupling::torque_Nm(double twist_rad, double slip_rad_per_s) const {
  const double beyond_rad = std::abs(twist_rad) - 0.5 * gap_rad;
  if (beyond_rad <= 0.0) return 0.0;
  const double torque_Nm =
      std::copysign(stiffness_Nm_per_rad * beyond_rad, twist_rad) + damping_Nm_s_per_rad * slip_rad_per_s;
  // With play a flank can push, but not pull.
  return gap_rad > 0.0 && torque_Nm * twist_rad < 0.0 ? 0.0 : torque_Nm;
}

RigCoupling readCoupling(JsonObject& root, Axis axis, double unitPerRad, double motorInertia_kg_m2) {
  RigCoupling coupling;
  if (!root.has("coupling")) return coupling;
  const bool turns = axis == Axis::rotary;
  const double square = unitPerRad * unitPerRad;
  JsonObject object = root.object("coupling");
  const char* load = turns ? "load_inertia_kg_m2" : "load_mass_kg";
  const char* stiffness = turns ? "stiffness_Nm_per_rad" : "stiffness_N_per_m";
  coupling.stiffness_Nm_per_rad = square * object.number(stiffness, Allowed::positive);
  coupling.damping_Nm_s_per_rad =
      square * object.number(turns ? "damping_Nm_s_per_rad" : "damping_N_s_per_m", 0.0, Allowed::nonNegative);
  coupling.loadInertia_kg_m2 = square * object.number(load, Allowed::positive);
  coupling.gap_rad = object.number(turns ? "gap_rad" : "gap_m", 0.0, Allowed::nonNegative) / unitPerRad;
  if (coupling.gap_rad > 0.5) object.fault(turns ? "gap_rad" : "gap_m", "is no small play");
  const double resonance = coupling.resonance_rad_per_s(motorInertia_kg_m2);
  if (resonance > fastest_rad_per_s)
    object.fault(stiffness, "makes motor and load swing at " + std::to_string(std::lround(resonance)) +
                                " rad/s, expected at most 30000");
  const double critical = 2.0 * coupling.stiffness_Nm_per_rad / (resonance > 0.0 ? resonance : 1.0);
  if (coupling.damping_Nm_s_per_rad > critical)
    object.fault(turns ? "damping_Nm_s_per_rad" : "damping_N_s_per_m",
                 "is beyond critical damping, expected a coupling that swings");
  return coupling;
}

}  // namespace breakaway
