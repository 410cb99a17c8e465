#include "diagnose/verdict/worth_saying.h"

#include <algorithm>
#include <cmath>

#include "base/distributions.h"
#include "diagnose/effects/catalogue.h"
#include "diagnose/search/model_fit.h"
#include "diagnose/simulate/physics.h"

namespace breakaway {

namespace {

/// What a torque that wanders makes of something that happens once: the rms of its mean over as long as that lasts, as
/// often as the largest of all places where it may be sought exceeds it by chance. Starts are half a duration apart,
/// and all longer durations together have as many places again.
double largestOfWander(const EffectTerm& term, const TorqueNoise& left, double rms, const Excitation& seen,
                       const Criteria& criteria) {
  const double alike_s = 2.0 * left.time_s;
  const auto parameter = std::find_if(term.parameters.begin(), term.parameters.end(),
                                      [](const Parameter& one) { return one.name == "duration_s"; });
  const double lasts_s = std::max(parameter == term.parameters.end() ? 0.0 : parameter->value, alike_s);
  const double places = std::max(4.0 * seen.duration_s / lasts_s, 1.0);
  return deviationsOf(criteria.likeliestByChance / places) * rms * std::sqrt(alike_s / lasts_s);
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
  if (!isKnown(term, 0, model.axis, criteria) && !anotherIsKnown(term, model.axis, criteria)) return false;
  const auto torque = torqueOf(amplitude.name, amplitude.value, seen);
  if (!torque) return true;
  const Physics physics = physicsOf(model);
  const double wander = std::min(left.rms, mostWander(physics.coulomb, seen.peakTorque, criteria));
  const double most = std::abs(physics.torquePerInput()) * seen.peakInput;
  const double least = findEffect(term.effect)->happensOnce() ? largestOfWander(term, left, wander, seen, criteria)
                                                              : criteria.beyondWander * wander;
  return *torque > least && *torque <= std::max(most, seen.peakTorque);
}

bool isKnown(const EffectTerm& term, size_t number, Axis axis, const Criteria& criteria) {
  const Parameter& one = term.parameters[number];
  const ParameterSpec spec = findEffect(term.effect)->parameters(axis)[number];
  if (spec.held || spec.lower < 0.0 || one.low95 == one.high95) return true;
  return one.low95 > 0.0 && one.high95 <= criteria.farMore() * one.low95;
}

}  // namespace breakaway
