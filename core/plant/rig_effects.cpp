#include "plant/rig_effects.h"

#include <algorithm>
#include <cassert>

namespace breakaway {

namespace {

Harmonic waveOf(const RigEffect& e, double order, const char* amplitude) {
  return {order, e.parameter(amplitude), e.parameter("phase_rad")};
}

using Parameters = std::vector<std::pair<std::string, double>>;
using Conceal = void (*)(const RigEffect&, PlantPhysics&);

RigEffectKind ofAngle(const char* effect, Parameters parameters, Conceal conceal) {
  return {effect, std::move(parameters), true, true, conceal};
}
RigEffectKind ofRotor(const char* effect, Parameters parameters, Conceal conceal) {
  return {effect, std::move(parameters), false, true, conceal};
}
RigEffectKind ofAnyAxis(const char* effect, Parameters parameters, Conceal conceal) {
  return {effect, std::move(parameters), false, false, conceal};
}

void ripple(const RigEffect& e, PlantPhysics& p) {
  p.ripple.push_back(waveOf(e, e.parameter("order"), "amplitude"));
}

void heating(const RigEffect& e, PlantPhysics& p) {
  const double current_A = e.parameter("current_A"), time_s = e.parameter("time_constant_s");
  p.heatingPerJoule = e.parameter("share") / (current_A * current_A * p.resistance_ohm * time_s);
  p.heatingTime_s = time_s;
}

}  // namespace

double RigEffect::parameter(const std::string& name) const {
  for (const auto& [key, value] : parameters) {
    if (key == name) return value;
  }
  assert(false);
  return 0.0;
}

const std::vector<RigEffectKind>& rigEffectKinds() {
  using E = const RigEffect&;
  using P = PlantPhysics&;
  static const std::vector<RigEffectKind> kinds{
      ofAngle("constant_load", {{"torque_Nm", 0.002}}, [](E e, P p) { p.load += e.parameter("torque_Nm"); }),
      ofAngle("imbalance", {{"amplitude_Nm", 0.002}, {"phase_rad", 0.0}},
              [](E e, P p) { p.position.push_back(waveOf(e, 1.0, "amplitude_Nm")); }),
      ofAngle("cogging", {{"order", 12.0}, {"amplitude_Nm", 0.002}, {"phase_rad", 0.0}},
              [](E e, P p) { p.position.push_back(waveOf(e, e.parameter("order"), "amplitude_Nm")); }),
      ofAngle("coulomb_asymmetry", {{"difference_Nm", 0.002}},
              [](E e, P p) { addCoulombAsymmetry(p, e.parameter("difference_Nm")); }),
      ofAngle("viscous_asymmetry", {{"difference_Nm_s_per_rad", 1e-5}},
              [](E e, P p) { addViscousAsymmetry(p, e.parameter("difference_Nm_s_per_rad")); }),
      ofAngle("stribeck", {{"excess_Nm", 0.003}}, [](E e, P p) { addStribeckExcess(p, e.parameter("excess_Nm")); }),
      ofRotor("quadratic_drag", {{"coefficient_Nm_s2_per_rad2", 1e-7}},
              [](E e, P p) { p.quadraticDrag = e.parameter("coefficient_Nm_s2_per_rad2"); }),
      ofAngle("position_dependent_friction", {{"order", 1.0}, {"amplitude", 0.2}, {"phase_rad", 0.0}},
              [](E e, P p) { addFrictionOverAngle(p, waveOf(e, e.parameter("order"), "amplitude")); }),
      ofAngle("position_dependent_viscous", {{"order", 1.0}, {"amplitude", 0.2}, {"phase_rad", 0.0}},
              [](E e, P p) { addViscousOverAngle(p, waveOf(e, e.parameter("order"), "amplitude")); }),
      ofAnyAxis("friction_warmup", {{"share", 0.2}, {"time_constant_s", 60.0}},
                [](E e, P p) {
                  p.warmup = {e.parameter("share"), 0.0, e.parameter("time_constant_s")};
                }),
      ofAnyAxis("rising_stiction", {{"share", 0.1}, {"time_constant_s", 1.0}},
                [](E e, P p) { p.rest.share = e.parameter("share"), p.rest.time_s = e.parameter("time_constant_s"); }),
      ofRotor("torque_ripple", {{"order", 6.0}, {"amplitude", 0.05}, {"phase_rad", 0.0}}, ripple),
      ofAnyAxis("dead_time", {{"voltage_V", 0.2}}, [](E e, P p) { p.deadTime_V = e.parameter("voltage_V"); }),
      ofAnyAxis("winding_heating", {{"share", 0.3}, {"current_A", 1.0}, {"time_constant_s", 30.0}}, heating),
      ofAnyAxis("supply_sag", {{"resistance_ohm", 0.2}},
                [](E e, P p) { p.supplyResistance_ohm += e.parameter("resistance_ohm"); }),
      ofAnyAxis("current_sensor_offset", {{"offset_A", 0.05}}, nullptr),
      ofRotor("encoder_eccentricity", {{"amplitude_rad", 0.002}, {"phase_rad", 0.0}}, nullptr),
      ofRotor("external_disturbance", {{"torque_Nm", 0.003}, {"start_s", 5.0}, {"duration_s", 1.0}},
              [](E e, P p) {
                p.pulse = {e.parameter("torque_Nm"), e.parameter("start_s"), e.parameter("duration_s")};
              }),
  };
  return kinds;
}

const RigEffectKind* findRigEffect(const std::string& effect) {
  const auto& kinds = rigEffectKinds();
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.effect == effect; });
  return kind == kinds.end() ? nullptr : &*kind;
}

}  // namespace breakaway
