// One recording as the fit and the simulation see it: SI arrays, gaps filled, what can't be used masked.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/result.h"
#include "motor/bench.h"
#include "recording/recording.h"

namespace breakaway {

/// The motion that a track shows, smoothed, for whoever looks at it as a whole. One entry per row.
struct Motion {
  std::vector<double> velocity, acceleration;
  std::vector<char> resting;   ///< stands still
  std::vector<double> rest_s;  ///< how long the last standstill lasted, or lasts by now
  std::vector<double> turned;  ///< position of the last reversal
  std::vector<double> way;     ///< ±1: direction of motion, or of the last one
  double velocityNoise = 0.0;
};

/// All vectors have one entry per row. On a linear axis read m for rad and N for Nm.
struct Track {
  std::string name;
  std::vector<double> time;      ///< s since the first row
  std::vector<double> position;  ///< rad, the middle of the recorded count; rows without one hold the last value and
                                 ///< are not `seen`
  std::vector<double> speed;     ///< rad/s, as recorded, where that alone was: positions are its integral; else empty
  /// Volts, amperes or torque that act from the row to the next; where a reference drives, what the law makes of the
  /// recorded motion, once reconstructInput() ran.
  std::vector<double> input;
  std::vector<double> reference;       ///< rad, what a servo was asked for from the row to the next, where that drives
  std::vector<double> referenceSpeed;  ///< rad/s, the same; empty: not recorded
  std::vector<double> missingDoubt;  ///< how far the input may have been off in the rows missing after one; empty: none
  std::vector<double> push;          ///< added to what the law of a servo makes, in units of the input; empty: nothing
  std::vector<char> seen;            ///< the row has a position
  std::vector<char> bridged;         ///< its position lies on the line between two readings that are near; empty: none
  std::vector<char> connected;       ///< windings not open
  std::vector<double> current;  ///< measured current in A where voltage or duty drives and it was recorded; else empty
  std::vector<double> voltage;  ///< recorded one in V where current drives; else empty
  std::vector<double> supply;   ///< recorded supply in V; empty: not recorded
  std::vector<double> temperature;  ///< recorded temperature in °C; empty: not recorded
  double supply_V = 0.0;            ///< of the bench; 0: not known
  DriveInput drive = DriveInput::torque;
  double origin_s = 0.0;      ///< time_s of the first row
  double usualStep_s = 0.0;   ///< median time from row to row
  double noise = 0.0;         ///< standard deviation of one position reading: quantisation and what exceeds it
  double quantisation = 0.0;  ///< standard deviation of what the encoder's count hides
  double speedNoise = 0.0;    ///< as `noise`, of a reading of `speed`, rad/s
  double speedCount = 0.0;    ///< step of the readings of `speed`, rad/s; 0: none is seen
  double inputNoise = 0.0;    ///< the same of a measured drive, A or V; 0 where the input is a command
  double currentNoise = 0.0;  ///< the same of a current reading, A; 0 where there is none
  std::vector<Message> remarks;

  // Filled in by prepare(); empty otherwise.
  std::vector<size_t> leaps;  ///< rows after which the position leaps
  Motion motion;

  size_t rows() const { return time.size(); }
  /// How many rows are missing after `row`.
  size_t missingAfter(size_t row) const {
    return row + 1 < rows()
               ? static_cast<size_t>(std::max(0.0, std::round((time[row + 1] - time[row]) / usualStep_s) - 1.0))
               : 0;
  }
  /// Variance of the input's integral over the step after `row`: by what acted in missing rows, which nobody knows.
  double missingInput(size_t row) const {
    if (missingDoubt.empty()) return 0.0;
    const double step_s = missingDoubt[row] * usualStep_s;
    return step_s * step_s * static_cast<double>(missingAfter(row));
  }
  bool speedAlone() const { return !speed.empty(); }
  /// What was measured in a row: the position, in a recording of speed alone the speed.
  double reading(size_t row) const { return speedAlone() ? speed[row] : position[row]; }
  double readingNoise() const { return speedAlone() ? speedNoise : noise; }
  /// A copy of rows [first, last], without the smoothed motion; times keep their origin.
  Track rowsFrom(size_t first, size_t last) const;
  /// Whether the row's position can be taken for the axis' own, read or bridged.
  bool placed(size_t row) const { return seen[row] != 0 || (!bridged.empty() && bridged[row] != 0); }
  double supplyAt(size_t row) const { return supply.empty() ? supply_V : supply[row]; }
};

/// The longest of the tracks' usual rows, s.
double longestRow_s(const std::vector<Track>& tracks);

/// Reads what `input` and `axis` need from the recording. `count` is one encoder count in rad or m (0: unknown).
/// Without a position column
/// the velocity's is what was measured. Errors: a needed column is missing or has no value at all; fewer than two rows.
/// `byReference`: the recording holds what a servo was asked for, and `input` is what its law gives out.
Result<Track> makeTrack(const Recording& recording, Axis axis, DriveInput input, std::optional<double> supply_V,
                        double count, bool byReference = false);

/// The mean over [from_s, to_s] of values that each hold from their row's time until the next; `near` is a row near the
/// beginning.
double heldMean(const std::vector<double>& time, const std::vector<double>& values, double from_s, double to_s,
                size_t near);

/// The positions of a track of speed alone, from 0 on by trapezoids.
void integrateSpeed(Track& track);

/// Puts positions that were not read on the line between their neighbours; those nearer to one another than `near_s`
/// become `bridged`. Looks ahead, so not for who predicts.
void bridgePositions(Track& track, double near_s);

}  // namespace breakaway
