#include "plant/rig_torques.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

void fold(const RigEffect& effect, double angle_rad, RigTorques& torques) {
  const auto wave = [&](double order) { return std::cos(order * angle_rad - effect.parameter("phase_rad")); };
  if (effect.effect == "constant_load") torques.position_Nm += effect.parameter("torque_Nm");
  if (effect.effect == "imbalance") torques.position_Nm += effect.parameter("amplitude_Nm") * wave(1.0);
  if (effect.effect == "cogging")
    torques.position_Nm += effect.parameter("amplitude_Nm") * wave(effect.parameter("order"));
  for (size_t way = 0; way < 2; ++way) {
    const double sign = way == 0 ? -0.5 : 0.5;
    if (effect.effect == "coulomb_asymmetry") {
      torques.coulomb_Nm[way] += sign * effect.parameter("difference_Nm");
      torques.static_Nm[way] += sign * effect.parameter("difference_Nm");
    }
    if (effect.effect == "viscous_asymmetry") {
      torques.viscous_Nm_s_per_rad[way] += sign * effect.parameter("difference_Nm_s_per_rad");
    }
    if (effect.effect == "stribeck") torques.static_Nm[way] += effect.parameter("excess_Nm");
    if (effect.effect == "rising_stiction") torques.static_Nm[way] *= 1.0 + effect.parameter("share");
    if (effect.effect == "position_dependent_friction") {
      const double factor = 1.0 + effect.parameter("amplitude") * wave(effect.parameter("order"));
      torques.coulomb_Nm[way] *= factor;
      torques.static_Nm[way] *= factor;
    }
    if (effect.effect == "position_dependent_viscous") {
      torques.viscous_Nm_s_per_rad[way] *= 1.0 + effect.parameter("amplitude") * wave(effect.parameter("order"));
    }
  }
}

}  // namespace

RigTorques torquesAt(const Rig& rig, double angle_rad) {
  RigTorques torques;
  for (size_t way = 0; way < 2; ++way) {
    torques.static_Nm[way] = rig.staticFriction_Nm[way].at(angle_rad);
    torques.coulomb_Nm[way] = rig.coulomb_Nm[way].at(angle_rad);
    torques.viscous_Nm_s_per_rad[way] = rig.viscous_Nm_s_per_rad[way].at(angle_rad);
  }
  torques.position_Nm = rig.positionTorqueAt(angle_rad);
  for (const RigEffect& effect : rig.effects) fold(effect, angle_rad, torques);
  for (size_t way = 0; way < 2; ++way) {
    torques.static_Nm[way] = std::max(0.0, torques.static_Nm[way]);
    torques.coulomb_Nm[way] = std::max(0.0, torques.coulomb_Nm[way]);
    torques.viscous_Nm_s_per_rad[way] = std::max(0.0, torques.viscous_Nm_s_per_rad[way]);
  }
  return torques;
}

int highestOrder(const Rig& rig) {
  int order = 1;
  const auto take = [&order](const std::vector<Harmonic>& harmonics) {
    for (const Harmonic& one : harmonics) order = std::max(order, one.order);
  };
  for (size_t way = 0; way < 2; ++way) {
    take(rig.staticFriction_Nm[way].harmonics);
    take(rig.coulomb_Nm[way].harmonics);
    take(rig.viscous_Nm_s_per_rad[way].harmonics);
  }
  take(rig.positionTorque_Nm);
  for (const RigEffect& effect : rig.effects) {
    for (const auto& [name, value] : effect.parameters) {
      if (name == "order") order = std::max(order, static_cast<int>(std::ceil(std::abs(value))));
    }
  }
  return order;
}

}  // namespace breakaway
