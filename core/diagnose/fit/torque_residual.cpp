#include "diagnose/fit/torque_residual.h"

#include <algorithm>
#include <cmath>

#include "diagnose/fit/unexplained.h"

namespace breakaway {

namespace {

constexpr double mostCutoff_Hz = 50.0, partOfRate = 0.05;
constexpr double perPeriod = 5.0;      ///< rows that are kept
constexpr double marginPeriods = 2.0;  ///< of the cutoff, over which a filter forgets

double cutoffOf(const Track& track) {
  return std::min(mostCutoff_Hz, partOfRate / track.usualStep_s);
}

Track around(const Track& track, const Window& window) {
  const double margin_s = marginPeriods / cutoffOf(track);
  size_t first = window.first, last = window.last;
  while (first > 0 && track.time[window.first] - track.time[first - 1] <= margin_s) --first;
  while (last + 1 < track.rows() && track.time[last + 1] - track.time[window.last] <= margin_s) ++last;
  return track.rowsFrom(first, last);
}

}  // namespace

TorqueResidual::TorqueResidual(const Track& track, const Window& window)
    : part_(around(track, window)), along_(inverseRows(part_)), cutoff_Hz_(cutoffOf(track)) {
  const double from_s = track.time[window.first], to_s = track.time[window.last];
  const auto every = static_cast<size_t>(std::max(1.0, std::round(1.0 / (perPeriod * cutoff_Hz_ * along_.step_s))));
  for (size_t k = 0; k < along_.time.size(); k += every) {
    if (along_.moving[k] != 0 && along_.time[k] >= from_s && along_.time[k] <= to_s) kept_.push_back(k);
  }
}

Eigen::VectorXd TorqueResidual::of(const Model& model) const {
  std::vector<double> torque = torqueAlong(model, part_, along_);
  lowPass(torque, along_.step_s, cutoff_Hz_);
  Eigen::VectorXd out(rows());
  for (Eigen::Index k = 0; k < rows(); ++k) out[k] = torque[kept_[static_cast<size_t>(k)]];
  return out;
}

TorqueResidual TorqueResidual::changed(const std::function<void(Track&)>& change) const {
  TorqueResidual other = *this;
  change(other.part_);
  other.along_ = inverseRows(other.part_);
  return other;
}

}  // namespace breakaway
