// Which effects the inverse model asks for: linear, so that it sees several at once where the simulation is still far
// off.
#pragma once

#include <vector>

#include "diagnose/effect.h"
#include "diagnose/simulate/model.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

struct Proposal {
  const Effect* effect = nullptr;
  Shape shape;
  std::vector<double> amplitude;
};

/// Orthogonal matching pursuit (Y. C. Pati, R. Rezaiifar, P. S. Krishnaprasad, Asilomar 1993) on the inverse model: the
/// effect and shape that takes most of the torque residual is added, all amplitudes are fitted again, and so on, until
/// the next takes less than 3 % or `most` are found. Amplitudes are those of the last fit. A proposal is no finding:
/// only the simulated windows decide.
std::vector<Proposal> inverseProposals(const Model& model, const std::vector<Track>& tracks,
                                       const std::vector<const Effect*>& effects, const Excitation& seen, size_t most);

}  // namespace breakaway
