#include "identify/map_estimation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace breakaway {

namespace {

constexpr double turnAngle = 2.0 * std::numbers::pi;
constexpr size_t leastEvents = 8;
constexpr double outlierScatters = 5.0;
constexpr double lagDoubt = 0.1;     // of the current's growth while the rotor moves unseen
constexpr size_t highestTrend = 30;  // order of the curve that the breakaways are interpolated around
constexpr size_t leastPooled = 12;   // bins on either side whose scatter is averaged

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Measured over commanded current, pooled; 1 when the ramps say nothing.
double pooledSlope(const std::vector<BreakawayEvent>& events, double noiseRms_A) {
  double xx = 0.0, xy = 0.0;
  for (const BreakawayEvent& event : events) {
    xx += event.commandedVariance_A2 * static_cast<double>(event.samples);
    xy += event.covariance_A2 * static_cast<double>(event.samples);
  }
  if (!(xx > 0.0)) return 1.0;
  const double variance = noiseRms_A * noiseRms_A / xx;
  // Drawn towards one as far as the noise leaves it open, with a prior of 10 %.
  const double trust = 0.01 / (0.01 + variance);
  return 1.0 + trust * (xy / xx - 1.0);
}

/// What all breakaways of a way share and turns that repeat don't show: the sensor's zero, what the pooled slope leaves
/// open, and the doubt about the time the rotor takes to show that it moves.
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

/// How many neighbours bring the offset's noise down to the aim.
size_t neighboursNeeded(const std::vector<const BreakawayEvent*>& events, const MapOptions& options) {
  std::vector<double> currents, counts;
  for (const BreakawayEvent* event : events) {
    currents.push_back(std::abs(event->current_A));
    counts.push_back(static_cast<double>(event->samples));
  }
  const double aim = options.calibration * median(currents), count = std::max(1.0, median(counts));
  if (!(aim > 0.0)) return events.size();
  const double needed = std::ceil(options.noiseRms_A * options.noiseRms_A / (aim * aim) / count);
  return static_cast<size_t>(std::clamp(needed, 1.0, static_cast<double>(events.size())));
}

/// Values at the bin centres by interpolation over the angle, around the turn; `points` sorted by angle, not empty.
std::vector<double> interpolated(const std::vector<std::pair<double, double>>& points, size_t bins) {
  std::vector<double> values(bins);
  for (size_t k = 0; k < bins; ++k) {
    const double angle = (static_cast<double>(k) + 0.5) * turnAngle / static_cast<double>(bins);
    const auto after = std::lower_bound(points.begin(), points.end(), std::make_pair(angle, -1e300));
    const auto& high = after == points.end() ? points.front() : *after;
    const auto& low = after == points.begin() ? points.back() : *(after - 1);
    double width = high.first - low.first, part = angle - low.first;
    if (width <= 0.0) width += turnAngle;
    if (part < 0.0) part += turnAngle;
    values[k] = width > 1e-12 ? low.second + (high.second - low.second) * std::min(1.0, part / width) : low.second;
  }
  return values;
}

/// The curve that the breakaways of all turns follow, by harmonics. Straight lines between breakaways would cut off
/// what fine cogging does between them, so they are drawn between what is left over this curve.
class Trend {
 public:
  explicit Trend(const std::vector<BreakawayEvent>& events, Way way) {
    std::vector<const BreakawayEvent*> same;
    for (const BreakawayEvent& event : events) {
      if (event.way == way) same.push_back(&event);
    }
    const auto orders = static_cast<Eigen::Index>(std::min<size_t>(highestTrend, same.size() / 8));
    const Eigen::Index n = 2 * orders + 1;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Identity(n, n) * 1e-9;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    for (const BreakawayEvent* event : same) {
      const Eigen::VectorXd row = rowAt(event->angle_rad, n);
      normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
      right += event->torque_Nm * row;
    }
    x_ = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  }
  double at(double angle_rad) const { return rowAt(angle_rad, x_.size()).dot(x_); }

 private:
  static Eigen::VectorXd rowAt(double angle_rad, Eigen::Index n) {
    Eigen::VectorXd row(n);
    row[0] = 1.0;
    for (Eigen::Index k = 1; 2 * k < n; ++k) {
      row[2 * k - 1] = std::cos(static_cast<double>(k) * angle_rad);
      row[2 * k] = std::sin(static_cast<double>(k) * angle_rad);
    }
    return row;
  }
  Eigen::VectorXd x_;
};

std::vector<std::vector<double>> turnsOf(const std::vector<BreakawayEvent>& events, Way way,
                                         const MapOptions& options) {
  const Trend trend(events, way);
  std::vector<std::vector<double>> turns;
  for (size_t turn = 0; turn < options.turns; ++turn) {
    std::vector<std::pair<double, double>> points;
    for (const BreakawayEvent& event : events) {
      if (event.way == way && event.turn == turn)
        points.emplace_back(event.angle_rad, event.torque_Nm - trend.at(event.angle_rad));
    }
    if (points.size() < leastEvents) continue;
    std::sort(points.begin(), points.end());
    turns.push_back(interpolated(points, options.bins));
    for (size_t k = 0; k < options.bins; ++k)
      turns.back()[k] += trend.at((static_cast<double>(k) + 0.5) * turnAngle / static_cast<double>(options.bins));
  }
  return turns;
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

void fillStatic(FrictionMap& map, Way way, const std::vector<BreakawayEvent>& events, double commonError_Nm) {
  const auto w = static_cast<size_t>(way);
  const auto& turns = map.turnStatic_Nm[w];
  const size_t reach = std::max(leastPooled, map.bins.size() / 12);
  for (size_t k = 0; k < map.bins.size(); ++k) {
    std::vector<double> values;
    for (const auto& turn : turns) values.push_back(turn[k]);
    WayBin& bin = map.bins[k].way[w];
    const double scatter = scatterOf(turns, k, reach);
    bin.static_Nm = {mean(values), std::hypot(scatter / std::sqrt(static_cast<double>(turns.size())), commonError_Nm)};
    for (const double value : values)
      bin.outlier = bin.outlier || std::abs(value - bin.static_Nm.value) > outlierScatters * scatter;
  }
  const auto bins = static_cast<double>(map.bins.size());
  for (const BreakawayEvent& event : events) {
    if (event.way != way) continue;
    const auto k = std::min(map.bins.size() - 1, static_cast<size_t>(event.angle_rad / turnAngle * bins));
    ++map.bins[k].way[w].samples;
    map.bins[k].way[w].outlier = map.bins[k].way[w].outlier || event.outlier;
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

}  // namespace

std::vector<BreakawayEvent> calibrated(std::vector<BreakawayEvent> events, const MapOptions& options) {
  const double slope = pooledSlope(events, options.noiseRms_A);
  for (const Way way : {Way::cw, Way::ccw}) {
    std::vector<const BreakawayEvent*> same;
    for (const BreakawayEvent& event : events) {
      if (event.way == way) same.push_back(&event);
    }
    if (same.empty()) continue;
    const size_t needed = neighboursNeeded(same, options), n = same.size();
    std::vector<double> offsets, weights;
    for (const BreakawayEvent* event : same) {
      offsets.push_back(event->measuredMean_A - slope * event->commandedMean_A);
      weights.push_back(static_cast<double>(event->samples));
    }
    size_t k = 0;
    for (BreakawayEvent& event : events) {
      if (event.way != way) continue;
      const size_t first = std::min(k > needed / 2 ? k - needed / 2 : 0, n - std::min(n, needed));
      double sum = 0.0, weight = 0.0;
      for (size_t j = first; j < std::min(n, first + needed); ++j) sum += weights[j] * offsets[j], weight += weights[j];
      event.current_A = slope * event.commanded_A + (weight > 0.0 ? sum / weight : offsets[k]);
      event.torque_Nm = options.torqueConstant_Nm_per_A * event.current_A;
      ++k;
    }
  }
  return events;
}

Result<FrictionMap> estimateMap(const std::vector<BreakawayEvent>& measured,
                                const std::array<MovingFriction, 2>* moving, const MapOptions& options) {
  const std::vector<BreakawayEvent> events = calibrated(measured, options);
  FrictionMap map;
  map.rig = options.rig;
  map.turns = options.turns;
  map.totalVelocity_rad_per_s = options.totalVelocity_rad_per_s;
  map.bins.resize(options.bins);
  for (size_t k = 0; k < options.bins; ++k) {
    map.bins[k].angle_rad = (static_cast<double>(k) + 0.5) * turnAngle / static_cast<double>(options.bins);
  }
  for (const Way way : {Way::cw, Way::ccw}) {
    const auto w = static_cast<size_t>(way);
    map.turnStatic_Nm[w] = turnsOf(events, way, options);
    if (map.turnStatic_Nm[w].empty()) {
      return Error{std::string("breakaway sweep, ") + (way == Way::cw ? "cw" : "ccw"),
                   "has fewer than 8 breakaways in each turn"};
    }
    map.repeatability[w] = repeatabilityOf(map.turnStatic_Nm[w]);
    fillStatic(map, way, events, commonError(measured, way, options));
  }
  if (moving != nullptr) fillMoving(map, *moving);
  return map;
}

}  // namespace breakaway
