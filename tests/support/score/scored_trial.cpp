#include "score/scored_trial.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/numbers.h"
#include "diagnose/effects/catalogue.h"

namespace breakaway {

namespace {

/// Moves an angle and its interval by whole turns to where the truth is.
void unwrap(ScoredParameter& angle) {
  const double shift = turn_rad * std::round((angle.truth - angle.value) / turn_rad);
  angle.value += shift;
  angle.low95 += shift;
  angle.high95 += shift;
}

/// Effects may describe the same wave with a negative amplitude half a turn on: the truth's sign is taken.
void alignSign(std::vector<ScoredParameter>& parameters) {
  if (parameters.empty() || !parameters.front().amplitude) return;
  const auto phase = std::find_if(parameters.begin(), parameters.end(),
                                  [](const ScoredParameter& one) { return one.name == "phase_rad"; });
  ScoredParameter& size = parameters.front();
  if (phase == parameters.end()) return;
  if (size.value * size.truth < 0.0) {
    size = {size.effect, size.name, true, size.truth, -size.value, -size.high95, -size.low95};
    for (double* angle : {&phase->value, &phase->low95, &phase->high95}) *angle += std::numbers::pi;
  }
  unwrap(*phase);
}

std::vector<ScoredParameter> shared(const Concealed& concealed, const Finding& finding) {
  std::vector<ScoredParameter> parameters;
  for (const Parameter& one : finding.parameters) {
    const auto truth = std::find_if(concealed.parameters.begin(), concealed.parameters.end(),
                                    [&one](const auto& pair) { return pair.first == one.name; });
    if (truth == concealed.parameters.end() || !std::isfinite(one.low95) || !std::isfinite(one.high95)) continue;
    parameters.push_back(
        {finding.effect, one.name, &one == finding.parameters.data(), truth->second, one.value, one.low95, one.high95});
  }
  alignSign(parameters);
  return parameters;
}

}  // namespace

ScoredTrial judge(const SealedTrial& trial, const Result<Diagnosis>& diagnosis) {
  ScoredTrial scored;
  scored.family = trial.family;
  scored.seed = trial.seed;
  scored.outside = trial.outside;
  if (trial.outside.empty()) {
    for (const Concealed& one : trial.truth) scored.truth.push_back(one.effect);
  }
  if (!diagnosis) {
    scored.error = diagnosis.error().message();
    return scored;
  }
  scored.verdict = nameOf(diagnosis->verdict);
  scored.before = diagnosis->fit.heldoutBefore;
  scored.after = diagnosis->fit.heldoutAfter;
  scored.floor = diagnosis->fit.floor;
  scored.named_s = diagnosis->named_s;
  scored.elapsed_s = diagnosis->elapsed_s;
  std::set<std::string> first, final;
  for (const std::string& name : diagnosis->firstNames) first.insert(countedAs(name));
  for (const Finding& finding : diagnosis->findings) final.insert(countedAs(finding.effect));
  scored.agreementKnown = true;
  scored.agrees = first == final;
  for (const Finding& finding : diagnosis->findings) {
    scored.answer.push_back({finding.effect, finding.ambiguousWith});
    for (const Concealed& one : trial.truth) {
      if (one.effect != finding.effect) continue;
      const auto parameters = shared(one, finding);
      scored.parameters.insert(scored.parameters.end(), parameters.begin(), parameters.end());
    }
  }
  return scored;
}

}  // namespace breakaway
