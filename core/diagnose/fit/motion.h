// The motion behind a track, smoothed, and the hidden states that effects would have along it.
#pragma once

#include <vector>

#include "diagnose/fit/window.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/stepper.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// Velocity and acceleration by zero-phase filtering (fit/inverse_rows.h). The axis rests where its position stays
/// within one count, or four times the reading noise, for a twentieth of a second.
Motion motionOf(const Track& track);

/// The state that a window starts from as far as measurements can't tell it: hidden states of the model's effects after
/// the measured motion up to there, standstill and reversals. One per window, all else zero.
std::vector<MotionState> hiddenStates(const Model& model, const std::vector<Track>& tracks,
                                      const std::vector<Window>& windows);

}  // namespace breakaway
