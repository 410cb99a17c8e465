#include "identify/zero_track.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "dense/dense_solve.h"

namespace breakaway {

namespace {

constexpr Eigen::Index highestDegree = 2;

Eigen::VectorXd powers(double x, Eigen::Index count) {
  Eigen::VectorXd row(count);
  for (Eigen::Index k = 0; k < count; ++k) row[k] = k == 0 ? 1.0 : row[k - 1] * x;
  return row;
}

/// Shifts the sums of a bin's currents by the same current for each sample.
void shift(AngleBinSums& bin, double by_A) {
  const auto n = static_cast<double>(bin.samples);
  bin.currentSquared_A2 += 2.0 * by_A * bin.current_A + n * by_A * by_A;
  bin.current_A += n * by_A;
}

}  // namespace

ZeroTrack::ZeroTrack(std::vector<ZeroReading> readings, double noiseRms_A)
    : readings_(std::move(readings)), noiseRms_A_(noiseRms_A) {
  if (readings_.empty()) return;
  for (ZeroReading& one : readings_) {
    one.zero_A += one.beyondMean_A;
    common_A_ += one.hidden_A / static_cast<double>(readings_.size());
  }
  middle_s_ = 0.5 * (readings_.front().time_s + readings_.back().time_s);
  span_s_ = std::max(1e-9, 0.5 * (readings_.back().time_s - readings_.front().time_s));
  const auto n = static_cast<Eigen::Index>(readings_.size());
  for (Eigen::Index count = 2; count <= std::min(highestDegree + 1, n - 1); ++count) {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    const auto weight = [this](const ZeroReading& one) {
      return static_cast<double>(one.samples) / std::max(1e-30, noiseRms_A_ * noiseRms_A_);
    };
    for (const ZeroReading& one : readings_) {
      const Eigen::VectorXd row = powers((one.time_s - middle_s_) / span_s_, count);
      normal += weight(one) * row * row.transpose();
      right += weight(one) * one.zero_A * row;
    }
    const Eigen::MatrixXd covariance = inverseOf(normal);
    const Eigen::VectorXd x = covariance * right;
    double squares = 0.0;
    for (const ZeroReading& one : readings_) {
      const double off = one.zero_A - powers((one.time_s - middle_s_) / span_s_, count).dot(x);
      squares += weight(one) * off * off;
    }
    // Mean and two and a half deviations of χ² with as many degrees of freedom as readings to spare.
    const auto spare = static_cast<double>(n - count);
    if (squares > spare + 2.5 * std::sqrt(2.0 * spare)) continue;
    coefficients_.assign(x.begin(), x.end());
    for (Eigen::Index k = 0; k < count; ++k)
      covariance_.emplace_back(covariance.row(k).begin(), covariance.row(k).end());
    return;
  }
}

Estimate ZeroTrack::at(double time_s) const {
  if (coefficients_.empty()) return between(time_s);
  const auto count = static_cast<Eigen::Index>(coefficients_.size());
  const Eigen::VectorXd row = powers((time_s - middle_s_) / span_s_, count);
  double value = 0.0, variance = 0.0;
  for (Eigen::Index j = 0; j < count; ++j) {
    value += coefficients_[static_cast<size_t>(j)] * row[j];
    for (Eigen::Index k = 0; k < count; ++k)
      variance += row[j] * row[k] * covariance_[static_cast<size_t>(j)][static_cast<size_t>(k)];
  }
  return {value, std::sqrt(std::max(0.0, variance) + common_A_ * common_A_)};
}

Estimate ZeroTrack::between(double time_s) const {
  if (readings_.empty()) return {};
  const auto later = std::find_if(readings_.begin(), readings_.end(),
                                  [time_s](const ZeroReading& one) { return one.time_s >= time_s; });
  const ZeroReading& high = later == readings_.end() ? readings_.back() : *later;
  const ZeroReading& low = later == readings_.begin() ? readings_.front() : *(later - 1);
  const double width = high.time_s - low.time_s;
  const double part = width > 0.0 ? std::clamp((time_s - low.time_s) / width, 0.0, 1.0) : 0.0;
  const auto error = [this](const ZeroReading& one) {
    return noiseRms_A_ / std::sqrt(static_cast<double>(std::max<size_t>(1, one.samples)));
  };
  return {low.zero_A + part * (high.zero_A - low.zero_A),
          std::hypot((1.0 - part) * error(low), part * error(high), common_A_)};
}

void countFrom(const ZeroTrack& track, std::span<VelocityRun> runs) {
  for (VelocityRun& run : runs) {
    const double zero_A = track.at(run.middle_s).value, by_A = run.zero_A - zero_A;
    for (AngleBinSums& bin : run.bins) shift(bin, by_A);
    for (auto& block : run.blocks) {
      for (AngleBinSums& bin : block.bins) shift(bin, by_A);
    }
    run.zero_A = zero_A;
  }
}

void countFrom(const ZeroTrack& track, std::span<BreakawayEvent> events) {
  for (BreakawayEvent& event : events) {
    const double zero_A = track.at(event.time_s).value;
    event.measuredMean_A += signOf(event.way) * (event.zero_A - zero_A);
    event.zero_A = zero_A;
  }
}

void countFrom(const ZeroTrack& track, std::span<TravelRun> runs) {
  for (TravelRun& run : runs) {
    const double zero_A = track.at(run.middle_s).value, by_A = run.zero_A - zero_A;
    for (auto& way : run.bins) {
      for (TravelBinSums& bin : way) bin.current_A += static_cast<double>(bin.samples) * by_A;
    }
    run.zero_A = zero_A;
  }
}

}  // namespace breakaway
