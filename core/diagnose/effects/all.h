// One accessor per effect file; catalogue.cpp lists them.
#pragma once

#include "diagnose/effect.h"

namespace breakaway {

const Effect& constantLoad();
const Effect& coulombAsymmetry();
const Effect& viscousAsymmetry();
const Effect& stribeck();
const Effect& loadDependentFriction();
const Effect& positionDependentFriction();
const Effect& cogging();
const Effect& imbalance();

}  // namespace breakaway
