// A track as the inverse model sees it: position, velocity and acceleration on an even grid, by zero-phase filtering.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/simulate/track.h"

namespace breakaway {

/// Evenly spaced rows of one track. All vectors have the same length.
struct InverseRows {
  double step_s = 0.0;
  std::vector<double> time, position, velocity, acceleration, input;
  std::vector<char> moving;    ///< clearly in motion: windings connected, away from the edges and from reversals
  std::vector<char> usable;    ///< windings connected and the velocity above its noise, creeping included
  double velocityNoise = 0.0;  ///< rad/s
};

/// The filter of the inverse method. Position is resampled at the track's median step, low-passed with a fourth-order
/// Butterworth filter run forwards and backwards (zero phase), and differentiated centrally, as in M. Gautier, 'Dynamic
/// identification of robots with power model', ICRA 1997.
struct InverseFilter {
  double cutoff_Hz =
      0.0;  ///< 0: 100 Hz, at most a tenth of the sampling rate, lower where a coarse encoder asks for it
};

/// The time of each row, from 0, with pauses of more than 1000 steps cut to these: what the even grid runs over, so
/// that a clock that was set costs nothing.
std::vector<double> withoutPauses(const Track& track, double step_s);

/// Rows within a pause count as disconnected; `time` is the track's own, with its pauses.
InverseRows inverseRows(const Track& track, const InverseFilter& filter = {});

/// Columns and response, low-passed alike with zero phase at `cutoff_Hz` and decimated to five times that, as in
/// Gautier's parallel filtering; rows where `use` is 0 are dropped after filtering.
void filterAlike(Eigen::MatrixXd& columns, Eigen::VectorXd& response, const std::vector<char>& use, double step_s,
                 double cutoff_Hz);

/// Zero-phase low-pass of evenly spaced values in place, edges reflected.
void lowPass(std::vector<double>& values, double step_s, double cutoff_Hz);

}  // namespace breakaway
