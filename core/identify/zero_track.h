// How the current sensor's zero wandered over a sweep, from all of its zeroings.
#pragma once

#include <span>
#include <vector>

#include "base/estimate.h"
#include "friction/measurements.h"

namespace breakaway {

/// The sensor's zero over time. What the board subtracts is the last zeroing alone, with that one's noise, and grows
/// old until the next; a zero that drifts smoothly is known better from all of them.
class ZeroTrack {
 public:
  /// The polynomial of least degree (up to 2, and with a reading to spare) that the readings allow within their noise,
  /// by weighted least squares; where none does, straight lines between neighbouring readings. `noiseRms_A`: of one
  /// sample. What a coarse converter hides of the zero is common to all readings. No reading: a zero of 0 without
  /// error.
  ZeroTrack(std::vector<ZeroReading> readings, double noiseRms_A);

  /// The zero at a time within the readings, in A, counted like ZeroReading::zero_A, with its standard error.
  Estimate at(double time_s) const;

 private:
  Estimate between(double time_s) const;

  std::vector<ZeroReading> readings_;
  double noiseRms_A_ = 0.0, middle_s_ = 0.0, span_s_ = 1.0;
  double common_A_ = 0.0;                        ///< error of all readings together
  std::vector<double> coefficients_;             ///< in powers of (t − middle)/span; empty: lines between neighbours
  std::vector<std::vector<double>> covariance_;  ///< of the coefficients
};

/// The runs and breakaways with their currents counted from the track instead of from the board's last zeroing.
void countFrom(const ZeroTrack& track, std::span<VelocityRun> runs);
void countFrom(const ZeroTrack& track, std::span<BreakawayEvent> events);
void countFrom(const ZeroTrack& track, std::span<TravelRun> runs);

}  // namespace breakaway
