// What the screen finds on a rig, and what of it is put to the simulation.
#pragma once

#include <vector>

#include "diagnose/screen/screen.h"
#include "diagnose/search/model_fit.h"

namespace breakaway {

struct Screening {
  Screening(const SearchInput& input, const LinearRig& rig, const std::vector<const Effect*>& effects)
      : screen(rig, effects, input.seen, input.split.fold, folds, input.seed, input.criteria), found(screen.run()) {}

  Screen screen;
  ScreenResult found;
};

/// The effects without loads: their own motion can follow any noise of the torque.
std::vector<const Effect*> withoutLoads(const SearchInput& input);

/// One pick of each effect, with the gains of all its waves; the largest first.
std::vector<Pick> asEffects(const std::vector<Pick>& picks);

/// The screen's set without loads and without what hardly takes anything away: simulation may still ask for it.
std::vector<Pick> noteworthy(const ScreenResult& found, const Criteria& criteria);

/// An axis has one load side: of effects that each bring one along, the most important stays.
std::vector<Pick> withOneLoad(std::vector<Pick> picks);

/// The effects that explain most alone, at most four.
std::vector<Pick> bestAlone(const Screen& screen, const Criteria& criteria);

/// The set with one member at a time exchanged for its first rival.
std::vector<std::vector<Pick>> exchanged(const Screen& screen, const std::vector<Pick>& picks);

/// The model's effects as the screen would pick them, one beside the other.
std::vector<Pick> picksOf(const Model& model, const Screen& screen);

/// The likeliest noise of the torque beside the base and `picks`.
TorqueNoise wanderBeside(const LinearRig& wandering, const std::vector<Pick>& picks);

}  // namespace breakaway
