// What an axis is made to do in an experiment: a course of speeds and currents that a board can follow.
#pragma once

#include <initializer_list>
#include <vector>

namespace breakaway {

/// A speed or a current that goes from one value to another in a straight line; or a sine of growing frequency.
struct ManeuverStretch {
  enum class Of { speed, current };
  Of of = Of::speed;
  double duration_s = 0.0;
  double from = 0.0, to = 0.0;         ///< rad/s (m/s) or A; of a sine its amplitude at begin and end
  double low_Hz = 0.0, high_Hz = 0.0;  ///< of a sine; 0: none

  /// At `time_s` since the stretch began.
  double at(double time_s) const;
};

/// Empty: no board can do it alone.
using Maneuver = std::vector<ManeuverStretch>;

double durationOf(const Maneuver& motion);
Maneuver operator+(Maneuver first, const Maneuver& then);

/// Each speed over `way` (rad or m) one way and back, for at least 1 s and at most 20 s each.
Maneuver speedsBothWays(std::initializer_list<double> speeds, double way);
/// To and fro at a speed, without a rest.
Maneuver reversals(double speed, int count, double each_s);
/// Slowly through standstill, from one way to the other and back.
Maneuver throughStandstill(double speed, int times, double each_s);
/// Starts from rests of these lengths in turn, one way and the other.
Maneuver startsFromRest(double speed, std::initializer_list<double> rests_s, int count);
/// Each current one way and the other at once, so that the speed comes back.
Maneuver currentPulses(std::initializer_list<double> currents_A, double each_s, double rest_s);
/// Current up and down in ramps, both ways.
Maneuver currentRamps(double peak_A, int times, double each_s);
Maneuver currentChirp(double amplitude_A, double low_Hz, double high_Hz, double duration_s);

}  // namespace breakaway
