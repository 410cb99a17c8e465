#include "identify/run_spectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double turn = 2.0 * std::numbers::pi;
/// Of an order's phase in half the span, beyond which the central difference shows too little of it.
constexpr double mostPhase = 1.2;
/// A harmonic's scatter grows with its order; the mean over neighbours and few blocks makes it seem smaller than it is.
constexpr double pooledDoubt = 1.3;
constexpr size_t pooledReach = 2;  // orders on either side whose scatter is averaged

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

/// Bin means of a block; an empty bin takes the whole run's, which says nothing about the block.
std::vector<double> filledFrom(const std::vector<double>& whole, const std::vector<AngleBinSums>& bins,
                               double AngleBinSums::*sum) {
  std::vector<double> means(whole);
  for (size_t k = 0; k < bins.size(); ++k) {
    if (bins[k].samples > 0) means[k] = bins[k].*sum / static_cast<double>(bins[k].samples);
  }
  return means;
}

/// What a central difference over ± one span shows of a ripple of order k: sin(x)/x, x = kωT.
double shownPart(double phase) {
  return phase < 1e-6 ? 1.0 : std::sin(phase) / phase;
}

/// What the speed gained over a stretch of whole turns.
struct Stretch {
  Stretch(double count, const RunBlock& first, const RunBlock& last) : turns(count) {
    const double from = first.startSpeed_rad_per_s, to = last.endSpeed_rad_per_s;
    gained = 0.5 * (to * to - from * from);
    beyondWobble = 0.5 * (from + to) * (to - last.endWobble_rad_per_s - from + first.startWobble_rad_per_s);
  }
  double turns;
  double gained;        ///< ½ω² at the end less that at the start
  double beyondWobble;  ///< the same without the wobble, which the bins' speeds are freed of
};

/// Kt·i_k − J·(½ω²)'_k from bin means of current and speed; orders that aren't seen are left zero. Over N turns from
/// θ_s on the derivative's harmonic is jk·(½ω²)_k + [½ω²]·e^{−jkθ_s}/(πN), half of the last term for order 0.
std::vector<Complex> torqueHarmonics(const std::vector<double>& current, const std::vector<double>& velocity,
                                     const Stretch& stretch, const VelocityRun& run, size_t highest,
                                     const VelocityFrictionOptions& options) {
  const double sign = run.way() == Way::ccw ? 1.0 : -1.0, speed = std::abs(harmonicOf(velocity, 0).real());
  std::vector<double> halfSquare(velocity.size());
  for (size_t k = 0; k < velocity.size(); ++k) halfSquare[k] = 0.5 * velocity[k] * velocity[k];
  const double perTurn = stretch.turns > 0.0 ? sign / (std::numbers::pi * stretch.turns) : 0.0;
  std::vector<Complex> torque;
  for (size_t k = 0; k <= highest; ++k) {
    const double phase = static_cast<double>(k) * speed * run.halfSpan_s;
    if (phase >= mostPhase) {
      torque.push_back(0.0);
      continue;
    }
    const Complex ends =
        k == 0 ? Complex(0.5 * perTurn * stretch.gained)
               : perTurn * stretch.beyondWobble * std::polar(1.0, -static_cast<double>(k) * run.start_rad);
    const Complex acceleration =
        Complex(0.0, static_cast<double>(k)) * harmonicOf(halfSquare, k) / shownPart(phase) + ends;
    torque.push_back(sign *
                     (options.torqueConstant_Nm_per_A * harmonicOf(current, k) - options.inertia_kg_m2 * acceleration));
  }
  return torque;
}

/// Variance of the real and the imaginary part of each harmonic's mean, from the scatter between blocks.
std::vector<double> scatterBetween(const std::vector<std::vector<Complex>>& blocks, size_t orders) {
  std::vector<double> variance(orders, 0.0);
  const auto n = static_cast<double>(blocks.size());
  if (blocks.size() < 2) return variance;
  for (size_t k = 0; k < orders; ++k) {
    Complex mean = 0.0;
    for (const auto& block : blocks) mean += block[k] / n;
    for (const auto& block : blocks) variance[k] += std::norm(block[k] - mean) / (n * (n - 1.0)) * (k == 0 ? 1.0 : 0.5);
  }
  // Few blocks know their own scatter badly: Student's distribution of the mean is that much wider.
  const double freedom = n - 1.0;
  variance[0] *= freedom > 2.0 ? freedom / (freedom - 2.0) : 4.0;
  return variance;
}

double pooled(const std::vector<double>& variance, size_t order) {
  if (order == 0) return variance[0];
  const size_t first = order > pooledReach ? order - pooledReach : 1,
               last = std::min(order + pooledReach, variance.size() - 1);
  double sum = 0.0;
  for (size_t k = first; k <= last; ++k) sum += variance[k];
  return pooledDoubt * sum / static_cast<double>(last + 1 - first);
}

size_t samplesOf(const VelocityRun& run) {
  size_t count = 0;
  for (const AngleBinSums& bin : run.bins) count += bin.samples;
  return count;
}

}  // namespace

std::complex<double> harmonicOf(const std::vector<double>& values, size_t order) {
  const auto n = static_cast<double>(values.size());
  const Complex step = std::polar(1.0, -static_cast<double>(order) * turn / n);
  Complex sum = 0.0, turned = std::polar(1.0, -static_cast<double>(order) * std::numbers::pi / n);
  for (const double value : values) {
    sum += value * turned;
    turned *= step;
  }
  // A bin's mean is the harmonic times sin(kπ/n)/(kπ/n).
  const double x = static_cast<double>(order) * std::numbers::pi / n;
  return sum * ((order == 0 ? 1.0 : 2.0) / n) * (order == 0 ? 1.0 : x / std::sin(x));
}

double meanAround(const std::vector<AngleBinSums>& bins, double AngleBinSums::*sum) {
  return harmonicOf(filled(bins, sum), 0).real();
}

RunSpectrum spectrumOf(const VelocityRun& run, const VelocityFrictionOptions& options) {
  const size_t highest = std::min(options.highestOrder, run.bins.size() / 6);
  const auto current = filled(run.bins, &AngleBinSums::current_A);
  const auto velocity = filled(run.bins, &AngleBinSums::velocity_rad_per_s);
  const RunBlock none;
  const Stretch whole(static_cast<double>(run.turns), run.blocks.empty() ? none : run.blocks.front(),
                      run.blocks.empty() ? none : run.blocks.back());
  RunSpectrum spectrum;
  spectrum.speed_rad_per_s = std::abs(harmonicOf(velocity, 0).real());
  spectrum.torque_Nm = torqueHarmonics(current, velocity, whole, run, highest, options);
  std::vector<std::vector<Complex>> blocks;
  for (const RunBlock& block : run.blocks) {
    const Stretch stretch(static_cast<double>(block.turns), block, block);
    blocks.push_back(torqueHarmonics(filledFrom(current, block.bins, &AngleBinSums::current_A),
                                     filledFrom(velocity, block.bins, &AngleBinSums::velocity_rad_per_s), stretch, run,
                                     highest, options));
  }
  const auto between = scatterBetween(blocks, highest + 1);
  const double noise_Nm = options.torqueConstant_Nm_per_A * options.noiseRms_A;
  const double white = noise_Nm * noise_Nm / static_cast<double>(std::max<size_t>(1, samplesOf(run)));
  for (size_t k = 0; k <= highest; ++k) {
    const bool seen = static_cast<double>(k) * spectrum.speed_rad_per_s * run.halfSpan_s < mostPhase;
    const double variance = std::max(k == 0 ? white : 2.0 * white, pooled(between, k)) + 1e-24;
    spectrum.variance_Nm2.push_back(seen ? variance : std::numeric_limits<double>::infinity());
  }
  return spectrum;
}

}  // namespace breakaway
