#include "diagnose/catalogue.h"

#include <algorithm>
#include <array>

#include "diagnose/effects/all.h"

namespace breakaway {

std::span<const Effect* const> catalogue() {
  static const std::array<const Effect*, 27> effects{&constantLoad(),
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
                                                     &externalDisturbance()};
  return effects;
}

const Effect* findEffect(std::string_view name) {
  const auto all = catalogue();
  const auto it = std::find_if(all.begin(), all.end(), [name](const Effect* effect) { return effect->name() == name; });
  return it == all.end() ? nullptr : *it;
}

}  // namespace breakaway
