#include "identify/velocity_friction.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "identify/run_spectrum.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double turn = 2.0 * std::numbers::pi;
constexpr double fallDoubt = 0.3;       // of friction's fall with speed: its shape is not known
constexpr double leastFall = 0.02;      // part of the fall above which a run counts as slow
constexpr double surelyFalling = 12.0;  // gain in χ² by which the fall must show
constexpr double leftOutErrors = 3.0;   // standard errors off the line through the faster runs
constexpr size_t alwaysDoubted = 4;     // orders up to this may hide in the noise

struct Line {
  Complex coulomb = 0.0, viscous = 0.0;
  double coulombVariance = 0.0, viscousVariance = 0.0, covariance = 0.0;
  double squares = 0.0;  ///< of the residuals, each over its variance
};

/// What a way's runs are fitted with.
struct WayRuns {
  std::vector<RunSpectrum> spectra;  ///< by growing speed
  std::vector<double> fall;          ///< per run, exp(−(ω/ω_s)²); zero where friction doesn't fall any more
  std::vector<Complex> static_Nm;    ///< harmonics of the breakaway map; empty: not known
  std::vector<double> widened_Nm2;   ///< per run, on top of order 0's variance
};

/// C + B·|ω| for one order. Where friction still falls, S·g is taken off and the row is (1 − g, ω); the fall's doubt
/// then counts as noise, measured by the Coulomb value `guess`.
Line fitLine(const WayRuns& runs, size_t order, bool withSlope, Complex guess) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Matrix<Complex, 2, 1> right = Eigen::Matrix<Complex, 2, 1>::Zero();
  const Complex still = order < runs.static_Nm.size() ? runs.static_Nm[order] : Complex(0.0);
  const auto eachRun = [&](auto use) {
    for (size_t j = 0; j < runs.spectra.size(); ++j) {
      const RunSpectrum& one = runs.spectra[j];
      if (order >= one.torque_Nm.size() || std::isinf(one.variance_Nm2[order])) continue;
      const double g = runs.fall[j], doubt = fallDoubt * g * std::abs(still - guess);
      const double variance = one.variance_Nm2[order] + (order == 0 ? runs.widened_Nm2[j] : 0.0) + doubt * doubt;
      use(Eigen::Vector2d(1.0 - g, withSlope ? one.speed_rad_per_s : 0.0), one.torque_Nm[order] - g * still,
          1.0 / variance);
    }
  };
  eachRun([&](const Eigen::Vector2d& row, Complex torque, double weight) {
    normal += weight * row * row.transpose();
    right += (weight * torque) * row.cast<Complex>();
  });
  Line line;
  if (normal(0, 0) == 0.0) return line;
  const bool slope = withSlope && normal.determinant() > 1e-12 * normal(0, 0) * normal(1, 1);
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  covariance(0, 0) = 1.0 / normal(0, 0);
  if (slope) covariance = normal.inverse();
  line.coulomb = covariance(0, 0) * right[0] + covariance(0, 1) * right[1];
  line.viscous = covariance(1, 0) * right[0] + covariance(1, 1) * right[1];
  line.coulombVariance = covariance(0, 0);
  line.viscousVariance = covariance(1, 1);
  line.covariance = covariance(0, 1);
  eachRun([&](const Eigen::Vector2d& row, Complex torque, double weight) {
    line.squares += weight * std::norm(torque - line.coulomb * row[0] - line.viscous * row[1]);
  });
  return line;
}

/// With the fall's doubt measured by the fit's own Coulomb value.
Line fitOrder(const WayRuns& runs, size_t order, bool withSlope) {
  const Line first = fitLine(runs, order, withSlope, 0.0);
  return fitLine(runs, order, withSlope, first.coulomb);
}

void setFall(WayRuns& runs, double speed_rad_per_s) {
  for (size_t j = 0; j < runs.spectra.size(); ++j) {
    const double x = runs.spectra[j].speed_rad_per_s / speed_rad_per_s;
    runs.fall[j] = speed_rad_per_s > 0.0 ? std::exp(-x * x) : 0.0;
  }
}

/// The speed over which friction falls, the same both ways, by the means of all runs; 0 when they show no fall.
double findFall(std::array<WayRuns, 2> ways) {
  const auto squaresAt = [&ways](double speed) {
    double squares = 0.0;
    for (WayRuns& runs : ways) {
      setFall(runs, speed);
      squares += fitLine(runs, 0, true, runs.static_Nm.empty() ? 0.0 : runs.static_Nm[0]).squares;
    }
    return squares;
  };
  const double slowest = ways[0].spectra.front().speed_rad_per_s, fastest = ways[0].spectra.back().speed_rad_per_s;
  const double without = squaresAt(0.0);
  double best = 0.0, bestSquares = without - surelyFalling;
  for (double speed = 0.35 * slowest; speed < 0.4 * fastest; speed *= 1.02) {
    const double squares = squaresAt(speed);
    if (squares < bestSquares) bestSquares = squares, best = speed;
  }
  return best;
}

/// Runs differ by more than their own scatter says; the residuals over the speeds say by how much.
void widen(WayRuns& runs) {
  const auto spare = static_cast<double>(runs.spectra.size()) - 2.0;
  if (spare <= 0.0) return;
  double low = 0.0, high = 0.0;
  const auto squaresWith = [&runs](double extra) {
    runs.widened_Nm2.assign(runs.spectra.size(), extra);
    return fitOrder(runs, 0, true).squares;
  };
  if (squaresWith(0.0) <= spare) return;
  high = std::norm(0.1 * runs.spectra.back().torque_Nm[0]);
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    (squaresWith(middle) > spare ? low : high) = middle;
  }
  squaresWith(high);
}

/// Leaves out the slowest speeds while they lie off the line through the faster ones.
size_t leaveOutStribeck(WayRuns& runs) {
  size_t leftOut = 0;
  while (runs.spectra.size() > 3) {
    WayRuns faster = runs;
    faster.spectra.erase(faster.spectra.begin());
    faster.fall.erase(faster.fall.begin());
    faster.widened_Nm2.erase(faster.widened_Nm2.begin());
    WayRuns widened = faster;
    widen(widened);
    const Line line = fitOrder(widened, 0, true);
    const RunSpectrum& slow = runs.spectra.front();
    const double w = slow.speed_rad_per_s;
    const double off = std::abs(slow.torque_Nm[0] - line.coulomb - line.viscous * w);
    const double error = std::sqrt(slow.variance_Nm2[0] + line.coulombVariance + w * w * line.viscousVariance +
                                   2.0 * w * line.covariance);
    if (off < leftOutErrors * error || off < 0.003 * std::abs(line.coulomb)) break;
    runs = faster;
    ++leftOut;
  }
  return leftOut;
}

void addHarmonic(std::vector<Estimate>& bins, size_t order, Complex value) {
  const auto n = static_cast<double>(bins.size());
  for (size_t k = 0; k < bins.size(); ++k) {
    const double angle = turn * (static_cast<double>(k) + 0.5) / n * static_cast<double>(order);
    bins[k].value += (value * std::polar(1.0, angle)).real();
  }
}

/// A curve put together from its harmonics, with the doubt that is the same in all bins.
class Curve {
 public:
  Curve(std::vector<Estimate>& bins, double significance) : bins_(bins), significance_(significance) {}

  bool standsOut(Complex value, double variance) const { return partOf(value, variance) > 0.0; }
  /// What a harmonic of that variance is worth: nothing within the noise, all of it far above.
  double partOf(Complex value, double variance) const {
    const double ratio = significance_ * significance_ * variance / std::max(1e-300, std::norm(value));
    return std::max(0.0, 1.0 - ratio * ratio);
  }
  void keep(size_t order, Complex value, double variance) {
    const double part = order == 0 ? 1.0 : partOf(value, variance);
    addHarmonic(bins_, order, part * value);
    variance_ += variance + 0.5 * std::norm((1.0 - part) * value);
    highest_ = std::max(highest_, order);
  }
  /// Left out as no more than noise; it may be there all the same.
  void leaveOut(size_t order, Complex value) { left_.emplace_back(order, 0.5 * std::norm(value)); }
  void finish() {
    for (const auto& [order, square] : left_) {
      if (order <= std::max(highest_, alwaysDoubted)) variance_ += square;
    }
    for (Estimate& bin : bins_) bin.standardError = std::sqrt(variance_);
  }

 private:
  std::vector<Estimate>& bins_;
  double significance_, variance_ = 0.0;
  size_t highest_ = 0;
  std::vector<std::pair<size_t, double>> left_;
};

MovingFriction fitWay(WayRuns runs, const VelocityFrictionOptions& options) {
  MovingFriction friction;
  friction.coulomb_Nm.resize(options.bins);
  friction.viscous_Nm_s_per_rad.resize(options.bins);
  const WayRuns all = runs;
  const auto slow = std::count_if(runs.fall.begin(), runs.fall.end(), [](double g) { return g > leastFall; });
  friction.leftOut = runs.static_Nm.empty() ? leaveOutStribeck(runs) : static_cast<size_t>(slow);
  widen(runs);
  const Line mean = fitOrder(runs, 0, true);
  const double zero_Nm = options.torqueConstant_Nm_per_A * options.zeroError_A;
  friction.coulombMean_Nm = {mean.coulomb.real(), std::hypot(std::sqrt(mean.coulombVariance), zero_Nm,
                                                             options.scaleError * mean.coulomb.real())};
  friction.viscousMean_Nm_s_per_rad = {
      mean.viscous.real(), std::hypot(std::sqrt(mean.viscousVariance), options.scaleError * mean.viscous.real())};
  Curve coulomb(friction.coulomb_Nm, options.significance),
      viscous(friction.viscous_Nm_s_per_rad, options.significance);
  coulomb.keep(0, mean.coulomb, std::pow(friction.coulombMean_Nm.standardError, 2));
  viscous.keep(0, mean.viscous, std::pow(friction.viscousMean_Nm_s_per_rad.standardError, 2));
  const double mostViscousVariance = std::pow(options.mostViscousError * mean.viscous.real(), 2);
  const double mostVariance = options.mostError * options.mostError * std::norm(mean.coulomb);
  for (size_t k = 1; k <= options.highestOrder; ++k) {
    Line line = fitOrder(runs, k, k <= options.highestViscousOrder);
    const bool sloped = line.viscousVariance > 0.0 && line.viscousVariance < mostViscousVariance;
    if (sloped && viscous.standsOut(line.viscous, line.viscousVariance)) {
      viscous.keep(k, line.viscous, line.viscousVariance);
    } else {
      if (sloped) viscous.leaveOut(k, line.viscous);
      line = fitOrder(runs, k, false);
    }
    // What fast runs blur the slowest may still show: position torque is the same at any speed.
    if (line.coulombVariance > mostVariance && friction.leftOut > 0) line = fitOrder(all, k, false);
    if (line.coulombVariance > mostVariance || line.coulombVariance == 0.0) continue;
    if (coulomb.standsOut(line.coulomb, line.coulombVariance)) {
      coulomb.keep(k, line.coulomb, line.coulombVariance);
    } else {
      coulomb.leaveOut(k, line.coulomb);
    }
  }
  coulomb.finish();
  viscous.finish();
  return friction;
}

}  // namespace

Estimate meanCurrent_A(const VelocityRun& run) {
  const double sign = run.way() == Way::ccw ? 1.0 : -1.0;
  double squares = 0.0, mean = 0.0;
  for (const RunBlock& block : run.blocks) mean += meanAround(block.bins, &AngleBinSums::current_A);
  const auto n = static_cast<double>(run.blocks.size());
  for (const RunBlock& block : run.blocks)
    squares += std::pow(meanAround(block.bins, &AngleBinSums::current_A) - mean / n, 2);
  return {sign * meanAround(run.bins, &AngleBinSums::current_A),
          run.blocks.size() > 1 ? std::sqrt(squares / (n * (n - 1.0))) : 0.0};
}

Result<std::array<MovingFriction, 2>> fitMovingFriction(const std::vector<VelocityRun>& runs,
                                                        const VelocityFrictionOptions& options) {
  std::array<WayRuns, 2> ways;
  for (const VelocityRun& run : runs) ways[static_cast<size_t>(run.way())].spectra.push_back(spectrumOf(run, options));
  for (size_t w = 0; w < 2; ++w) {
    WayRuns& way = ways[w];
    if (way.spectra.size() < 2) {
      return Error{std::string("velocity sweep, ") + (w == 0 ? "cw" : "ccw"),
                   "has " + std::to_string(way.spectra.size()) + " speeds, expected at least two"};
    }
    std::sort(way.spectra.begin(), way.spectra.end(),
              [](const auto& a, const auto& b) { return a.speed_rad_per_s < b.speed_rad_per_s; });
    way.fall.assign(way.spectra.size(), 0.0);
    way.widened_Nm2 = way.fall;
    const auto& still = options.static_Nm[w];
    for (size_t k = 0; !still.empty() && k <= std::min(options.highestOrder, still.size() / 3); ++k)
      way.static_Nm.push_back(harmonicOf(still, k));
  }
  if (!ways[0].static_Nm.empty() && !ways[1].static_Nm.empty()) {
    const double speed = findFall(ways);
    for (WayRuns& way : ways) setFall(way, speed);
  }
  return std::array<MovingFriction, 2>{fitWay(std::move(ways[0]), options), fitWay(std::move(ways[1]), options)};
}

std::vector<double> movingCurrent_A(const std::vector<VelocityRun>& runs, Way way,
                                    const VelocityFrictionOptions& options) {
  const VelocityRun* slowest = nullptr;
  for (const VelocityRun& run : runs) {
    if (run.way() != way) continue;
    if (slowest == nullptr || std::abs(run.target_rad_per_s) < std::abs(slowest->target_rad_per_s)) slowest = &run;
  }
  if (slowest == nullptr) return {};
  const RunSpectrum spectrum = spectrumOf(*slowest, options);
  std::vector<Estimate> bins(slowest->bins.size());
  for (size_t k = 0; k < spectrum.torque_Nm.size(); ++k) {
    const double variance = spectrum.variance_Nm2[k];
    const bool blurred = variance > options.mostError * options.mostError * std::norm(spectrum.torque_Nm[0]);
    if (k > 0 && (blurred || std::norm(spectrum.torque_Nm[k]) < options.significance * options.significance * variance))
      continue;
    addHarmonic(bins, k, spectrum.torque_Nm[k]);
  }
  std::vector<double> current;
  current.reserve(bins.size());
  for (const Estimate& bin : bins) current.push_back(bin.value / options.torqueConstant_Nm_per_A);
  return current;
}

}  // namespace breakaway
