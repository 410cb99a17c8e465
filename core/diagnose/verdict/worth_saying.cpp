#include "diagnose/verdict/worth_saying.h"

#include <algorithm>
#include <cmath>

#include "base/distributions.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/search/model_fit.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

/// What a torque that wanders makes of an effect: the rms of its mean over as long as that acts, as often as the
/// largest of all forms in which it may be sought exceeds it by chance. What is always there is sought in each of its
/// shapes. What happens once is sought everywhere: starts are half a duration apart, and all longer durations together
/// have as many places again.
double largestOfWander(const EffectTerm& term, const TorqueNoise& left, double rms, const Excitation& seen,
                       const Criteria& criteria) {
  const Effect& effect = *findEffect(term.effect);
  const double alike_s = 2.0 * left.time_s;
  double acts_s = seen.duration_s, forms = static_cast<double>(effect.shapes(seen).size());
  if (const OncePart* once = effect.once()) {
    acts_s = std::max(term.parameters[once->duration].value, alike_s);
    forms = 4.0 * seen.duration_s / acts_s;
  }
  return deviationsOf(criteria.likeliestByChance / std::max(forms, 1.0)) * rms *
         std::sqrt(std::min(alike_s / acts_s, 1.0));
}

/// Whether what happens once surely begins before it ends: else nothing tells when it was.
bool isAtATime(const EffectTerm& term) {
  const OncePart* once = findEffect(term.effect)->once();
  if (once == nullptr) return true;
  const Parameter& start = term.parameters[once->start];
  return start.high95 < start.value + term.parameters[once->duration].value;
}

/// Whether a fitted figure beside the amplitude is known.
bool anotherIsKnown(const EffectTerm& term, Axis axis, const Criteria& criteria) {
  for (size_t k = 1; k < term.parameters.size(); ++k) {
    if (term.parameters[k].low95 < term.parameters[k].high95 && isKnown(term, k, axis, criteria)) return true;
  }
  return false;
}

}  // namespace

bool worthSaying(const EffectTerm& term, const Model& model, const Excitation& seen, const TorqueNoise& left,
                 const Criteria& criteria) {
  const Parameter& amplitude = term.parameters.front();
  if (amplitude.low95 < 0.0 && amplitude.high95 > 0.0) return false;
  if (!findEffect(term.effect)->plausible(valuesOf(term), seen)) return false;  // the last fit may have moved it
  if (!isAtATime(term)) return false;
  if (!isKnown(term, 0, model.axis, criteria) && !anotherIsKnown(term, model.axis, criteria)) return false;
  const auto torque = torqueOf(amplitude.name, amplitude.value, seen);
  if (!torque) return true;
  const Physics physics = physicsOf(model);
  const double wander = std::min(left.rms, mostWander(physics.coulomb, seen.peakTorque, criteria));
  const double most = std::abs(physics.torquePerInput()) * seen.peakInput;
  if (*torque < criteria.immaterial * physics.coulomb) return false;
  return *torque > largestOfWander(term, left, wander, seen, criteria) && *torque <= std::max(most, seen.peakTorque);
}

bool isKnown(const EffectTerm& term, size_t number, Axis axis, const Criteria& criteria) {
  const Parameter& one = term.parameters[number];
  const ParameterSpec spec = findEffect(term.effect)->parameters(axis)[number];
  if (spec.held || spec.lower < 0.0 || one.low95 == one.high95) return true;
  return one.low95 > 0.0 && one.high95 <= criteria.farMore() * one.low95;
}

}  // namespace breakaway
