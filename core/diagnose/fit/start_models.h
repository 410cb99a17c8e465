// Base models to start a fit from: what the inverse model finds, and what the bench believes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"
#include "motor/bench.h"

namespace breakaway {

/// The bench's motor before anything is known of its motion: constants, winding, down angle, and the law of a servo.
Model believedDrive(const Bench& bench);

/// A winding's resistance, assumed where voltage alone drives and the bench names none, and what it was assumed for.
struct AssumedResistance {
  double value_ohm = 0.0;
  std::string scale;  ///< "pendulum", or the bench's value that is then right: inertia, Coulomb friction, inductance
};

/// Voltage alone shows ratios to Kt/R only: the R at which the inverse model gives what the bench believes. Nothing
/// where neither recordings nor bench say anything of it.
std::optional<AssumedResistance> assumedResistance(const Bench& bench, const std::vector<Track>& tracks);

/// Base models to start from, with every parameter the bench needs: what the inverse model finds, and, where the bench
/// says enough, what it believes. Trusted values are kept in both. Errors: neither the recordings nor the bench tell
/// the inertia.
Result<std::vector<Model>> startModels(const Bench& bench, const std::vector<Track>& tracks);

}  // namespace breakaway
