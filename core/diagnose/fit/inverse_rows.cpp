#include "diagnose/fit/inverse_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "base/statistics.h"

namespace breakaway {

namespace {

constexpr double mostSteps = 1000.0;  ///< without a row; longer is a pause, which is cut to it

/// One second-order section, direct form II transposed.
struct Section {
  double b0, b1, b2, a1, a2;
};

/// Bilinear transform of a second-order low-pass with quality q.
Section lowPassSection(double cutoff_Hz, double step_s, double q) {
  const double k = std::tan(std::numbers::pi * std::min(cutoff_Hz * step_s, 0.49));
  const double norm = 1.0 / (1.0 + k / q + k * k);
  return {k * k * norm, 2.0 * k * k * norm, k * k * norm, 2.0 * (k * k - 1.0) * norm, (1.0 - k / q + k * k) * norm};
}

/// Denormals, in which a filter's tail ends, take a hundred times as long.
double flushed(double value) {
  return std::abs(value) < 1e-200 ? 0.0 : value;
}

void filterForward(std::vector<double>& values, const Section& s) {
  // Begin in the steady state of the first value.
  const double first = values.front();
  double z1 = first * (1.0 - s.b0), z2 = first * (s.b2 - s.a2);
  for (double& value : values) {
    const double out = s.b0 * value + z1;
    z1 = flushed(s.b1 * value - s.a1 * out + z2);
    z2 = flushed(s.b2 * value - s.a2 * out);
    value = out;
  }
}

/// Linear interpolation of (time, values) at t; `at` is the caller's running index.
double interpolate(const std::vector<double>& time, const std::vector<double>& values, double t, size_t& at) {
  while (at + 2 < time.size() && time[at + 1] < t) ++at;
  const double part = std::clamp((t - time[at]) / (time[at + 1] - time[at]), 0.0, 1.0);
  return values[at] + part * (values[at + 1] - values[at]);
}

bool isPause(const Track& track, size_t row, double step_s) {
  return track.time[row] - track.time[row - 1] > mostSteps * step_s;
}

}  // namespace

std::vector<double> withoutPauses(const Track& track, double step_s) {
  std::vector<double> time{0.0};
  time.reserve(track.rows());
  for (size_t k = 1; k < track.rows(); ++k)
    time.push_back(time.back() + (isPause(track, k, step_s) ? mostSteps * step_s : track.time[k] - track.time[k - 1]));
  return time;
}

void lowPass(std::vector<double>& values, double step_s, double cutoff_Hz) {
  const size_t n = values.size();
  if (n < 4 || cutoff_Hz * step_s >= 0.45) return;
  const auto pad = std::min(n - 1, static_cast<size_t>(3.0 / (cutoff_Hz * step_s)));
  std::vector<double> padded;
  padded.reserve(n + 2 * pad);
  for (size_t k = pad; k > 0; --k) padded.push_back(2.0 * values.front() - values[k]);
  padded.insert(padded.end(), values.begin(), values.end());
  for (size_t k = 1; k <= pad; ++k) padded.push_back(2.0 * values.back() - values[n - 1 - k]);
  // Butterworth of fourth order: qualities 1/(2 cos π/8) and 1/(2 cos 3π/8).
  for (int direction = 0; direction < 2; ++direction) {
    for (const double q : {0.54119610, 1.30656296}) filterForward(padded, lowPassSection(cutoff_Hz, step_s, q));
    std::reverse(padded.begin(), padded.end());
  }
  std::copy_n(padded.begin() + static_cast<std::ptrdiff_t>(pad), n, values.begin());
}

InverseRows inverseRows(const Track& track, const InverseFilter& filter) {
  InverseRows rows;
  std::vector<double> steps;
  for (size_t k = 1; k < track.rows(); ++k) steps.push_back(track.time[k] - track.time[k - 1]);
  rows.step_s = quantile(std::move(steps), 0.5);
  const double rate = 1.0 / rows.step_s;
  double cutoff = filter.cutoff_Hz > 0.0 ? filter.cutoff_Hz : std::min(100.0, 0.1 * rate);
  const std::vector<double> time = withoutPauses(track, rows.step_s);
  const auto count = static_cast<size_t>(time.back() / rows.step_s) + 1;
  size_t at = 0, hold = 0;
  for (size_t k = 0; k < count; ++k) {
    const double t = std::min(static_cast<double>(k) * rows.step_s, time.back());
    rows.position.push_back(interpolate(time, track.position, t, at));
    while (hold + 1 < track.rows() && time[hold + 1] <= t + 1e-9) ++hold;
    rows.time.push_back(track.time[hold] + (t - time[hold]));
    rows.input.push_back(track.input[hold]);
    const bool pause = hold + 1 < track.rows() && isPause(track, hold + 1, rows.step_s);
    rows.moving.push_back(pause ? 0 : track.connected[hold]);
  }
  lowPass(rows.position, rows.step_s, cutoff);
  rows.velocity.assign(count, 0.0);
  rows.acceleration.assign(count, 0.0);
  for (size_t k = 1; k + 1 < count; ++k) {
    rows.velocity[k] = (rows.position[k + 1] - rows.position[k - 1]) / (2.0 * rows.step_s);
    rows.acceleration[k] =
        (rows.position[k + 1] - 2.0 * rows.position[k] + rows.position[k - 1]) / (rows.step_s * rows.step_s);
  }
  const double omega = turn_rad * cutoff;
  rows.velocityNoise = track.speedAlone() ? track.speedNoise * std::sqrt(2.0 * cutoff * rows.step_s)
                                          : track.noise * omega * std::sqrt(2.0 * cutoff * rows.step_s / 3.0);
  const double speed = quantile(
      [&] {
        std::vector<double> speeds;
        speeds.reserve(rows.velocity.size());
        for (const double v : rows.velocity) speeds.push_back(std::abs(v));
        return speeds;
      }(),
      0.95);
  const double slow = std::max(4.0 * rows.velocityNoise, 0.01 * speed);
  const auto edge = static_cast<size_t>(std::ceil(0.5 / (cutoff * rows.step_s)));
  const std::vector<char> connected = rows.moving;
  rows.usable.resize(count);
  for (size_t k = 0; k < count; ++k) {
    bool good = k >= edge && k + edge < count;
    for (size_t j = good ? k - edge : 0; good && j <= k + edge; ++j) {
      good = connected[j] != 0 && std::abs(rows.velocity[j]) > slow && rows.velocity[j] * rows.velocity[k] > 0.0;
    }
    rows.moving[k] = good ? 1 : 0;
    rows.usable[k] =
        connected[k] != 0 && std::abs(rows.velocity[k]) > 4.0 * rows.velocityNoise && k >= edge && k + edge < count;
  }
  return rows;
}

void filterAlike(Eigen::MatrixXd& columns, Eigen::VectorXd& response, const std::vector<char>& use, double step_s,
                 double cutoff_Hz) {
  std::vector<double> buffer(static_cast<size_t>(response.size()));
  const auto smooth = [&](auto&& target) {
    for (Eigen::Index k = 0; k < target.size(); ++k) buffer[static_cast<size_t>(k)] = target[k];
    lowPass(buffer, step_s, cutoff_Hz);
    for (Eigen::Index k = 0; k < target.size(); ++k) target[k] = buffer[static_cast<size_t>(k)];
  };
  for (Eigen::Index c = 0; c < columns.cols(); ++c) smooth(columns.col(c));
  smooth(response);
  const auto every = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(1.0 / (5.0 * cutoff_Hz * step_s)));
  Eigen::Index kept = 0;
  for (Eigen::Index k = 0; k < response.size(); k += every) {
    if (!use[static_cast<size_t>(k)]) continue;
    columns.row(kept) = columns.row(k).eval();
    response[kept] = response[k];
    ++kept;
  }
  columns.conservativeResize(kept, Eigen::NoChange);
  response.conservativeResize(kept);
}

}  // namespace breakaway
