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
  double leastInductance_H = 0.0;  ///< as far as rows show it, from here to the next
  double mostInductance_H = 0.0;
  double left = 0.0;  ///< part of the current's squared integrals that they leave
};

/// By least squares on the voltage balance, integrated over spans of some rows, so that nothing is differentiated:
///   ∫u = R ∫i + L Δi + Ke Δx;  as rows have it, R times a part of a row comes with L;
/// beside a zero of the current's sensor and a voltage that the bridge loses by the current's sign, where these explain
/// more. Standard errors are clustered by second. Of the voltage that drives with the current beside it, or the other
/// way round. Nothing where a track has only one of the two, or where they don't change. Precondition: tracks carry
/// their motion.
std::optional<ShownWinding> shownWinding(const std::vector<Track>& tracks);

}  // namespace breakaway
