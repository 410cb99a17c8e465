#include "trial/trial_effects.h"

#include <cassert>
#include <iterator>
#include <numbers>

#include "trial/trial_effect_tables.h"

namespace breakaway {

namespace {

std::string named(const std::string& what, const TrialRig& rig, const char* rotary, const char* linear) {
  return what + (rig.axis == Axis::rotary ? rotary : linear);
}

}  // namespace

std::string torqueNamed(const std::string& what, const TrialRig& rig) {
  return named(what, rig, "_Nm", "_N");
}
std::string viscousNamed(const std::string& what, const TrialRig& rig) {
  return named(what, rig, "_Nm_s_per_rad", "_N_s_per_m");
}
std::string speedNamed(const std::string& what, const TrialRig& rig) {
  return named(what, rig, "_rad_per_s", "_m_per_s");
}
std::string stiffnessNamed(const std::string& what, const TrialRig& rig) {
  return named(what, rig, "_Nm_per_rad", "_N_per_m");
}
std::string positionNamed(const std::string& what, const TrialRig& rig) {
  return named(what, rig, "_rad", "_m");
}

Harmonic drawnWave(double amplitude, int lowestOrder, int highestOrder, Random& random) {
  const size_t orders = static_cast<size_t>(highestOrder - lowestOrder) + 1;
  const double order = lowestOrder + static_cast<double>(random.below(orders));
  return {order, amplitude, drawn(random, -std::numbers::pi, std::numbers::pi)};
}

std::vector<std::pair<std::string, double>> waveTruth(const std::string& amplitudeName, const Harmonic& wave) {
  return {{amplitudeName, wave.amplitude}, {"phase_rad", wave.phase_rad}, {"order", wave.order}};
}

const std::vector<TrialEffect>& catalogueEffects() {
  static const std::vector<TrialEffect> all = [] {
    std::vector<TrialEffect> effects;
    for (auto part : {frictionEffects(), torqueEffects(), driveEffects(), mechanicalEffects()}) {
      effects.insert(effects.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
    }
    return effects;
  }();
  return all;
}

const TrialEffect& trialEffectNamed(std::string_view name) {
  for (const auto* table : {&catalogueEffects(), &outsideEffects()}) {
    for (const TrialEffect& effect : *table) {
      if (effect.name == name) return effect;
    }
  }
  assert(!"an effect of that name");
  return catalogueEffects().front();
}

}  // namespace breakaway
