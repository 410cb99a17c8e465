#include "session/evidence.h"

#include <algorithm>

#include "diagnose/effects/catalogue.h"
#include "diagnose/fit/preparation.h"

namespace breakaway {

namespace {

constexpr std::uint64_t seed = 1;

/// The axis on which the first finding is drawn, where residuals are mapped over it.
std::string axisOf(const Diagnosis& diagnosis) {
  if (!diagnosis.findings.empty()) {
    const Effect* effect = findEffect(diagnosis.findings.front().effect);
    if (effect != nullptr && !effect->drawnOver().empty() && effect->drawnOver() != "frequency")
      return std::string(effect->drawnOver() == "travel" ? "reversal" : effect->drawnOver());
  }
  for (const Place& place : diagnosis.where)
    if (place.axis != "frequency") return place.axis;
  return {};
}

const ResidualMap* mapOver(const std::string& axis, const std::vector<ResidualMap>& maps) {
  const auto found = std::find_if(maps.begin(), maps.end(), [&](const ResidualMap& map) {
    return map.axis == axis && !map.ofSomeSpeeds() && map.shows != Unknown::voltage;
  });
  return found == maps.end() ? nullptr : &*found;
}

}  // namespace

std::optional<Evidence> evidenceOf(const Diagnosis& diagnosis, const Bench& bench, const Recording& recording,
                                   const std::optional<Recording>& heldout) {
  const std::string axis = axisOf(diagnosis);
  if (axis.empty()) return {};
  std::vector<Recording> others;
  if (heldout) others.push_back(*heldout);
  const auto prepared = prepare(bench, {recording}, others, diagnosis.fit.window_s);
  if (!prepared) return {};
  std::vector<Track> tracks = heldoutTracks(*prepared);
  if (tracks.empty()) tracks = prepared->training;
  const auto before = residualMaps(diagnosis.base, tracks, seed), after = residualMaps(diagnosis.model, tracks, seed);
  const ResidualMap *one = mapOver(axis, before), *other = mapOver(axis, after);
  if (one == nullptr || other == nullptr) return {};
  return Evidence{QString::fromStdString(axis), diagnosis.base.axis == Axis::linear, *one, *other};
}

}  // namespace breakaway
