// One accessor per effect file; catalogue.cpp lists them.
#pragma once

#include "diagnose/model/effect.h"
#include "diagnose/model/model.h"

namespace breakaway {

const Effect& coulombAsymmetry();
const Effect& viscousAsymmetry();
const Effect& stribeck();
const Effect& presliding();
const Effect& quadraticDrag();
const Effect& positionDependentFriction();
const Effect& positionDependentViscous();
const Effect& loadDependentFriction();
const Effect& frictionWarmup();
const Effect& risingStiction();
const Effect& constantLoad();
const Effect& imbalance();
const Effect& cogging();
const Effect& torqueRipple();
const Effect& torqueSaturation();
const Effect& deadTime();
const Effect& currentSensorOffset();
const Effect& windingHeating();
const Effect& supplySag();
const Effect& encoderEccentricity();
const Effect& commandSaturation();
const Effect& backlash();
const Effect& compliance();
const Effect& endStop();
const Effect& transportDelay();
const Effect& channelSkew();
const Effect& externalDisturbance();

/// A term of stribeck(): so much more friction near standstill, gone above `speed` as a Gaussian is.
EffectTerm frictionNearStandstill(double excess, double speed, Axis axis);

}  // namespace breakaway
