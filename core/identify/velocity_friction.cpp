#include "identify/velocity_friction.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double turn = 2.0 * std::numbers::pi;
constexpr double mostPhase =
    2.0;  // of an order's phase in half the span, beyond which the central difference shows too little of it

/// One run's torque by harmonic order, in the way's direction: τ(θ) = Re Σ τ_k·e^{jkθ}.
struct Spectrum {
  double speed_rad_per_s = 0.0;
  std::vector<Complex> torque_Nm;
  std::vector<double> variance_Nm2;  ///< of real and imaginary part each; of the mean for order 0
};

/// Bin means; an empty bin takes the mean of its filled neighbours.
std::vector<double> filled(const std::vector<AngleBinSums>& bins, double AngleBinSums::*sum) {
  const size_t n = bins.size();
  std::vector<double> means(n, 0.0);
  for (size_t k = 0; k < n; ++k) {
    size_t reach = 0, count = bins[k].samples;
    double total = bins[k].*sum;
    while (count == 0 && ++reach < n) {
      for (const size_t j : {(k + reach) % n, (k + n - reach % n) % n}) {
        count += bins[j].samples;
        total += bins[j].*sum;
      }
    }
    means[k] = count > 0 ? total / static_cast<double>(count) : 0.0;
  }
  return means;
}

Complex harmonic(const std::vector<double>& values, size_t order) {
  const auto n = static_cast<double>(values.size());
  Complex sum = 0.0;
  for (size_t k = 0; k < values.size(); ++k) {
    sum += values[k] * std::polar(1.0, -static_cast<double>(order) * turn * (static_cast<double>(k) + 0.5) / n);
  }
  // A bin's mean is the harmonic times sin(kπ/n)/(kπ/n).
  const double x = static_cast<double>(order) * std::numbers::pi / n;
  return sum * ((order == 0 ? 1.0 : 2.0) / n) * (order == 0 ? 1.0 : x / std::sin(x));
}

/// Variance of single samples around their bin's mean.
double scatter(const std::vector<AngleBinSums>& bins, double AngleBinSums::*sum, double AngleBinSums::*squares) {
  double total = 0.0, count = 0.0;
  for (const AngleBinSums& bin : bins) {
    if (bin.samples < 2) continue;
    const auto n = static_cast<double>(bin.samples);
    total += bin.*squares - bin.*sum * (bin.*sum) / n;
    count += n - 1.0;
  }
  return count > 0.0 ? std::max(0.0, total / count) : 0.0;
}

size_t samplesOf(const VelocityRun& run) {
  size_t count = 0;
  for (const AngleBinSums& bin : run.bins) count += bin.samples;
  return count;
}

size_t usableOrder(const VelocityRun& run, size_t highest) {
  return std::min(highest, run.bins.size() / 6);
}

/// Torque harmonics of one set of bins: Kt·i_k − J·(½ω²)'_k. A central difference over ± one tick shows sin(x)/x of a
/// speed ripple of order k, x = kωT; orders with x ≥ 2 are not seen and are left zero.
std::vector<Complex> torqueHarmonics(const std::vector<AngleBinSums>& bins, double halfSpan_s, double sign,
                                     size_t highest, const VelocityFrictionOptions& options) {
  const auto current = filled(bins, &AngleBinSums::current_A);
  const auto velocity = filled(bins, &AngleBinSums::velocity_rad_per_s);
  const double speed = std::abs(harmonic(velocity, 0).real());
  std::vector<double> halfSquare(velocity.size());
  for (size_t k = 0; k < velocity.size(); ++k) halfSquare[k] = 0.5 * velocity[k] * velocity[k];
  std::vector<Complex> torque;
  for (size_t k = 0; k <= highest; ++k) {
    const double x = static_cast<double>(k) * speed * halfSpan_s;
    if (x >= mostPhase) {
      torque.push_back(0.0);
      continue;
    }
    const double shown = x < 1e-6 ? 1.0 : std::sin(x) / x;
    const Complex acceleration = Complex(0.0, static_cast<double>(k)) * harmonic(halfSquare, k) / shown;
    torque.push_back(sign *
                     (options.torqueConstant_Nm_per_A * harmonic(current, k) - options.inertia_kg_m2 * acceleration));
  }
  return torque;
}

/// Variance of the real and the imaginary part of each harmonic, from the scatter between stretches of time.
std::vector<double> scatterBetween(const std::vector<std::vector<Complex>>& blocks, size_t orders) {
  std::vector<double> variance(orders, 0.0);
  const auto n = static_cast<double>(blocks.size());
  if (blocks.size() < 2) return variance;
  for (size_t k = 0; k < orders; ++k) {
    Complex mean = 0.0;
    for (const auto& block : blocks) mean += block[k] / n;
    for (const auto& block : blocks) variance[k] += std::norm(block[k] - mean) / (n * (n - 1.0)) * (k == 0 ? 1.0 : 0.5);
  }
  return variance;
}

Spectrum spectrumOf(const VelocityRun& run, const VelocityFrictionOptions& options) {
  const double sign = run.way() == Way::ccw ? 1.0 : -1.0;
  const double Kt = options.torqueConstant_Nm_per_A, J = options.inertia_kg_m2, zero = Kt * options.zeroError_A;
  const auto samples = static_cast<double>(std::max<size_t>(1, samplesOf(run)));
  const double currentVariance =
      scatter(run.bins, &AngleBinSums::current_A, &AngleBinSums::currentSquared_A2) / samples;
  const double velocityVariance =
      scatter(run.bins, &AngleBinSums::velocity_rad_per_s, &AngleBinSums::velocitySquared) / samples;
  const size_t highest = usableOrder(run, options.highestOrder);
  Spectrum spectrum;
  spectrum.speed_rad_per_s = sign * harmonic(filled(run.bins, &AngleBinSums::velocity_rad_per_s), 0).real();
  spectrum.torque_Nm = torqueHarmonics(run.bins, run.halfSpan_s, sign, highest, options);
  std::vector<std::vector<Complex>> blocks;
  for (const auto& block : run.blocks) blocks.push_back(torqueHarmonics(block, run.halfSpan_s, sign, highest, options));
  const auto between = scatterBetween(blocks, highest + 1);
  for (size_t k = 0; k <= highest; ++k) {
    // At least what white noise of the samples leaves; the scatter between blocks sees slow fluctuations, too.
    const double phase = static_cast<double>(k) * spectrum.speed_rad_per_s * run.halfSpan_s;
    const double shown = phase < 1e-6 ? 1.0 : std::sin(phase) / phase;
    const double inertial = J * static_cast<double>(k) * spectrum.speed_rad_per_s / shown;
    const double white = Kt * Kt * currentVariance + inertial * inertial * velocityVariance;
    const bool seen = phase < mostPhase;
    const double variance = k == 0 ? std::max(white, between[0]) + zero * zero : std::max(2.0 * white, between[k]);
    spectrum.variance_Nm2.push_back(seen ? variance + 1e-24 : std::numeric_limits<double>::infinity());
  }
  return spectrum;
}

struct Line {
  Complex coulomb = 0.0, viscous = 0.0;
  double coulombVariance = 0.0, viscousVariance = 0.0, covariance = 0.0;
  double excess = 0.0;  ///< of the slowest speed over the line through the others, in standard errors
};

Line fitLine(const std::vector<Spectrum>& spectra, size_t order, bool withSlope) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Matrix<Complex, 2, 1> right = Eigen::Matrix<Complex, 2, 1>::Zero();
  for (const Spectrum& one : spectra) {
    if (order >= one.torque_Nm.size() || std::isinf(one.variance_Nm2[order])) continue;
    const double weight = 1.0 / one.variance_Nm2[order];
    const Eigen::Vector2d row(1.0, withSlope ? one.speed_rad_per_s : 0.0);
    normal += weight * row * row.transpose();
    right += (weight * one.torque_Nm[order]) * row.cast<Complex>();
  }
  Line line;
  if (normal(0, 0) == 0.0) return line;
  const bool slope = withSlope && normal.determinant() > 1e-12 * normal(0, 0) * normal(1, 1);
  if (!slope) {
    line.coulomb = right[0] / normal(0, 0);
    line.coulombVariance = 1.0 / normal(0, 0);
    return line;
  }
  const Eigen::Matrix2d covariance = normal.inverse();
  line.coulomb = covariance(0, 0) * right[0] + covariance(0, 1) * right[1];
  line.viscous = covariance(1, 0) * right[0] + covariance(1, 1) * right[1];
  line.coulombVariance = covariance(0, 0);
  line.viscousVariance = covariance(1, 1);
  line.covariance = covariance(0, 1);
  return line;
}

/// The mean's own scatter is larger than the noise of its samples: what is left of the sensor's zero differs from run
/// to run. The residual over the speeds says by how much.
void widen(std::vector<Spectrum>& spectra) {
  const Line line = fitLine(spectra, 0, true);
  double squares = 0.0;
  for (const Spectrum& one : spectra)
    squares += std::norm(one.torque_Nm[0] - line.coulomb - line.viscous * one.speed_rad_per_s);
  const double extra = spectra.size() > 2 ? squares / static_cast<double>(spectra.size() - 2) : 0.0;
  for (Spectrum& one : spectra) one.variance_Nm2[0] += extra;
}

/// Leaves out the slowest speeds while they lie off the line through the faster ones by more than 1.5 % and four
/// standard errors.
size_t leaveOutStribeck(std::vector<Spectrum>& spectra) {
  size_t leftOut = 0;
  while (spectra.size() > 3) {
    const std::vector<Spectrum> faster(spectra.begin() + 1, spectra.end());
    const Line line = fitLine(faster, 0, true);
    const Spectrum& slow = spectra.front();
    const double w = slow.speed_rad_per_s;
    const double off = std::abs(slow.torque_Nm[0] - line.coulomb - line.viscous * w);
    const double error = std::sqrt(slow.variance_Nm2[0] + line.coulombVariance + w * w * line.viscousVariance +
                                   2.0 * w * line.covariance);
    if (off < 0.015 * std::abs(line.coulomb) || off < 4.0 * error) break;
    spectra.erase(spectra.begin());
    ++leftOut;
  }
  return leftOut;
}

void addHarmonic(std::vector<Estimate>& bins, size_t order, Complex value, double variance) {
  const auto n = static_cast<double>(bins.size());
  for (size_t k = 0; k < bins.size(); ++k) {
    const double angle = turn * (static_cast<double>(k) + 0.5) / n * static_cast<double>(order);
    bins[k].value += (value * std::polar(1.0, angle)).real();
    bins[k].standardError = std::hypot(bins[k].standardError, std::sqrt(variance));
  }
}

MovingFriction fitWay(std::vector<Spectrum> spectra, const VelocityFrictionOptions& options) {
  std::sort(spectra.begin(), spectra.end(),
            [](const auto& a, const auto& b) { return a.speed_rad_per_s < b.speed_rad_per_s; });
  MovingFriction friction;
  friction.coulomb_Nm.resize(options.bins);
  friction.viscous_Nm_s_per_rad.resize(options.bins);
  const std::vector<Spectrum> all = spectra;
  friction.leftOut = leaveOutStribeck(spectra);
  widen(spectra);
  const double mean_Nm = std::abs(fitLine(spectra, 0, true).coulomb);
  const auto standsOut = [&options](Complex value, double variance) {
    return std::norm(value) > options.significance * options.significance * variance;
  };
  for (size_t k = 0; k <= options.highestOrder; ++k) {
    Line line = fitLine(spectra, k, k <= options.highestViscousOrder);
    if (k > 0 && !standsOut(line.viscous, line.viscousVariance)) line = fitLine(spectra, k, false);
    const double mostVariance = options.mostError * options.mostError * mean_Nm * mean_Nm;
    // What fast runs blur the slowest may still show: position torque is the same at any speed.
    if (k > 0 && line.coulombVariance > mostVariance && friction.leftOut > 0) line = fitLine(all, k, false);
    const bool blurred = line.coulombVariance > mostVariance;
    if (k > 0 && (blurred || !standsOut(line.coulomb, line.coulombVariance))) line.coulomb = 0.0;
    if (k == 0) {
      friction.coulombMean_Nm = {line.coulomb.real(), std::sqrt(line.coulombVariance)};
      friction.viscousMean_Nm_s_per_rad = {line.viscous.real(), std::sqrt(line.viscousVariance)};
    }
    if (k == 0 || line.coulomb != 0.0) addHarmonic(friction.coulomb_Nm, k, line.coulomb, line.coulombVariance);
    if (k == 0 || line.viscous != 0.0)
      addHarmonic(friction.viscous_Nm_s_per_rad, k, line.viscous, line.viscousVariance);
  }
  return friction;
}

}  // namespace

Estimate meanCurrent_A(const VelocityRun& run) {
  const double sign = run.way() == Way::ccw ? 1.0 : -1.0;
  const double variance = scatter(run.bins, &AngleBinSums::current_A, &AngleBinSums::currentSquared_A2);
  return {sign * harmonic(filled(run.bins, &AngleBinSums::current_A), 0).real(),
          std::sqrt(variance / static_cast<double>(std::max<size_t>(1, samplesOf(run))))};
}

Result<std::array<MovingFriction, 2>> fitMovingFriction(const std::vector<VelocityRun>& runs,
                                                        const VelocityFrictionOptions& options) {
  std::array<std::vector<Spectrum>, 2> spectra;
  for (const VelocityRun& run : runs) spectra[static_cast<size_t>(run.way())].push_back(spectrumOf(run, options));
  std::array<MovingFriction, 2> result;
  for (size_t way = 0; way < 2; ++way) {
    if (spectra[way].size() < 2) {
      return Error{std::string("velocity sweep, ") + (way == 0 ? "cw" : "ccw"),
                   "has " + std::to_string(spectra[way].size()) + " speeds, expected at least two"};
    }
    result[way] = fitWay(std::move(spectra[way]), options);
  }
  return result;
}

std::vector<double> movingCurrent_A(const std::vector<VelocityRun>& runs, Way way,
                                    const VelocityFrictionOptions& options) {
  const VelocityRun* slowest = nullptr;
  for (const VelocityRun& run : runs) {
    if (run.way() != way) continue;
    if (slowest == nullptr || std::abs(run.target_rad_per_s) < std::abs(slowest->target_rad_per_s)) slowest = &run;
  }
  if (slowest == nullptr) return {};
  const Spectrum spectrum = spectrumOf(*slowest, options);
  std::vector<Estimate> bins(slowest->bins.size());
  for (size_t k = 0; k < spectrum.torque_Nm.size(); ++k) {
    const double variance = spectrum.variance_Nm2[k];
    const bool blurred = variance > options.mostError * options.mostError * std::norm(spectrum.torque_Nm[0]);
    if (k > 0 && (blurred || std::norm(spectrum.torque_Nm[k]) < options.significance * options.significance * variance))
      continue;
    addHarmonic(bins, k, spectrum.torque_Nm[k], variance);
  }
  std::vector<double> current;
  current.reserve(bins.size());
  for (const Estimate& bin : bins) current.push_back(bin.value / options.torqueConstant_Nm_per_A);
  return current;
}

}  // namespace breakaway
