// Whether a map of what a model leaves holds on data that it wasn't learned from.
#pragma once

#include <cstdint>

#include "diagnose/fit/preparation.h"
#include "diagnose/fit/unexplained.h"
#include "diagnose/verdict/instants.h"
#include "diagnose/verdict/where.h"

namespace breakaway {

/// What the map over one axis takes away from held-out instants; the interval by a bootstrap over their seconds.
Foretold foretold(const ResidualMap& map, Along axis, const Instants& heldout, std::uint64_t seed);
/// Held-out windows with what maps foretell as a torque of the simulation's own: an artefact of filtered accelerations
/// takes nothing away.
class ForetoldWindows {
 public:
  /// Both live longer than this.
  ForetoldWindows(const Model& model, const Preparation& prepared);

  /// What the map takes away from the windows' squared error. Precondition: not of voltage.
  Foretold foretold(const ResidualMap& map, std::uint64_t seed) const;

 private:
  const Model& model_;
  const Preparation& prepared_;
  std::vector<double> before_;            ///< squared errors without
  std::vector<Unexplained> unexplained_;  ///< by track; empty where nothing is held out
};

/// The same of what goes along with the drive, band by band, and with the motion: the lesser of both.
Foretold foretold(const ResidualSpectrum& learned, const ResidualSpectrum& heldout, std::uint64_t seed);

}  // namespace breakaway
