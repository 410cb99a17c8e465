#include "identify/travel_friction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "identify/smooth_pair.h"

namespace breakaway {

namespace {

constexpr double clearAcceleration = 10.0;  // standard errors of an acceleration that tells of the mass
constexpr double travelFallDoubt = 0.05;    // of the breakaway force, where friction falls with speed
constexpr double travelLawDoubt = 1e-3;     // relative, of a speed's mean force: no law of friction is exact
constexpr double travelTimingDoubt =
    5e-3;                             // relative, of what accelerates: when in a tick current and place were taken
constexpr double travelDoubt = 7e-4;  // relative, of a mass: ticks, and speeds as central differences

/// One bin at one speed, one way; positive in the way's direction.
struct TravelPoint {
  size_t run;
  double force_N, velocity, acceleration;
  double currentVariance_N2, accelerationVariance;
  double static_N;
};

using Bin = std::vector<TravelPoint>;  // over the speeds

std::vector<Bin> pointsOf(const std::vector<TravelRun>& runs, size_t way, const TravelFrictionOptions& options) {
  std::vector<Bin> bins(options.bins.count);
  const double sign = signOf(Way(way)), Kf = options.forceConstant_N_per_A;
  for (size_t r = 0; r < runs.size(); ++r) {
    const TravelRun& run = runs[r];
    const double sharpened = reachesFar(run.halfSpan_s, run.target_m_per_s, options.bins) ? farNoise : 1.0;
    const double speedError = sharpened * options.count_m / std::sqrt(6.0) / (2.0 * run.halfSpan_s);
    for (size_t k = 0; k < run.bins[way].size() && k < bins.size(); ++k) {
      const TravelBinSums& sum = run.bins[way][k];
      if (sum.samples < 2) continue;
      const auto n = static_cast<double>(sum.samples);
      const double v = sign * sum.velocity_m_per_s / n;
      if (!(v > 0.0)) continue;
      const double passes = std::max(1.0, n * options.tick_s * v / options.bins.width_m());
      const double still = options.static_N[way].empty() ? 0.0 : options.static_N[way][k];
      bins[k].push_back({r, sign * Kf * sum.current_A / n, v, sign * sum.acceleration_m_per_s2 / n,
                         Kf * Kf * options.noiseRms_A * options.noiseRms_A / n,
                         passes * std::pow(std::sqrt(2.0) * speedError / (options.tick_s * n), 2), still});
    }
  }
  return bins;
}

double fallen(double velocity, double stribeck) {
  return stribeck > 0.0 ? std::exp(-std::pow(velocity / stribeck, 2)) : 0.0;
}

/// Of a force less what accelerates; how far friction has fallen is known to `doubt` of the breakaway force.
double variance(const TravelPoint& point, double mass_kg, double stribeck, double doubt = 0.0) {
  const double fall_N = doubt * point.static_N * fallen(point.velocity, stribeck);
  return point.currentVariance_N2 + mass_kg * mass_kg * point.accelerationVariance + fall_N * fall_N;
}

/// Normal equations of C and B in one bin.
struct Line {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  double squares = 0.0;
  Eigen::Vector2d solution() const { return normal.ldlt().solve(right); }
  double chi2() const { return squares - right.dot(solution()); }
};

Eigen::Vector2d rowOf(const TravelPoint& point, double stribeck) {
  return {1.0 - fallen(point.velocity, stribeck), point.velocity};
}

Line lineOf(const Bin& bin, double mass_kg, double stribeck, double doubt = 0.0) {
  Line line;
  for (const TravelPoint& point : bin) {
    const Eigen::Vector2d row = rowOf(point, stribeck);
    const double y = point.force_N - mass_kg * point.acceleration - point.static_N * fallen(point.velocity, stribeck);
    const double weight = 1.0 / variance(point, mass_kg, stribeck, doubt);
    line.normal += weight * row * row.transpose();
    line.right += weight * y * row;
    line.squares += weight * y * y;
  }
  return line;
}

struct Misfit {
  double chi2 = 0.0, freedom = 0.0;
};

Misfit misfit(const std::array<std::vector<Bin>, 2>& ways, double mass_kg, double stribeck) {
  Misfit sum;
  for (const auto& bins : ways) {
    for (const Bin& bin : bins) {
      if (bin.size() < 3) continue;
      sum.chi2 += lineOf(bin, mass_kg, stribeck).chi2();
      sum.freedom += static_cast<double>(bin.size() - 2);
    }
  }
  return sum;
}

/// What C and B of each bin leave of force follows what they leave of acceleration, of whose squares the counts'
/// rounding has its part.
Estimate massOf(const std::array<std::vector<Bin>, 2>& ways, double mass_kg, double stribeck, double scale) {
  double aa = 0.0, af = 0.0, rounding = 0.0;
  for (const auto& bins : ways) {
    for (const Bin& bin : bins) {
      Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
      Eigen::Matrix2d right = Eigen::Matrix2d::Zero();  // of acceleration, of force
      const auto clear = [](const TravelPoint& p) {
        return p.acceleration * p.acceleration > clearAcceleration * clearAcceleration * p.accelerationVariance;
      };
      const bool tells = bin.size() >= 3 && std::any_of(bin.begin(), bin.end(), clear);
      if (!tells) continue;
      const auto force = [&](const TravelPoint& p) { return p.force_N - p.static_N * fallen(p.velocity, stribeck); };
      for (const TravelPoint& point : bin) {
        const Eigen::Vector2d row = rowOf(point, stribeck);
        const double weight = 1.0 / variance(point, mass_kg, stribeck, travelFallDoubt);
        normal += weight * row * row.transpose();
        right.col(0) += weight * point.acceleration * row;
        right.col(1) += weight * force(point) * row;
      }
      const Eigen::LDLT<Eigen::Matrix2d> factor = normal.ldlt();
      const Eigen::Matrix2d fit = factor.solve(right);
      for (const TravelPoint& point : bin) {
        const Eigen::Vector2d row = rowOf(point, stribeck);
        const double weight = 1.0 / variance(point, mass_kg, stribeck, travelFallDoubt);
        const double a = point.acceleration - fit.col(0).dot(row), f = force(point) - fit.col(1).dot(row);
        aa += weight * a * a;
        af += weight * a * f;
        rounding += weight * point.accelerationVariance * (1.0 - weight * row.dot(factor.solve(row)));
      }
    }
  }
  constexpr double roundingDoubt = 0.3;  // relative, of its squares: counts are passed in step with the ticks
  const double told = aa - rounding;
  if (!(told > roundingDoubt * rounding)) return {mass_kg, 0.0};
  const double value = af / told;
  const double relative = std::hypot(travelDoubt, roundingDoubt * rounding / told);
  return {value, std::hypot(std::sqrt(scale * aa) / told, relative * value)};
}

/// Two estimates of the same; their mean's doubt grows where they contradict each other. The first may be unknown.
Estimate joined(const Estimate& known, const Estimate& found) {
  if (!(known.standardError > 0.0)) return found;
  const double u = 1.0 / std::pow(known.standardError, 2), v = 1.0 / std::pow(found.standardError, 2);
  const double apart = std::abs(known.value - found.value) / std::hypot(known.standardError, found.standardError);
  return {(u * known.value + v * found.value) / (u + v), std::max(1.0, apart) / std::sqrt(u + v)};
}

struct Shape {
  double stribeck = 0.0, low = 0.0, high = 0.0;
};

/// The Stribeck speed under which the bins' lines fit best, with the range in which they fit about as well.
Shape stribeckOf(const std::array<std::vector<Bin>, 2>& ways, double mass_kg) {
  double slowest = std::numeric_limits<double>::infinity(), none = 0.0;
  for (const auto& bins : ways) {
    for (const Bin& bin : bins) {
      for (const TravelPoint& point : bin) slowest = std::min(slowest, point.velocity);
    }
  }
  if (!std::isfinite(slowest)) return {};
  constexpr int tries = 60;
  constexpr double below = 0.35, step = 1.06;
  std::vector<double> speeds, squares;
  double freedom = 1.0;
  for (int k = 0; k < tries; ++k) {
    speeds.push_back(slowest * below * std::pow(step, k));
    const Misfit fit = misfit(ways, mass_kg, speeds.back());
    squares.push_back(fit.chi2);
    freedom = std::max(1.0, fit.freedom);
  }
  none = misfit(ways, mass_kg, 0.0).chi2;
  const auto best = static_cast<size_t>(std::min_element(squares.begin(), squares.end()) - squares.begin());
  const double scale = std::max(1.0, squares[best] / freedom);
  constexpr double clear = 25.0, alike = 3.84;  // by how much it must fit better; of the 95 % interval
  if (none - squares[best] < clear * scale || best == 0 || best + 1 == squares.size()) return {};
  Shape shape{speeds[best], speeds[best], speeds[best]};
  for (size_t k = 0; k < speeds.size(); ++k) {
    if (squares[k] - squares[best] > alike * scale) continue;
    shape.low = std::min(shape.low, speeds[k] / std::sqrt(step));
    shape.high = std::max(shape.high, speeds[k] * std::sqrt(step));
  }
  return shape;
}

/// Values at bins' centres of a curve whose means over the bins these are: f = f̄ − δ²f̄/24 + 3·δ⁴f̄/640 − …, δ² and δ⁴
/// its differences over the bins beside. Of a wave of two bins or less that takes off a part only, and bins can't tell
/// such waves apart: as much as that wave's δ⁴ leaves is open.
void freeOfBinMeans(std::vector<Estimate>& curve) {
  constexpr double leftOpen = 1.0 / 40.0;  // of δ⁴: 0.36 of a wave of two bins is 16·(1/40) of it
  const std::vector<Estimate> means = curve;
  const auto second = [&means](size_t k) { return means[k + 1].value - 2.0 * means[k].value + means[k - 1].value; };
  for (size_t k = 1; k + 1 < means.size(); ++k) {
    const bool inner = k > 1 && k + 2 < means.size();
    const double fourth = inner ? second(k + 1) - 2.0 * second(k) + second(k - 1) : 0.0;
    curve[k].value += 3.0 / 640.0 * fourth - second(k) / 24.0;
    curve[k].standardError = std::hypot(curve[k].standardError, leftOpen * fourth);
  }
}

struct Levels {
  Estimate coulomb_N, viscous;
};

/// C and B over the whole travel, from each speed's mean force over all bins: what rounded counts make of a bin's
/// acceleration its neighbour has the other way round, so that it hardly touches these. What the bins' curves differ by
/// from their means is taken off before. How far friction has fallen, the sensor's zero, the mass, the ticks' timing
/// and the law itself are the same to all bins at a speed.
Levels levelsOf(const std::vector<Bin>& bins, size_t runs, const SmoothPair& curves, const Estimate& mass_kg,
                double stribeck, const TravelFrictionOptions& options) {
  const double zero_N = options.forceConstant_N_per_A * options.zeroError_A;
  Line line;
  double speeds = 0.0;
  for (size_t run = 0; run < runs; ++run) {
    Eigen::Vector2d rows = Eigen::Vector2d::Zero();
    double n = 0.0, force = 0.0, squares = 0.0, fall = 0.0, net = 0.0, swing = 0.0;
    for (size_t k = 0; k < bins.size(); ++k) {
      const auto point =
          std::find_if(bins[k].begin(), bins[k].end(), [run](const TravelPoint& p) { return p.run == run; });
      if (point == bins[k].end()) continue;
      const Eigen::Vector2d row = rowOf(*point, stribeck);
      const double fallen_N = point->static_N * fallen(point->velocity, stribeck);
      const Eigen::Vector2d off(curves.first[k].value - curves.firstMean.value,
                                curves.second[k].value - curves.secondMean.value);
      const double y = point->force_N - mass_kg.value * point->acceleration - fallen_N - off.dot(row);
      n += 1.0, rows += row, force += y, squares += y * y, fall += fallen_N;
      net += point->acceleration, swing += std::abs(point->acceleration);
    }
    if (n < 2.0) continue;
    rows /= n, force /= n;
    const double scatter_N2 = std::max(0.0, squares / n - force * force) / n;
    const double weight = 1.0 / (scatter_N2 + zero_N * zero_N + std::pow(travelFallDoubt * fall / n, 2) +
                                 std::pow(travelLawDoubt * force, 2) + std::pow(mass_kg.standardError * net / n, 2) +
                                 std::pow(travelTimingDoubt * mass_kg.value * swing / n, 2));
    line.normal += weight * rows * rows.transpose();
    line.right += weight * force * rows;
    line.squares += weight * force * force;
    speeds += 1.0;
  }
  if (speeds < 3.0) return {curves.firstMean, curves.secondMean};
  const Eigen::Vector2d level = line.solution();
  const double scale = std::sqrt(std::max(1.0, line.chi2() / (speeds - 2.0)));
  const Eigen::Matrix2d inverse = line.normal.inverse();
  return {{level[0], scale * std::sqrt(inverse(0, 0))}, {level[1], scale * std::sqrt(inverse(1, 1))}};
}

/// The curve about another mean, which is known to its own doubt.
void setLevel(std::vector<Estimate>& curve, Estimate& mean, const Estimate& level) {
  for (Estimate& one : curve) {
    const double own = std::max(0.0, one.standardError * one.standardError - mean.standardError * mean.standardError);
    one = {one.value + level.value - mean.value, std::sqrt(own + level.standardError * level.standardError)};
  }
  mean = level;
}

MovingFriction smoothed(const std::vector<Bin>& bins, size_t runs, const Estimate& mass_kg, double stribeck,
                        double scale, const TravelFrictionOptions& options) {
  std::vector<double> place;
  std::vector<Eigen::Vector2d> pairs;
  std::vector<Eigen::Matrix2d> covariances;
  for (size_t k = 0; k < bins.size(); ++k) {
    place.push_back(static_cast<double>(k) / static_cast<double>(bins.size() - 1));
    const Line line = lineOf(bins[k], mass_kg.value, stribeck, travelFallDoubt);
    const Eigen::Matrix2d inverse = line.normal.inverse();
    const bool good = bins[k].size() >= 2 && inverse.allFinite() && inverse(0, 0) > 0.0 && inverse(1, 1) > 0.0;
    pairs.push_back(good ? line.solution() : Eigen::Vector2d::Zero());
    covariances.push_back(good ? Eigen::Matrix2d(scale * inverse)
                               : Eigen::Matrix2d(1e12 * Eigen::Matrix2d::Identity()));
  }
  SmoothPair curves = smoothPair(place, pairs, covariances);
  const Levels levels = levelsOf(bins, runs, curves, mass_kg, stribeck, options);
  setLevel(curves.first, curves.firstMean, levels.coulomb_N);
  setLevel(curves.second, curves.secondMean, levels.viscous);
  const auto widen = [&](Estimate one, double common_N) {
    one.standardError = std::hypot(one.standardError, common_N, options.scaleError * one.value);
    return one;
  };
  // An error of the zero at all speeds is Coulomb friction.
  const double zero_N = options.forceConstant_N_per_A * options.zeroError_A;
  MovingFriction friction;
  for (const Estimate& one : curves.first) friction.coulomb_Nm.push_back(widen(one, zero_N));
  for (const Estimate& one : curves.second) friction.viscous_Nm_s_per_rad.push_back(widen(one, 0.0));
  freeOfBinMeans(friction.coulomb_Nm);
  friction.coulombMean_Nm = widen(curves.firstMean, zero_N);
  friction.viscousMean_Nm_s_per_rad = widen(curves.secondMean, 0.0);
  return friction;
}

}  // namespace

Result<TravelFriction> fitTravelFriction(const std::vector<TravelRun>& runs, const TravelFrictionOptions& options) {
  const std::array<std::vector<Bin>, 2> ways{pointsOf(runs, 0, options), pointsOf(runs, 1, options)};
  for (const auto& bins : ways) {
    size_t most = 0;
    for (const Bin& bin : bins) most = std::max(most, bin.size());
    if (most < 3 && std::all_of(runs.begin(), runs.end(), tellsOfFriction))
      return Error{"strokes", message("crossed no bin at three speeds, expected at least that")};
    if (most < 3)
      return Error{"strokes",
                   message("went steadily at fewer than three speeds: at the others the axis sticks and slips, as with "
                           "a coarse encoder")};
  }
  TravelFriction friction;
  Estimate mass_kg{options.mass_kg, options.massError_kg};
  Shape shape;
  for (int round = 0; round < 2; ++round) {
    if (!options.static_N[0].empty()) shape = stribeckOf(ways, mass_kg.value);
    const Misfit fit = misfit(ways, mass_kg.value, shape.stribeck);
    const Estimate mass =
        massOf(ways, mass_kg.value, shape.stribeck, std::max(1.0, fit.chi2 / std::max(1.0, fit.freedom)));
    // One that is hardly known better than before is left as it was.
    if (!(mass.standardError > 0.0) || mass.standardError > 0.02 * mass_kg.value || !(mass.value > 0.0)) break;
    friction.mass_kg = mass;
    mass_kg = joined({options.mass_kg, options.massError_kg}, mass);
  }
  if (shape.stribeck > 0.0) friction.stribeck_m_per_s = {shape.stribeck, (shape.high - shape.low) / (2.0 * normal95)};
  const Misfit fit = misfit(ways, mass_kg.value, shape.stribeck);
  const double scale = std::max(1.0, fit.chi2 / std::max(1.0, fit.freedom));
  for (size_t way = 0; way < 2; ++way)
    friction.moving[way] = smoothed(ways[way], runs.size(), mass_kg, shape.stribeck, scale, options);
  return friction;
}

bool tellsOfFriction(const TravelRun& run) {
  const auto crossed = [](const TravelBinSums& sum) { return sum.samples > 0; };
  return std::all_of(run.bins.begin(), run.bins.end(), [&](const std::vector<TravelBinSums>& way) {
    return std::any_of(way.begin(), way.end(), crossed);
  });
}

Result<std::array<std::vector<double>, 2>> movingCurrent_A(const std::vector<TravelRun>& runs) {
  if (runs.empty()) return Error{"strokes", message("were none, expected at least one")};
  const auto slowest = std::min_element(runs.begin(), runs.end(), [](const TravelRun& a, const TravelRun& b) {
    const bool tells = tellsOfFriction(a);
    return tells == tellsOfFriction(b) ? a.target_m_per_s < b.target_m_per_s : tells;
  });
  // One that was broken off and what went on are one.
  std::array<std::vector<TravelBinSums>, 2> sums = slowest->bins;
  for (auto run = slowest + 1; run != runs.end(); ++run) {
    if (!run->isAt(slowest->target_m_per_s)) continue;
    for (size_t way = 0; way < 2; ++way) {
      for (size_t k = 0; k < std::min(sums[way].size(), run->bins[way].size()); ++k) {
        sums[way][k].samples += run->bins[way][k].samples;
        sums[way][k].current_A += run->bins[way][k].current_A;
      }
    }
  }
  std::array<std::vector<double>, 2> currents;
  for (size_t way = 0; way < 2; ++way) {
    const auto& bins = sums[way];
    const double sign = signOf(Way(way));
    const auto crossed = [](const TravelBinSums& sum) { return sum.samples > 0; };
    const auto first = std::find_if(bins.begin(), bins.end(), crossed);
    if (first == bins.end()) return Error{"strokes", message("crossed no bin at the slowest speed")};
    double last = sign * first->current_A / static_cast<double>(first->samples);
    for (const TravelBinSums& sum : bins) {
      if (sum.samples > 0) last = sign * sum.current_A / static_cast<double>(sum.samples);
      currents[way].push_back(last);
    }
  }
  return currents;
}

}  // namespace breakaway
