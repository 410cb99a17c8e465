#include "diagnose/catalogue.h"

#include <algorithm>
#include <array>

#include "diagnose/effects/all.h"

namespace breakaway {

std::span<const Effect* const> catalogue() {
  static const std::array<const Effect*, 8> effects{
      &constantLoad(),          &coulombAsymmetry(), &viscousAsymmetry(),          &stribeck(),
      &loadDependentFriction(), &imbalance(),        &positionDependentFriction(), &cogging()};
  return effects;
}

const Effect* findEffect(std::string_view name) {
  const auto all = catalogue();
  const auto it = std::find_if(all.begin(), all.end(), [name](const Effect* effect) { return effect->name() == name; });
  return it == all.end() ? nullptr : *it;
}

}  // namespace breakaway
