// Whether a term's own intervals let it be reported.
#pragma once

#include "diagnose/fit/torque_noise.h"
#include "diagnose/model/excitation.h"
#include "diagnose/model/model.h"

namespace breakaway {

/// Whether one of the term's figures is known, the amplitude's interval leaves out zero, and its torque is more than
/// what wanders anyway, `left` (at most mostWander()), and no more than the drive gives.
bool worthSaying(const EffectTerm& term, const Model& model, const Excitation& seen, const TorqueNoise& left,
                 const Criteria& criteria = {});

/// Whether a parameter that can't be negative (a time, a stiffness, a speed) has an interval of less than a factor of
/// ten. `number`: its place among the term's parameters; what is held, or may be negative, counts as known.
bool isKnown(const EffectTerm& term, size_t number, Axis axis, const Criteria& criteria = {});

}  // namespace breakaway
