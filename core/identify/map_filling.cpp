#include "identify/map_filling.h"

#include <algorithm>
#include <cmath>

#include "identify/finest_noise.h"

namespace breakaway {

namespace {

constexpr double outlierScatters = 5.0;
constexpr double lagDoubt = 0.25;   // of the current's growth while the rotor moves unseen: how its friction falls then
constexpr size_t leastPooled = 12;  // bins on either side whose scatter is averaged

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

/// Scatter of a single turn's value around the mean over turns at bin `middle`, pooled over the bins up to `reach`
/// away: friction that is stronger scatters more.
double scatterOf(const std::vector<std::vector<double>>& turns, size_t middle, size_t reach) {
  if (turns.size() < 2) return 0.0;
  double squares = 0.0;
  const size_t n = turns[0].size(), count = std::min(n, 2 * reach + 1);
  for (size_t step = 0; step < count; ++step) {
    const size_t k = (middle + n - reach % n + step) % n;
    std::vector<double> values;
    values.reserve(turns.size());
    for (const auto& turn : turns) values.push_back(turn[k]);
    const double centre = mean(values);
    for (const double value : values) squares += (value - centre) * (value - centre);
  }
  return std::sqrt(squares / static_cast<double>(count * (turns.size() - 1)));
}

double meanOverTurns(const std::vector<std::vector<double>>& turns, size_t bin) {
  double sum = 0.0;
  for (const auto& turn : turns) sum += turn[bin];
  return turns.empty() ? 0.0 : sum / static_cast<double>(turns.size());
}

Repeatability repeatabilityOf(const std::vector<std::vector<double>>& turns) {
  Repeatability result;
  if (turns.size() < 2) return result;
  for (size_t t = 0; t + 1 < turns.size(); ++t) {
    const auto &a = turns[t], &b = turns[t + 1];
    const double ma = mean(a), mb = mean(b);
    double aa = 0.0, bb = 0.0, ab = 0.0, dd = 0.0;
    for (size_t k = 0; k < a.size(); ++k) {
      aa += (a[k] - ma) * (a[k] - ma), bb += (b[k] - mb) * (b[k] - mb), ab += (a[k] - ma) * (b[k] - mb);
      dd += (a[k] - b[k]) * (a[k] - b[k]);
    }
    result.correlation += aa * bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
    result.rmsDifference_Nm += std::sqrt(dd / static_cast<double>(a.size()));
  }
  result.correlation /= static_cast<double>(turns.size() - 1);
  result.rmsDifference_Nm /= static_cast<double>(turns.size() - 1);
  return result;
}

}  // namespace

double commonError(const std::vector<BreakawayEvent>& events, Way way, const MapOptions& options) {
  double xx = 0.0, beyond_A = 0.0, lag_A = 0.0, count = 0.0;
  for (const BreakawayEvent& event : events) {
    xx += event.commandedVariance_A2 * static_cast<double>(event.samples);
    if (event.way != way) continue;
    beyond_A += event.commanded_A - event.commandedMean_A;
    lag_A += event.lag_A;
    count += 1.0;
  }
  if (count == 0.0) return 0.0;
  const double slope = xx > 0.0 ? options.noiseRms_A / std::sqrt(xx) * beyond_A / count : 0.0;
  const double lag = lagDoubt * lag_A / count;
  return options.torqueConstant_Nm_per_A *
         std::sqrt(options.zeroError_A * options.zeroError_A + slope * slope + lag * lag);
}

void fillStatic(FrictionMap& map, Way way, const std::vector<BreakawayEvent>& events,
                const std::function<size_t(const BreakawayEvent&)>& binOf, double commonError_Nm, double scaleError) {
  const auto w = static_cast<size_t>(way);
  const auto& turns = map.turnStatic_Nm[w];
  map.repeatability[w] = repeatabilityOf(turns);
  const size_t reach = std::max(leastPooled, map.bins.size() / 12);
  std::vector<double> means;
  means.reserve(map.bins.size());
  for (size_t k = 0; k < map.bins.size(); ++k) means.push_back(meanOverTurns(turns, k));
  const double finest = finestNoise(means, map.axis == Axis::rotary);
  for (size_t k = 0; k < map.bins.size(); ++k) {
    WayBin& bin = map.bins[k].way[w];
    const double scatter = scatterOf(turns, k, reach);
    const double own = std::max(finest, scatter / std::sqrt(static_cast<double>(turns.size())));
    bin.static_Nm = {means[k], std::hypot(own, commonError_Nm, scaleError * means[k])};
    for (const auto& turn : turns)
      bin.outlier = bin.outlier || std::abs(turn[k] - bin.static_Nm.value) > outlierScatters * scatter;
  }
  for (const BreakawayEvent& event : events) {
    if (event.way != way) continue;
    const auto k = std::min(map.bins.size() - 1, binOf(event));
    ++map.bins[k].way[w].samples;
    map.bins[k].way[w].outlier = map.bins[k].way[w].outlier || event.outlier;
  }
}

void widenCoulomb(std::array<MovingFriction, 2>& moving, const std::array<double, 2>& finer_Nm2) {
  const double finer_Nm = std::sqrt(std::max(finer_Nm2[0], finer_Nm2[1]));
  for (MovingFriction& way : moving) {
    for (Estimate& one : way.coulomb_Nm) one.standardError = std::hypot(one.standardError, finer_Nm);
  }
}

void fillMoving(FrictionMap& map, const std::array<MovingFriction, 2>& moving) {
  for (size_t w = 0; w < 2; ++w) {
    for (size_t k = 0; k < map.bins.size() && k < moving[w].coulomb_Nm.size(); ++k) {
      WayBin& bin = map.bins[k].way[w];
      bin.coulomb_Nm = moving[w].coulomb_Nm[k];
      bin.viscous_Nm_s_per_rad = moving[w].viscous_Nm_s_per_rad[k];
      bin.total_Nm = bin.coulomb_Nm.value + bin.viscous_Nm_s_per_rad.value * map.totalVelocity_rad_per_s;
    }
  }
  const auto both = [](const Estimate& a, const Estimate& b) {
    return Estimate{0.5 * (a.value + b.value), 0.5 * std::hypot(a.standardError, b.standardError)};
  };
  map.coulombAverage_Nm = both(moving[0].coulombMean_Nm, moving[1].coulombMean_Nm);
  map.viscousAverage_Nm_s_per_rad = both(moving[0].viscousMean_Nm_s_per_rad, moving[1].viscousMean_Nm_s_per_rad);
}

}  // namespace breakaway
