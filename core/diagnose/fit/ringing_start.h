// Where a fit should start from if winding and rotor ring about as fast as rows follow each other.
#pragma once

#include <vector>

#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// Speeds in rows obey a recursion of second order where a voltage, constant over each row, drives a winding and a
/// rotor (L. Ljung, 'System identification', 1999, chapter 4.2):
///   v_k = a1 v_{k−1} + a2 v_{k−2} + Σ b_j u_{k−j} + c sgn v + d,
/// and its coefficients tell both poles, −R/2L ± iω, the product L J, and the friction by least squares, with nothing
/// simulated or differentiated. Rows don't tell ω from what ω looks like at their rate: a start for each.
/// Returns copies of `start` with inductance, inertia, viscous and Coulomb friction changed, trusted ones (`held`)
/// kept; none where the drive is no voltage, or the rotor doesn't ring, or slowly enough for the inverse model.
std::vector<Model> ringingStarts(const Model& start, const std::vector<Track>& tracks,
                                 const std::vector<std::string>& held);

}  // namespace breakaway
