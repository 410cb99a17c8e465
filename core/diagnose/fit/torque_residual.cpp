#include "diagnose/fit/torque_residual.h"

#include <algorithm>
#include <cmath>

#include "diagnose/fit/unexplained.h"

namespace breakaway {

namespace {

constexpr double mostCutoff_Hz = 50.0, partOfRate = 0.05;
constexpr double rowsPerPeriod = 20.0;  ///< that are evaluated
constexpr double perPeriod = 5.0;       ///< rows that are kept
constexpr double marginPeriods = 2.0;   ///< of the cutoff, over which a filter forgets

double cutoffOf(const Track& track) {
  return std::min(mostCutoff_Hz, partOfRate / track.usualStep_s);
}

Track around(const Track& track, const Window& window) {
  const double margin_s = TorqueResidual::margin_s(track);
  size_t first = window.first, last = window.last;
  while (first > 0 && track.time[window.first] - track.time[first - 1] <= margin_s) --first;
  while (last + 1 < track.rows() && track.time[last + 1] - track.time[window.last] <= margin_s) ++last;
  return track.rowsFrom(first, last);
}

/// Rows as far apart as the cutoff needs, the model's terms along them cost what they do.
InverseRows thinned(const Track& part, double cutoff_Hz) {
  InverseRows rows = inverseRows(part);
  const auto every = static_cast<size_t>(1.0 / (rowsPerPeriod * cutoff_Hz * rows.step_s));
  if (every < 2) return rows;
  // The drive is held from row to row: half a new step on, so that the mean of two rows is the value between them.
  std::vector<double> input = rows.input;
  for (size_t k = input.size(); k-- > 1;) input[k] = 0.5 * (input[k - 1] + input[k]);
  lowPass(input, rows.step_s, 0.25 * rowsPerPeriod * cutoff_Hz);
  for (size_t k = 0; k < input.size(); ++k) rows.input[k] = input[std::min(k + every / 2, input.size() - 1)];
  const auto thin = [every](auto& values) {
    size_t kept = 0;
    for (size_t k = 0; k < values.size(); k += every) values[kept++] = values[k];
    values.resize(kept);
  };
  for (auto* values : {&rows.time, &rows.position, &rows.velocity, &rows.acceleration, &rows.input}) thin(*values);
  thin(rows.moving);
  thin(rows.usable);
  rows.step_s *= static_cast<double>(every);
  return rows;
}

}  // namespace

double TorqueResidual::margin_s(const Track& track) {
  return marginPeriods / cutoffOf(track);
}

TorqueResidual::TorqueResidual(const Track& track, const Window& window)
    : part_(around(track, window)), cutoff_Hz_(cutoffOf(track)), along_(thinned(part_, cutoff_Hz_)) {
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

std::vector<double> TorqueResidual::times_s() const {
  std::vector<double> times;
  times.reserve(kept_.size());
  for (const size_t k : kept_) times.push_back(along_.time[k]);
  return times;
}

TorqueTrace torqueTrace(const Model& model, const Track& track) {
  TorqueTrace trace;
  if (track.rows() < 2) return trace;
  const TorqueResidual residual(track, {.last = track.rows() - 1, .errorIn = ErrorIn::torque});
  const std::vector<double> times = residual.times_s();
  const Eigen::VectorXd torque = residual.of(model);
  const double apart_s = 2.5 / (perPeriod * cutoffOf(track));  // instants between which others are left out
  const auto add = [&](double time_s, double value) {
    const auto after = std::upper_bound(track.time.begin(), track.time.end(), time_s);
    trace.time_s.push_back(time_s);
    trace.torque.push_back(value);
    trace.row.push_back(static_cast<size_t>(std::max<std::ptrdiff_t>(1, after - track.time.begin()) - 1));
  };
  for (size_t k = 0; k < times.size(); ++k) {
    if (k > 0 && times[k] - times[k - 1] > apart_s) add(0.5 * (times[k - 1] + times[k]), std::nan(""));
    add(times[k], torque[static_cast<Eigen::Index>(k)]);
  }
  return trace;
}

bool isLongEnough(const Track& track, const Window& window, size_t rows) {
  return window.last - window.first + 1 >= rows &&
         (window.errorIn == ErrorIn::motion || static_cast<size_t>(TorqueResidual(track, window).rows()) >= rows);
}

TorqueResidual TorqueResidual::changed(const std::function<void(Track&)>& change) const {
  TorqueResidual other = *this;
  change(other.part_);
  other.along_ = thinned(other.part_, cutoff_Hz_);
  return other;
}

}  // namespace breakaway
