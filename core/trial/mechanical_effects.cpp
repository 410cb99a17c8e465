#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/statistics.h"
#include "trial/trial_effect_tables.h"

namespace breakaway {

namespace {

using enum TrialMove;

/// Puts a part of the inertia behind a shaft that resonates against its load at `rate_Hz` with the motor held.
void splitInertia(TrialRig& rig, double share, double rate_Hz, double dampingRatio) {
  PlantPhysics& p = rig.physics;
  const double total = p.totalInertia(), w = turn_rad * rate_Hz;
  const double load = share * total;
  p.inertia = total - load;
  p.coupling.loadInertia_kg_m2 = load;
  p.coupling.stiffness_Nm_per_rad = w * w * load;
  p.coupling.damping_Nm_s_per_rad = 2.0 * dampingRatio * w * load;
}

const char* loadName(const TrialRig& rig) {
  return rig.axis == Axis::rotary ? "load_kg_m2" : "load_kg";
}

Concealed backlash(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  RigCoupling& shaft = rig.physics.coupling;
  splitInertia(rig, drawn(random, 0.3, 0.6), drawn(random, 60.0, 120.0), drawn(random, 0.1, 0.3));
  const double full = rig.axis == Axis::rotary ? 0.06 : 1e-3;
  shaft.gap_rad = std::max(8.0 * rig.sensors.count, size * drawnLog(random, 0.4, 1.6) * full);
  return {"backlash",
          {{positionNamed("gap", rig), shaft.gap_rad},
           {stiffnessNamed("stiffness", rig), shaft.stiffness_Nm_per_rad},
           {loadName(rig), shaft.loadInertia_kg_m2}}};
}

/// Larger is softer.
Concealed compliance(TrialRig& rig, const TrialCourse&, double size, Random& random) {
  const double rate_Hz = drawnLog(random, 9.0, 30.0) / std::sqrt(size), damping = drawn(random, 0.015, 0.06);
  splitInertia(rig, drawn(random, 0.3, 0.6), rate_Hz, damping);
  return {"compliance",
          {{"antiresonance_rad_per_s", turn_rad * rate_Hz},
           {"damping_ratio", damping},
           {loadName(rig), rig.physics.coupling.loadInertia_kg_m2}}};
}

/// Larger stands further in the way.
Concealed endStop(TrialRig& rig, const TrialCourse& course, double size, Random& random) {
  PlantPhysics& p = rig.physics;
  const double beyond = size * drawn(random, 0.012, 0.035);  // part of the course that the stop cuts off
  const double low = quantile(course.position, beyond), high = quantile(course.position, 1.0 - beyond);
  const double give = drawnLog(random, 0.1, 0.4) * (rig.axis == Axis::rotary ? 1.0 : 0.015);  // rad or m at peak torque
  const bool above = random.uniform() < 0.5;
  auto& stops = p.stops;
  stops.present = true;
  stops.low_rad = above ? low - 1e3 * (high - low) : low;
  stops.high_rad = above ? high : high + 1e3 * (high - low);
  stops.stiffness = rig.peakTorque / give;
  stops.damping = 2.0 * drawn(random, 0.05, 0.3) * std::sqrt(stops.stiffness * p.inertia);
  return {"end_stop",
          {{positionNamed("position", rig), above ? stops.high_rad : stops.low_rad},
           {stiffnessNamed("stiffness", rig), stops.stiffness}}};
}

Concealed disturbance(TrialRig& rig, const TrialCourse& course, double size, Random& random) {
  auto& pulse = rig.physics.pulse;
  const double duration_s = static_cast<double>(course.velocity.size()) * course.row_s;
  pulse.torque = -drawnSign(random) * size * drawn(random, 0.06, 0.18) * rig.peakTorque;
  pulse.start_s = drawn(random, 0.15, 0.75) * duration_s;
  pulse.duration_s = drawnLog(random, 0.8, 4.0);
  return {"external_disturbance",
          {{torqueNamed(rig.axis == Axis::rotary ? "torque" : "force", rig), pulse.torque},
           {"start_s", pulse.start_s},
           {"duration_s", pulse.duration_s}}};
}

}  // namespace

std::vector<TrialEffect> mechanicalEffects() {
  TrialNeeds any, shaft, position;
  position.positionLoop = position.noPendulum = shaft.noPendulum = true;
  return {{"backlash", shaft, {reversals, steps, multisine}, 30.0, backlash},
          {"compliance", shaft, {chirp, steps, reversals}, 30.0, compliance},
          {"end_stop", position, {multisine, steps}, 30.0, endStop, false},
          {"external_disturbance", any, {multisine, turns, steps}, 30.0, disturbance}};
}

}  // namespace breakaway
