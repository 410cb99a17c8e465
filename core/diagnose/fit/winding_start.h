// A first look at the winding, where the bench doesn't know it or is far off.
#pragma once

#include <optional>
#include <vector>

#include "diagnose/simulate/track.h"
#include "motor/bench.h"

namespace breakaway {

struct StartingWindings {
  std::vector<Bench> benches;
  std::vector<double> shownInductance_H;  ///< least and most by the current, where it is recorded
};

/// Benches whose winding a fit should start from: the bench as it is; where voltage drives and the recorded current
/// shows that it knows the winding not at all or is far off, with what the current shows in the place of what isn't
/// trusted; where no current is recorded and the inductance isn't known, with some that are usual. Precondition: tracks
/// carry their motion.
StartingWindings startingWindings(const Bench& bench, const std::vector<Track>& tracks);

}  // namespace breakaway
