// A load that swings, driven by the encoder's own readings: what it does depends on where the motor is, not on why.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "diagnose/model/effect.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// Runs along a track from the middle of one row to the middle of the next, where speeds from reading to reading hold.
/// The readings aren't smoothed: the load's inertia does that, and no spring is too fast for it.
class FollowedLoad {
 public:
  /// Moving with the motor in the middle of `row`. Preconditions: the effect has a load(); two rows follow.
  FollowedLoad(const Effect& effect, std::span<const double> parameters, const Track& track, size_t row);

  size_t row() const { return row_; }
  /// Precondition: row() + 2 < rows.
  void advance();
  /// On the motor, Nm.
  double torque() const;
  /// Relative to the motor, rad and rad/s.
  double place() const { return memory_[0]; }
  double speed() const { return memory_[1]; }
  /// The motor's from this row to the next, rad/s.
  double motorSpeed() const { return motor_; }

 private:
  const Effect& effect_;
  const LoadPart& load_;
  std::vector<double> parameters_;
  const Track& track_;
  size_t row_, size_;
  double longest_s_, now_s_, motor_;
  std::array<double, 8> memory_{};
};

}  // namespace breakaway
