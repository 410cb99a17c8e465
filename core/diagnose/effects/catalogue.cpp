#include "diagnose/effects/catalogue.h"

#include <algorithm>
#include <array>

#include "diagnose/effects/all.h"

namespace breakaway {

std::span<const Effect* const> catalogue() {
  static const auto effects = std::to_array<const Effect*>({&constantLoad(),
                                                            &coulombAsymmetry(),
                                                            &viscousAsymmetry(),
                                                            &stribeck(),
                                                            &presliding(),
                                                            &quadraticDrag(),
                                                            &positionDependentFriction(),
                                                            &positionDependentViscous(),
                                                            &loadDependentFriction(),
                                                            &frictionWarmup(),
                                                            &risingStiction(),

                                                            &imbalance(),
                                                            &cogging(),
                                                            &torqueRipple(),
                                                            &torqueSaturation(),
                                                            &deadTime(),
                                                            &currentSensorOffset(),
                                                            &windingHeating(),
                                                            &supplySag(),
                                                            &encoderEccentricity(),
                                                            &commandSaturation(),
                                                            &backlash(),
                                                            &compliance(),
                                                            &endStop(),
                                                            &transportDelay(),
                                                            &channelSkew(),
                                                            &externalDisturbance()});
  return effects;
}

const Effect* findEffect(std::string_view name) {
  const auto all = catalogue();
  const auto it = std::find_if(all.begin(), all.end(), [name](const Effect* effect) { return effect->name() == name; });
  return it == all.end() ? nullptr : *it;
}

std::string countedAs(const std::string& effect) {
  const Effect* known = findEffect(effect);
  if (known == nullptr || known->twin().empty()) return effect;
  return std::min(effect, std::string(known->twin()));
}

std::vector<Parameter> presentParameters(const EffectTerm& term, Axis axis) {
  std::vector<Parameter> present;
  const Effect* effect = findEffect(term.effect);
  const auto specs = effect != nullptr ? effect->parameters(axis) : std::vector<ParameterSpec>{};
  for (size_t k = 0; k < term.parameters.size(); ++k) {
    const bool absent = k < specs.size() && specs[k].absentAtZero && term.parameters[k].value == 0.0;
    if (!absent) present.push_back(term.parameters[k]);
  }
  return present;
}

}  // namespace breakaway
