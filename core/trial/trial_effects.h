// What a sealed trial can conceal: how each piece of physics is sized, and what rig and course show it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "trial/sealed_trial.h"
#include "trial/trial_course.h"
#include "trial/trial_rig.h"

namespace breakaway {

/// One piece of physics.
struct TrialEffect {
  std::string name;  ///< the catalogue's, or the plant's own outside it
  TrialNeeds needs;
  std::vector<TrialMove> moves;  ///< that show it
  double shortest_s = 30.0;      ///< of a recording that shows it
  /// Puts it into the rig, `size` times as large as it typically is, and says what was put there.
  Concealed (*conceal)(TrialRig& rig, const TrialCourse& course, double size, Random& random) = nullptr;
  /// By what leaving it out costs. Else as it is drawn: what merely shows in the current, a stop, which is in the way
  /// or isn't, and torque at random, which is any rig's own where there is little of it.
  bool sized = true;
};

/// The catalogue's 27 effects, by its names.
const std::vector<TrialEffect>& catalogueEffects();
/// Physics that no entry of the catalogue holds, alone or in pairs.
const std::vector<TrialEffect>& outsideEffects();
/// The effect of that name. Precondition: there is one.
const TrialEffect& trialEffectNamed(std::string_view name);

}  // namespace breakaway
