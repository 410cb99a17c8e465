// What a model leaves of the torque and the voltage, instant by instant, with all that it may depend on.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"
#include "diagnose/verdict/place.h"
#include "diagnose/verdict/residual_spectrum.h"

namespace breakaway {

/// A place on an axis as it counts for what a map shows: for friction the drive's torque is counted along the motion.
inline double placeFor(Unknown shows, Along axis, double place, double way) {
  return shows == Unknown::friction && axis == byTorque ? way * place : place;
}

/// Unexplained torque (Nm, N) or voltage (V) at single instants.
struct Instants {
  std::vector<double> value, way;
  std::vector<size_t> block;  ///< stretches of one second, across tracks
  std::array<std::vector<double>, alongs> along;

  /// Counted along the motion for friction.
  double shown(size_t k, Unknown shows) const { return shows == Unknown::friction ? way[k] * value[k] : value[k]; }
  /// On that axis; the drive's torque is counted along the motion for friction, too.
  double place(size_t k, Along axis, Unknown shows) const { return placeFor(shows, axis, along[axis][k], way[k]); }
};

struct AllInstants {
  Instants mechanical, electrical;
  ResidualSpectrum spectrum;
  size_t blocks = 0;
  bool turns = false;  ///< a whole turn or more was seen: angles are taken within the turn
  bool temperature = false;

  const Instants& of(Unknown shows) const { return shows == Unknown::voltage ? electrical : mechanical; }
};

/// Where an instant of `u` lies on each axis; `turns`: angles are taken within the turn. Temperatures are 0 where none
/// were recorded.
std::array<double, alongs> placesAt(const Unexplained& u, size_t instant, const Track& track, bool turns);

/// `like`: angles and temperatures are taken as there.
AllInstants instantsOf(const Model& model, const std::vector<Track>& tracks, const AllInstants* like = nullptr);

}  // namespace breakaway
