// Whether a model's motion can be foreseen from the recorded drive, or its errors have to be counted in torque.
#pragma once

#include <optional>

#include "diagnose/fit/window.h"
#include "diagnose/model/model.h"
#include "diagnose/search/model_fit.h"

namespace breakaway {

/// In what errors are counted, over windows of which length.
struct Counting {
  ErrorIn errorIn = ErrorIn::motion;
  double window_s = 0.5;
};

/// A rotor that falls from one well into the next can't be replayed for long from a measured current: noise grows, and
/// a perfect model errs by as much as one that lacks the wells. Where a perfect model's error is the smallest beside
/// that of `base`, if `proposed`, base and what the screen finds, were the rig: in motion over windows from
/// `split.window_s` downwards, or, where `mayTurnToTorque`, in torque. Nothing as long as a perfect model errs less
/// than `base` over the windows as they are.
std::optional<Counting> betterCounting(const SearchInput& input, const Model& base, const Model& proposed);

/// Where friction changes along the way by more than the base model knows, and a controller holds the motion up, a body
/// too heavy (or too light) to be moved by it errs least over a window. By how many times the inertia of `base` is that
/// which torque and acceleration show, if that is beyond what any bench is wrong by; `inverse` is by these.
std::optional<double> runAway(const Model& base, const Model& inverse, const Criteria& criteria);

}  // namespace breakaway
