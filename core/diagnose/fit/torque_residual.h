// What a model leaves of the torque along the motion that a window shows.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "diagnose/fit/inverse_rows.h"
#include "diagnose/fit/window.h"
#include "diagnose/model/model.h"
#include "diagnose/simulate/track.h"

namespace breakaway {

/// The torque balance of the inverse model, drive − resistance − J a, along the recorded motion: of slow motion that is
/// held up by a controller, the torque tells far more than the motion that it makes. Drive and motion are low-passed
/// alike at 50 Hz, a twentieth of the sampling rate at most, as in Gautier's parallel filtering (fit/inverse_rows.h).
class TorqueResidual {
 public:
  TorqueResidual(const Track& track, const Window& window);
  /// How far before and behind a window the filters reach.
  static double margin_s(const Track& track);
  /// Instants in clear motion, five per period of the filter's cutoff.
  Eigen::Index rows() const { return static_cast<Eigen::Index>(kept_.size()); }
  /// One per instant, Nm (N). For models whose effects are torques at every instant.
  Eigen::VectorXd of(const Model& model) const;
  /// When they are, s since the track's first row.
  std::vector<double> times_s() const;
  /// The same instants as if something else had been recorded.
  TorqueResidual changed(const std::function<void(Track&)>& change) const;

 private:
  Track part_;  ///< the window and a little before and behind it
  double cutoff_Hz_ = 0.0;
  InverseRows along_;
  std::vector<size_t> kept_;
};

/// What a model leaves of the torque over a whole recording, for pictures.
struct TorqueTrace {
  std::vector<double> time_s;  ///< since the track's first row
  std::vector<double> torque;  ///< Nm (N); one NaN wherever the motion isn't clear for a while
  std::vector<size_t> row;     ///< of the track, at or before that time
};

TorqueTrace torqueTrace(const Model& model, const Track& track);

/// Whether a window holds at least so many rows, and of errors in torque so many instants.
bool isLongEnough(const Track& track, const Window& window, size_t rows);

}  // namespace breakaway
