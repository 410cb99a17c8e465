// What voltage, current and motion say of a winding, where all three were recorded.
#pragma once

#include <optional>
#include <vector>

#include "base/estimate.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// A winding's constants as recorded: a column of the wrong sign makes the first two negative.
struct ShownWinding {
  Estimate resistance_ohm;
  Estimate backEmf;  ///< V s/rad or V s/m
  double inductance_H = 0.0;
  double leastInductance_H = 0.0;  ///< from here to the next, the lag leaves hardly more than at its best
  double mostInductance_H = 0.0;
  double left = 0.0;  ///< part of the squared current that they leave
};

/// By least squares on i = lag(u)/R − lag(ω) Ke/R, at the lag L/R of 20 µs to 70 ms that leaves least; beside a zero of
/// the current's sensor and a voltage that the bridge loses by the current's sign, where these explain more. Standard
/// errors are clustered by second. Of the voltage that drives with the current beside it, or the other way round.
/// Nothing where a track has only one of the two, or where they don't change. Precondition: tracks carry their motion.
std::optional<ShownWinding> shownWinding(const std::vector<Track>& tracks);

}  // namespace breakaway
