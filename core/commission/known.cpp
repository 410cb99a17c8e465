#include "commission/known.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {

Estimate meanOfWays(const Estimate& one, const Estimate& other) {
  return {0.5 * (one.value + other.value), 0.5 * std::hypot(one.standardError, other.standardError)};
}

/// What is computed from these, and would be another one.
Facts computedFrom(const Facts& facts) {
  Facts computed;
  if (facts.hasAny({Known::windingTest, Known::roughMotor, Known::reversal, Known::bridge}))
    computed.add({Known::roughMotor, Known::reversal, Known::bridge, Known::motor});
  if (facts.hasAny({Known::windingTest, Known::roughMotor, Known::bridge, Known::motor}))
    computed.add({Known::straight, Known::carefulGains, Known::runs, Known::map});
  if (facts.hasAny({Known::ends})) computed.add({Known::index});
  if (facts.hasAny({Known::runs, Known::breakaways})) computed.add({Known::map});
  if (computed.has(Known::map) || facts.has(Known::map))
    computed.add({Known::stribeck, Known::gainsInUse, Known::comparison});
  if (facts.has(Known::gainsInUse)) computed.add({Known::comparison});
  return computed;
}

}  // namespace

Facts withComputed(Facts facts) {
  for (Facts before; !(before == facts);) {
    before = facts;
    facts.add(computedFrom(facts));
  }
  return facts;
}

std::optional<Estimate> Commission::coulombAverage_Nm() const {
  if (!knows(Known::runs)) return {};
  return meanOfWays(moving[0].coulombMean_Nm, moving[1].coulombMean_Nm);
}

std::optional<Estimate> Commission::viscousAverage_Nm_s_per_rad() const {
  if (!knows(Known::runs)) return {};
  return meanOfWays(moving[0].viscousMean_Nm_s_per_rad, moving[1].viscousMean_Nm_s_per_rad);
}

void Commission::remark(const Message& text) {
  if (std::find(remarks.begin(), remarks.end(), text.english()) == remarks.end()) remarks.push_back(text);
}

void Commission::contradict(const Message& text) {
  const Message whole = message("In spite of a contradiction: {}.", text);
  remark(whole);
  if (std::find(contradictions.begin(), contradictions.end(), whole.english()) == contradictions.end())
    contradictions.push_back(whole);
}

void Commission::forget(const Facts& named) {
  const Facts gone = withComputed(named);
  facts.remove(gone);
  if (named.has(Known::runs)) runs.clear(), strokes.clear();
  if (named.has(Known::breakaways)) breakaways.clear(), missed = 0;
  if (gone.has(Known::runs) && knows(Known::motor)) motor = identified;
  if (!gone.has(Known::map)) return;
  map = {};
  events.clear();
  compensatedRun.reset();
  tunedForUse = false;
  if (knows(Known::motor))
    motor.coulomb_Nm = identified.coulomb_Nm, motor.viscous_Nm_s_per_rad = identified.viscous_Nm_s_per_rad;
}

Facts Commission::otherThan(const SweepSettings& asked) const {
  const bool otherBins = asked.bins != sweeps.bins;
  Facts others;
  if (otherBins || asked.turns != sweeps.turns) others.add({Known::breakaways});
  if ((otherBins && linear()) || !asked.sameSpeeds(sweeps))
    others.add({Known::runs});  // strokes are taken apart into bins
  return others;
}

void Commission::forgetOtherThan(const SweepSettings& asked) {
  forget(otherThan(asked));
  sweeps = asked;
}

void Commission::forgetBoard() {
  facts.remove({Known::sensorZero, Known::wiring, Known::ends, Known::straight, Known::carefulGains, Known::index,
                Known::gainsInUse});
  if (!knows(Known::motor)) forget({Known::windingTest});
}

}  // namespace breakaway
