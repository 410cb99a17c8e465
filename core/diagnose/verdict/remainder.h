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
  double perfect = 0.0;
  double tolerated = 0.0;  ///< the same where friction scatters, and what is left wanders a little
};

/// `left`: what the model leaves, taken for a torque that wanders: a little of that is tolerated.
Floors floorsOf(const Model& model, const Preparation& prepared, const std::vector<Window>& windows, std::uint64_t seed,
                const TorqueNoise& left);

/// Squared errors of windows that restart.
struct WindowErrors {
  std::vector<double> before, after;  ///< of the base model, and of the one in question
};

struct Remainder {
  Floors floors;
  double share = 0.0;  ///< of the base model's excess
  double pValue = 1.0;
  bool material = false;
  bool wanders = false;  ///< not material, but more than sensors do
  std::vector<Place> where;
};

/// `model` is the one of `errors.after`, which are of `prepared.split.trainScore`; `named`: it holds findings. A torque
/// that wanders is tolerated only where it has no place of its own.
Remainder remainderOf(const Model& model, bool named, const Preparation& prepared, const WindowErrors& errors,
                      const TorqueNoise& left, std::uint64_t seed);

/// Where the remainder shows: the places that hold on held-out data, too.
void findPlaces(Remainder& rest, const Model& model, const Preparation& prepared, std::uint64_t seed);

/// How much torque is left, in words.
std::string wanderRemark(const TorqueNoise& left, double friction, const Excitation& seen);

/// How many of `windows` err so much that neither sensors nor scattering friction can be the cause.
size_t farOffWindows(const Model& model, const Preparation& prepared, const std::vector<Window>& windows,
                     std::uint64_t seed, const TorqueNoise& left);
/// "8 times", in words of farOffWindows().
std::string farOffText();

}  // namespace breakaway
