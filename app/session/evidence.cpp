#include "session/evidence.h"

#include <algorithm>

#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/preparation.h"

namespace breakaway {

namespace {

constexpr std::uint64_t seed = 1;

/// The axis on which an effect is drawn, where residuals are mapped over it.
std::string axisOf(const std::string& name) {
  const Effect* effect = findEffect(name);
  if (effect == nullptr || effect->drawnOver() == "frequency") return {};
  return std::string(effect->drawnOver() == "travel" ? "reversal" : effect->drawnOver());
}

/// What there is to show: effects with their axes, else a place's.
std::vector<std::pair<std::string, std::string>> wantedOf(const Diagnosis& diagnosis) {
  std::vector<std::pair<std::string, std::string>> wanted;
  for (const Finding& finding : diagnosis.findings)
    if (const std::string axis = axisOf(finding.effect); !axis.empty()) wanted.emplace_back(finding.effect, axis);
  for (const Place& place : diagnosis.where)
    if (wanted.empty() && place.axis != "frequency") wanted.emplace_back("", place.axis);
  return wanted;
}

/// The model without this finding; without any where it is a place.
Model without(Model model, const std::string& effect) {
  std::erase_if(model.effects, [&effect](const EffectTerm& term) { return effect.empty() || term.effect == effect; });
  return model;
}

const ResidualMap* mapOver(const std::string& axis, const std::vector<ResidualMap>& maps) {
  const auto found = std::find_if(maps.begin(), maps.end(), [&](const ResidualMap& map) {
    return map.axis == axis && !map.ofSomeSpeeds() && map.shows != Unknown::voltage;
  });
  return found == maps.end() ? nullptr : &*found;
}

}  // namespace

std::vector<Evidence> evidenceOf(const Diagnosis& diagnosis, const Bench& bench, const Recording& recording,
                                 const std::optional<Recording>& heldout) {
  const auto wanted = wantedOf(diagnosis);
  if (wanted.empty()) return {};
  std::vector<Recording> others;
  if (heldout) others.push_back(*heldout);
  const auto prepared = prepare(bench, {recording}, others, diagnosis.fit.window_s);
  if (!prepared) return {};
  std::vector<Track> tracks = heldoutTracks(*prepared), whole = prepared->training;
  whole.insert(whole.end(), tracks.begin(), tracks.end());
  if (tracks.empty()) tracks = prepared->training;
  const auto before = residualMaps(diagnosis.base, tracks, seed), after = residualMaps(diagnosis.model, tracks, seed);
  std::vector<Evidence> all;
  for (const auto& [effect, axis] : wanted) {
    const ResidualMap *one = mapOver(axis, before), *other = mapOver(axis, after);
    if (one == nullptr || other == nullptr) continue;
    all.push_back({effect, QString::fromStdString(axis), diagnosis.base.axis == Axis::linear, *one, *other, {}});
    if (!diagnosis.findings.empty())
      all.back().law = explainedOver(*one, without(diagnosis.model, effect), diagnosis.model, whole);
  }
  return all;
}

}  // namespace breakaway
