// What a torque, a shown angle, a voltage or a measured current that an effect adds changes in each row of the
// regression.
#include <Eigen/Core>
#include <cmath>

#include "diagnose/screen/effect_traces.h"
#include "diagnose/screen/linear_rig.h"

namespace breakaway {

namespace {

std::vector<double> ratesOf(const std::vector<double>& values, const Track& track) {
  std::vector<double> rates(values.size(), 0.0);
  for (size_t k = 1; k + 1 < values.size(); ++k)
    rates[k] = (values[k + 1] - values[k - 1]) / (track.time[k + 1] - track.time[k - 1]);
  return rates;
}

}  // namespace

void LinearRig::addStarts(const std::vector<double>& values, size_t track, double factor,
                          Eigen::Ref<Eigen::VectorXd> out) const {
  size_t number = 0;
  for (const Start& one : starts_) {
    if (one.track == track) out[one.at] += factor * values[number++];
  }
}

void LinearRig::addMechanical(const std::vector<double>& values, size_t track, int times, double factor,
                              Eigen::Ref<Eigen::VectorXd> out) const {
  if (values.empty()) return;
  const std::vector<double>& time = tracks_[track].time;
  for (const Stretch& one : stretches_) {
    if (one.track != track) continue;
    double once = 0.0, twice = 0.0;
    const double origin = times == 2 ? 0.0 : values[one.first];
    size_t k = one.first;
    const auto goOn = [&] {
      const double dt = time[k + 1] - time[k], value = values[k] - origin;
      if (times == 1) {
        once += 0.5 * dt * (value + values[k + 1] - origin);
      } else if (times == 2) {  // a value acts until the next row
        twice += dt * (once + 0.5 * dt * value);
        once += dt * value;
      }
      ++k;
    };
    for (Eigen::Index r = 0; r < one.rows; ++r) {
      double sum = 0.0;
      size_t part = 0;
      for (; part < one.samplesTaken; ++part) {
        sum += times == 0 ? values[k] - origin : times == 1 ? once : twice;
        if (k < one.last) goOn();
      }
      for (; part < one.samplesPerRow && k < one.last; ++part) goOn();
      out[one.at + r] += factor * sum / std::sqrt(static_cast<double>(one.samplesTaken));
    }
  }
}

void LinearRig::addElectrical(const std::vector<double>& values, size_t track, double factor,
                              Eigen::Ref<Eigen::VectorXd> out) const {
  if (values.empty()) return;
  for (const Stretch& one : electrical_) {
    if (one.track != track) continue;
    size_t k = one.first;
    for (Eigen::Index r = 0; r < one.rows; ++r) {
      double sum = 0.0;
      for (size_t part = 0; part < one.samplesPerRow; ++part, ++k) {
        const bool known = tracks_[track].connected[k] != 0 && std::isfinite(tracks_[track].current[k]);
        if (known) sum += values[k];
      }
      out[one.at + r] += factor * sum / std::sqrt(static_cast<double>(one.samplesPerRow));
    }
  }
}

std::vector<double> LinearRig::lagged(size_t track, const std::vector<double>& values, bool mean) const {
  return lagged(track, values, mean, physics_.inductance);
}

std::vector<double> LinearRig::lagged(size_t track, const std::vector<double>& values, bool mean,
                                      double inductance) const {
  if (values.empty() || inductance <= 0.0) return values;
  const std::vector<double>& time = tracks_[track].time;
  const double rate = physics_.resistance / inductance;
  std::vector<double> out(values.size());
  double state = values.front(), dt = -1.0, keep = 1.0;
  for (size_t k = 0; k < values.size(); ++k) {
    const double length = k + 1 < values.size() ? time[k + 1] - time[k] : 0.0;
    if (std::abs(length - dt) > 1e-8 * length) keep = std::exp(-(dt = length) * rate);
    const double away = state - values[k];
    out[k] = mean && length > 0.0 ? values[k] + away * (1.0 - keep) / (length * rate) : state;
    state = values[k] + away * keep;
  }
  return out;
}

Eigen::MatrixXd LinearRig::columnsOf(const Effect& effect, const Shape& shape, size_t only) const {
  Eigen::MatrixXd columns = rawColumnsOf(effect, shape, only);
  weigh(columns);
  return columns;
}

Eigen::MatrixXd LinearRig::rawColumnsOf(const Effect& effect, const Shape& shape, size_t only) const {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows_, static_cast<Eigen::Index>(shape.size()));
  const double backEmf = physics_.electrical ? physics_.backEmf / physics_.resistance : 0.0;  // A s/rad
  const double damping = physics_.viscous + physics_.torqueConstant * backEmf;
  for (size_t a = 0; a < shape.size(); ++a) {
    auto column = columns.col(static_cast<Eigen::Index>(a));
    for (size_t t = 0; t < tracks_.size(); ++t) {
      if (only != everyTrack && only != t) continue;
      const EffectTraces traces(effect, shape[a], tracks_[t], recorded_[t], physics_, startsOf(t));
      addMechanical(traces.torque, t, 2, 1.0, column);
      addStarts(traces.starting, t, 1.0, column);
      addMechanical(traces.shown, t, 0, -physics_.inertia, column);
      addMechanical(traces.shown, t, 1, -damping, column);  // a wrong angle is a wrong speed, too
      addMechanical(lagged(t, traces.voltage, true), t, 2, gain_, column);
      addMechanical(lagged(t, traces.input, true), t, 2, -gain_, column);
      if (!currentSeen_) continue;
      addElectrical(lagged(t, traces.voltage, false), t, -1.0 / physics_.resistance, column);
      addElectrical(lagged(t, traces.input, false), t, 1.0 / physics_.resistance, column);
      addElectrical(traces.sensed, t, 1.0, column);
      addElectrical(lagged(t, ratesOf(traces.shown, tracks_[t]), false), t, backEmf, column);
    }
  }
  return columns;
}

}  // namespace breakaway
