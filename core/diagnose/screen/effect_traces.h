// What an effect would do along a recorded motion: the raw columns of the linear rig.
#pragma once

#include <vector>

#include "diagnose/model/effect.h"
#include "diagnose/simulate/stepper.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// The end of a standstill: the last row at rest, and the way that motion then goes.
struct RecordedStart {
  size_t row = 0;
  double direction = 0.0;
};

/// The recorded motion of one track as terms see it.
class RecordedMotion {
 public:
  RecordedMotion(const Track& track, const Physics& physics);

  const Situation& at(size_t row) const { return at_[row]; }
  /// Whether the row moves clearly one way.
  bool usable(size_t row) const { return usable_[row] != 0; }

 private:
  friend class EffectTraces;
  /// Rows [first, first + rows) that no torque changes along: what has no memory is looked at once in their middle.
  struct Block {
    Situation at;
    size_t first = 0, rows = 1;
    bool usable = false;
  };
  void divide(double step_s);

  std::vector<Situation> at_;
  std::vector<double> slope_;  ///< of the current, A/s
  std::vector<char> usable_;
  std::vector<Block> blocks_;
};

/// What an effect does along one track: a value per row, empty where it does nothing.
class EffectTraces {
 public:
  EffectTraces(const Effect& effect, const std::vector<double>& parameters, const Track& track,
               const RecordedMotion& motion, const Physics& physics, const std::vector<RecordedStart>& starts);

  std::vector<double> torque;    ///< Nm
  std::vector<double> voltage;   ///< lost, V
  std::vector<double> input;     ///< change of the drive's input
  std::vector<double> shown;     ///< change of what the encoder shows, rad
  std::vector<double> sensed;    ///< change of what the current sensor shows, A
  std::vector<double> starting;  ///< Nm at each of `starts`

 private:
  void forget(const Effect& effect, const std::vector<double>& p, const RecordedMotion& motion);
  void remember(const Effect& effect, const std::vector<double>& p, const Track& track, const RecordedMotion& motion,
                double coulomb);
  /// For a load that swings. Where it hangs on a spring faster than smoothed motion shows, the encoder's own readings
  /// drive it: integrated twice, their noise stays as small as it is.
  void follow(const Effect& effect, const std::vector<double>& p, const Track& track);
};

}  // namespace breakaway
