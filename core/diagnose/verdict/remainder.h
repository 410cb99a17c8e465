// What the best model leaves of a recording, and whether that is more than sensors and a rig's usual ways explain.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnose/fit/preparation.h"
#include "diagnose/fit/torque_noise.h"
#include "diagnose/verdict/place.h"

namespace breakaway {

/// What windows may show if the model is right, rms.
struct Floors {
  double perfect = 0.0;     ///< of sensors and restarts
  double withWander = 0.0;  ///< the same where friction scatters, and a torque wanders as it does on sound rigs
};

/// `left`: what the model leaves, taken for a torque that wanders.
Floors floorsOf(const Model& model, const Preparation& prepared, const std::vector<Window>& windows, std::uint64_t seed,
                const TorqueNoise& left);

/// Squared errors of windows that restart.
struct WindowErrors {
  std::vector<double> before, after;  ///< of the base model, and of the one in question
};

/// What is left when the findings are taken away.
struct Remainder {
  Floors floors;
  TorqueNoise wander;        ///< of what the model leaves, as much as the windows' error has room for
  double share = 0.0;        ///< of the base model's excess, where it is more than a sound rig's
  double pValue = 1.0;       ///< of the place that shows most
  bool aboveFloor = false;   ///< more than sensors do, in the typical window or in several
  bool wanders = false;      ///< it is above the floor, and wanders by more than a sound rig does
  std::vector<Place> where;  ///< that foretell what was held out

  double part = 1.0;       ///< what is left of the base model's excess, whatever is usual
  bool muchIsLeft = true;  ///< more of it than any rig may lack

  /// Whether something is missing that the model doesn't have: there is evidence, and findings leave enough of it.
  bool outside() const;
};

/// `model` is the one of `errors.after`, which are of `prepared.split.trainScore`.
Remainder remainderOf(const Model& model, const Preparation& prepared, const WindowErrors& errors,
                      const TorqueNoise& left, std::uint64_t seed);

/// Adds where the remainder shows: the places that are large enough to matter and foretell held-out data.
void findPlaces(Remainder& rest, const Model& model, const Preparation& prepared, std::uint64_t seed);

/// How much the torque wanders, in words.
Message wanderRemark(const TorqueNoise& left, double friction, const Excitation& seen, const Criteria& criteria);

/// How many of `windows` err so much that neither sensors nor scattering friction can be the cause.
size_t farOffWindows(const Model& model, const Preparation& prepared, const std::vector<Window>& windows,
                     std::uint64_t seed, const TorqueNoise& left);
/// "8 times", in words of farOffWindows().
Message farOffText(const Criteria& criteria);

}  // namespace breakaway
