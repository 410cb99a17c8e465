// Where simulation and recording part: what the model can't explain, mapped over time, angle, velocity and more.
#pragma once

#include <complex>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "diagnose/model/criteria.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"
#include "diagnose/verdict/place.h"

namespace breakaway {

/// An order of the turn: so many waves per turn.
struct Order {
  int number = 0;
  double amplitude = 0.0;
};

/// The strongest order of the turn as it is from a speed on, up to where the next class begins.
struct WaveFrom {
  double speed = 0.0;
  double cosine = 0.0, sine = 0.0;  ///< Nm
};

/// Mean of the unexplained over one axis; cells with little data are NaN.
struct ResidualMap {
  std::string axis;  ///< as Place has it
  std::string unit;  ///< of the axis: "rad", "Hz" …; "current" is the motor torque in Nm, for voltage the current in A
  Unknown shows = Unknown::torque;
  std::vector<double> centre;           ///< of the cells, in `unit`
  std::vector<double> width;            ///< of the cells
  std::vector<double> mean;             ///< Nm (N on a linear axis) that the drive gives beyond what the model needs; V
  std::vector<double> error;            ///< standard error of the mean, from stretches of one second
  std::vector<double> rising, falling;  ///< the mean while moving towards growing and falling angle
  std::vector<double> count;
  std::vector<Order> orders = {};                               ///< over whole turns: the strongest, at most three
  double fromSpeed = -std::numeric_limits<double>::infinity();  ///< the map is of these speeds only
  double toSpeed = std::numeric_limits<double>::infinity();
  int waveOrder = 0;
  std::vector<WaveFrom> waves = {};  ///< where not all speeds are alike: of each class of speeds, the slowest first
  Along along = alongs;
  bool withinTurn = false;                   ///< angles are taken within the turn
  std::vector<std::complex<double>> answer;  ///< over frequency: what is missing per torque of the drive, by cell
  double share = 0.0;  ///< part of the unexplained square that lies in these means, chance taken off
  double pValue = 1.0;
  Foretold foretells;

  bool ofSomeSpeeds() const { return fromSpeed > -std::numeric_limits<double>::infinity(); }
  /// What the map expects at a place on its axis; 0 where it knows nothing. Precondition: not over frequency.
  double at(double place) const;
  /// The same with all that was learned of other speeds than those that the map shows.
  double at(double place, double speed) const;
};

/// Maps over every axis that the tracks show. Significance by sign flips of whole seconds, maximum over all maps.
/// `heldout`: what the maps foretell of these. `wander_s`: correlation time of torque that wanders at random, which
/// falls into the same cells for that long: as many seconds flip as one.
std::vector<ResidualMap> residualMaps(const Model& model, const std::vector<Track>& tracks, std::uint64_t seed,
                                      const std::vector<Track>& heldout = {}, double wander_s = 0.0);

/// Of two maps over the same axis: whether the first is the one to look at. What is alike at all speeds is simpler.
bool showsMore(const ResidualMap& map, const ResidualMap& other, const Criteria& criteria = {});

/// The stretches of the significant maps where it is worst, at most one per axis for the mechanics and one for the
/// electrical side, the largest share first.
std::vector<Place> places(const std::vector<ResidualMap>& maps, const Model& model, const Criteria& criteria = {});

/// The map with what it says of the place alone, and of the mirrored one where the axis runs through zero; whole where
/// the place is a wave or on the frequency, which nothing cuts.
ResidualMap onlyThere(ResidualMap map, const Place& place, const Criteria& criteria = {});

/// Puts the place on that axis (Effect::drawnOver()) first where it shows nearly as much as the first one.
void preferAxis(std::vector<Place>& places, std::string_view axis, const Criteria& criteria);

}  // namespace breakaway
