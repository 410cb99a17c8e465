// What recordings can show of each effect of the catalogue, by the sensitivity of the simulated base model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnose/fit/torque_noise.h"
#include "diagnose/model/effect.h"
#include "diagnose/search/model_fit.h"
#include "diagnose/search/worth.h"

namespace breakaway {

/// What stands in the way of an effect that is smaller yet.
enum class SightLimit {
  sensors,    ///< its error drowns in what sensors and the model's other errors make
  wander,     ///< its torque drowns in the torque that wanders
  smallness,  ///< no rig is so exact that it would matter
  grid        ///< the smallest size that is looked for
};
const char* nameOf(SightLimit limit);

/// One effect, as recordings like these show it.
struct Sight {
  const Effect* effect = nullptr;
  std::vector<Parameter> smallest;  ///< its parameters at the smallest size that would be found; empty: none would
  std::optional<double> torque;     ///< what that makes at the most, Nm or N; nothing where it is no torque
  SightLimit limit = SightLimit::sensors;
  std::string why;         ///< where none would be found
  std::string experiment;  ///< that makes it visible, or smaller ones; empty: none with this drive

  bool shown() const { return !smallest.empty(); }
};

/// For each effect, at some of the shapes that the search would try: the least amplitude at which windows simulated
/// without it, base and start refitted (by their linearisation at `base`), are worse by what the search takes for
/// material (Worth::leastBack()), and which is worth saying beside `wander`. Of shapes whose sizes don't scale, the
/// least one. An order of magnitude is what it is good for: none is found at a quarter, all are at eight times. The
/// base's fit has split.train's windows.
std::vector<Sight> sightOf(const SearchInput& input, const FitResult& base, const Worth& worth,
                           const TorqueNoise& wander);

}  // namespace breakaway
