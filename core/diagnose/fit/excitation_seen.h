// What recordings have seen of a rig, by their motion and a model's torques.
#pragma once

#include <vector>

#include "diagnose/model/excitation.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// Speeds, travel and torques that the recordings show.
Excitation excitationOf(const std::vector<Track>& tracks, const Model& model);

}  // namespace breakaway
