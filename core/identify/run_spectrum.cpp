#include "identify/run_spectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/numbers.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
/// Of an order's phase in half the span, beyond which the central difference shows too little of it.
constexpr double mostPhase = 1.2;
constexpr double lawDoubt = 1.5;   // up to as much scatter over its law is chance
constexpr size_t pooledReach = 2;  // orders on either side whose scatter is compared with the law

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

/// The rotor's angle where each bin's samples lie.
std::vector<double> anglesOf(size_t bins, const VelocityFrictionOptions& options) {
  std::vector<double> angles(bins);
  for (size_t k = 0; k < bins; ++k) {
    angles[k] = turn_rad * (static_cast<double>(k) + 0.5) / static_cast<double>(bins) + options.beyondBins_rad;
    if (options.disc.known()) angles[k] = options.disc.angleOf(angles[k]);
  }
  return angles;
}

/// With the rotor's speeds for those that the encoder shows.
std::vector<AngleBinSums> freedOf(const EncoderDisc& disc, std::vector<AngleBinSums> bins,
                                  const std::vector<double>& angles, double halfSpan_s) {
  for (size_t k = 0; disc.known() && k < bins.size(); ++k) {
    if (bins[k].samples == 0) continue;
    const auto n = static_cast<double>(bins[k].samples);
    bins[k].velocity_rad_per_s = n * disc.speedOf(bins[k].velocity_rad_per_s / n, angles[k], halfSpan_s);
  }
  return bins;
}

/// e^{−jkθ} at the bins' angles, by order.
class Waves {
 public:
  Waves(const std::vector<double>& angles, size_t highest)
      : waves_(highest + 1, std::vector<Complex>(angles.size(), 1.0)) {
    for (size_t b = 0; b < angles.size(); ++b) {
      const Complex step = std::polar(1.0, -angles[b]);
      for (size_t k = 1; k <= highest; ++k) waves_[k][b] = step * waves_[k - 1][b];
    }
  }
  /// Harmonic around the mean of values that are each a mean over their bin.
  Complex harmonicOf(const std::vector<double>& values, size_t order) const {
    const auto n = static_cast<double>(values.size());
    double mean = 0.0;
    for (const double value : values) mean += value / n;
    Complex sum = 0.0;
    for (size_t k = 0; k < values.size(); ++k) sum += (values[k] - mean) * waves_[order][k];
    const double x = static_cast<double>(order) * std::numbers::pi / n;
    return sum * (2.0 / n * x / std::sin(x));
  }

 private:
  std::vector<std::vector<Complex>> waves_;
};

/// Speed per bin of the whole run; the angle that a sample stands for is its share.
using Speeds = std::vector<double>;

/// Central differences over more than a bin show fine ripple flatter; how many samples fell into a bin tells how long
/// the rotor was in it, where bins are even. What the numbers scatter beyond their rounding in each pass is such
/// ripple.
Speeds speedsOf(const std::vector<AngleBinSums>& bins, double turns, const VelocityFrictionOptions& options,
                const std::vector<double>& angles) {
  constexpr double roundingVariance = 1.0 / 6.0;  // of a number of samples, for any time in any phase
  Speeds speeds = filled(bins, &AngleBinSums::velocity_rad_per_s);
  double covered = 0.0, seen = 0.0, scatter = 0.0, rounding = 0.0;
  std::vector<double> widths(bins.size(), 1.0);
  for (size_t k = 0; k < bins.size(); ++k) {
    if (bins[k].samples == 0) return speeds;
    if (options.disc.known()) widths[k] = options.disc.gainAt(angles[k]);
    covered += static_cast<double>(bins[k].samples) * speeds[k];
  }
  if (covered == 0.0 || !options.evenBins) return speeds;
  const auto n = static_cast<double>(bins.size());
  std::vector<double> beyond(bins.size());  // the angle that a bin's samples seem to cover, over its own, less 1
  for (size_t k = 0; k < bins.size(); ++k) {
    const auto samples = static_cast<double>(bins[k].samples);
    beyond[k] = n * samples * speeds[k] / (widths[k] * covered) - 1.0;
    scatter += beyond[k] * beyond[k];
    rounding += roundingVariance * turns / (samples * samples);
  }
  const double share = scatter > rounding ? 1.0 - rounding / scatter : 0.0;
  for (size_t k = 0; k < bins.size(); ++k) {
    speeds[k] /= 1.0 + share * beyond[k];
    seen += static_cast<double>(bins[k].samples) * speeds[k];
  }
  for (double& speed : speeds) speed *= covered / seen;
  return speeds;
}

/// Where the rotor stuck on its way, a bin's current is mostly static friction's: what moves there is as its
/// neighbours, on either side the nearest in which it didn't.
std::vector<AngleBinSums> movingOf(const std::vector<AngleBinSums>& bins, const std::vector<bool>& stuck) {
  const size_t n = bins.size();
  std::vector<AngleBinSums> moving = bins;
  for (size_t k = 0; k < n; ++k) {
    if (!stuck[k]) continue;
    size_t before = (k + n - 1) % n, after = (k + 1) % n;
    while (stuck[before] && before != k) before = (before + n - 1) % n;
    while (stuck[after] && after != k) after = (after + 1) % n;
    const auto samples = static_cast<double>(bins[before].samples + bins[after].samples);
    moving[k] = {};
    if (before == k || !(samples > 0.0)) continue;
    moving[k].add(bins[before]);
    moving[k].add(bins[after]);
    moving[k].samples /= 2;
    const double half = static_cast<double>(moving[k].samples) / samples;
    moving[k].current_A *= half;
    moving[k].velocity_rad_per_s *= half;
  }
  return moving;
}

/// Bins in which the rotor stood or crept.
std::vector<bool> stuckIn(const Speeds& speeds) {
  constexpr double creeping = 0.25;  // of the mean speed
  double mean = 0.0;
  for (const double speed : speeds) mean += speed / static_cast<double>(speeds.size());
  std::vector<bool> stuck;
  for (const double speed : speeds) stuck.push_back(!(speed / mean > creeping));
  return stuck;
}

/// What a sum is per bin, around the mean over the turn. Each sample counts by the angle that it covers, not each bin
/// by its mean: what changes slowly over the turns then falls out, though fast runs meet each bin in few of them.
std::vector<double> covered(const std::vector<AngleBinSums>& bins, double AngleBinSums::*sum, const Speeds& speeds) {
  double all = 0.0, mean = 0.0;
  for (size_t k = 0; k < bins.size(); ++k) {
    all += static_cast<double>(bins[k].samples) * speeds[k];
    mean += bins[k].*sum * speeds[k];
  }
  if (all != 0.0) mean /= all;
  std::vector<double> values(bins.size(), mean);
  const double scale = all != 0.0 ? static_cast<double>(bins.size()) / all : 0.0;
  for (size_t k = 0; k < bins.size(); ++k)
    values[k] += (bins[k].*sum - static_cast<double>(bins[k].samples) * mean) * speeds[k] * scale;
  return values;
}

/// What a central difference over ± one span shows of a ripple of order k: sin(x)/x, x = kωT.
double shownPart(double phase) {
  return phase < 1e-6 ? 1.0 : std::sin(phase) / phase;
}

/// A current's wave over its samples', `phase` of the wave passing from one to the next: between samples it follows the
/// tick's voltage by 1 − e^{−t/τ}, so that a sample tells of the tick behind it more than of the one before it.
Complex betweenSamples(double phase, double tick_s, double windingTime_s) {
  if (!(tick_s > 0.0) || std::abs(phase) < 1e-9) return 1.0;
  const double decay = std::clamp(tick_s / std::max(1e-12, windingTime_s), 1e-6, 1e6);
  const auto over = [phase](double rate) {  // ∫e^{−(rate + jφ)u} du from 0 to 1
    const Complex exponent(rate, phase);
    return (1.0 - std::exp(-exponent)) / exponent;
  };
  return over(0.0) + (std::polar(1.0, phase) - 1.0) * (over(0.0) - over(decay)) / -std::expm1(-decay);
}

/// Harmonic of half the square of what has these harmonics; it takes only those that are given.
Complex halfSquareOf(const std::vector<Complex>& harmonics, size_t order) {
  Complex sum = harmonics[0].real() * harmonics[order];
  for (size_t m = 1; m < order; ++m) sum += 0.25 * harmonics[m] * harmonics[order - m];
  for (size_t m = order + 1; m < harmonics.size(); ++m) sum += 0.5 * harmonics[m] * std::conj(harmonics[m - order]);
  return sum;
}

/// Mean of (1 + w)² over stretches of these turns, each with a wobble w that grows evenly.
double wobbleSquare(std::span<const RunBlock> blocks, double target_rad_per_s) {
  double sum = 0.0, turns = 0.0;
  for (const RunBlock& block : blocks) {
    const double from = 1.0 + block.startWobble_rad_per_s / target_rad_per_s,
                 to = 1.0 + block.endWobble_rad_per_s / target_rad_per_s, count = static_cast<double>(block.turns);
    sum += count * (from * from + from * to + to * to) / 3.0;
    turns += count;
  }
  return turns > 0.0 ? sum / turns : 1.0;
}

/// What the speed gained over a stretch of whole turns.
struct Stretch {
  Stretch(double count, std::span<const RunBlock> blocks, double target_rad_per_s)
      : turns(count), square(wobbleSquare(blocks, target_rad_per_s)) {
    if (blocks.empty()) return;
    const RunBlock &first = blocks.front(), &last = blocks.back();
    const double from = first.startSpeed_rad_per_s, to = last.endSpeed_rad_per_s;
    gained = 0.5 * (to * to - from * from);
    beyondWobble = 0.5 * (from + to) * (to - last.endWobble_rad_per_s - from + first.startWobble_rad_per_s);
  }
  double turns;
  double square;              ///< of the speed, over that of the bins, which are freed of the wobble
  double gained = 0.0;        ///< ½ω² at the end less that at the start
  double beyondWobble = 0.0;  ///< the same without the wobble
};

/// In the way's direction.
struct Harmonics {
  std::vector<Complex> torque_Nm, ripple_rad_per_s, acceleration_rad_per_s2;
};

/// Kt·i_k − J·(½ω²)'_k from bin means of current and speed; orders that aren't seen are left zero. Over N turns from
/// θ_s on the derivative's harmonic is jk·(½ω²)_k + [½ω²]·e^{−jkθ_s}/(πN), half of the last term for order 0.
Harmonics harmonicsOf(const std::vector<AngleBinSums>& bins, const Speeds& speeds, const Waves& waves,
                      const Stretch& stretch, const VelocityRun& run, size_t highest,
                      const VelocityFrictionOptions& options) {
  const auto current = covered(bins, &AngleBinSums::current_A, speeds);
  const auto velocity = covered(bins, &AngleBinSums::velocity_rad_per_s, speeds);
  const double sign = signOf(run.way()), speed = std::abs(harmonicOf(velocity, 0).real());
  const double start_rad = options.disc.known() ? options.disc.angleOf(run.start_rad) : run.start_rad;
  const double perTurn = stretch.turns > 0.0 ? sign / (std::numbers::pi * stretch.turns) : 0.0;
  const std::vector<Complex> none(highest + 1, 0.0);
  Harmonics harmonics{none, none, none};
  std::vector<Complex> speedOf{sign * speed};  // as it is, where the central differences show it flatter
  for (size_t k = 1; k <= highest && static_cast<double>(k) * speed * run.halfSpan_s < mostPhase; ++k)
    speedOf.push_back(waves.harmonicOf(velocity, k) / shownPart(static_cast<double>(k) * speed * run.halfSpan_s));
  harmonics.torque_Nm[0] = sign * (options.torqueConstant_Nm_per_A * harmonicOf(current, 0) -
                                   options.inertia_kg_m2 * 0.5 * perTurn * stretch.gained);
  for (size_t k = 1; k < speedOf.size(); ++k) {
    const Complex ends = perTurn * stretch.beyondWobble * std::polar(1.0, -static_cast<double>(k) * start_rad);
    const Complex acceleration =
        stretch.square * Complex(0.0, static_cast<double>(k)) * halfSquareOf(speedOf, k) + ends;
    harmonics.ripple_rad_per_s[k] = sign * speedOf[k];
    harmonics.acceleration_rad_per_s2[k] = sign * acceleration;
    const Complex between =
        betweenSamples(sign * static_cast<double>(k) * speed * options.tick_s, options.tick_s, options.windingTime_s);
    harmonics.torque_Nm[k] = sign * options.torqueConstant_Nm_per_A * between * waves.harmonicOf(current, k) -
                             options.inertia_kg_m2 * harmonics.acceleration_rad_per_s2[k];
  }
  return harmonics;
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

/// How the scatter grows with the order, from all orders at once: the current's noise is the same in all of them, the
/// encoder's rounding, differentiated twice, grows with the fourth power.
struct NoiseLaw {
  double current_Nm2 = 0.0, inertia_Nm2 = 0.0;
  double at(size_t order) const { return current_Nm2 + inertia_Nm2 * std::pow(static_cast<double>(order), 4); }
};

/// By least squares on the scatter over itself, to the highest order that is seen; at least `white`.
NoiseLaw noiseLaw(const std::vector<double>& scatter, size_t highest, double white) {
  NoiseLaw law{white, 0.0};
  for (int round = 0; round < 20; ++round) {
    double aa = 0.0, ab = 0.0, bb = 0.0, ay = 0.0, by = 0.0;
    for (size_t k = 1; k <= highest && k < scatter.size(); ++k) {
      const double now = std::max(1e-300, round == 0 ? std::max(white, scatter[k]) : law.at(k));
      const double a = 1.0 / now, b = std::pow(static_cast<double>(k), 4) / now, y = scatter[k] / now;
      aa += a * a, ab += a * b, bb += b * b, ay += a * y, by += b * y;
    }
    const double determinant = aa * bb - ab * ab;
    law = determinant > 1e-9 * aa * bb ? NoiseLaw{(ay * bb - by * ab) / determinant, (by * aa - ay * ab) / determinant}
                                       : NoiseLaw{aa > 0.0 ? ay / aa : white, 0.0};
    if (law.inertia_Nm2 < 0.0) law = {aa > 0.0 ? ay / aa : white, 0.0};
    if (law.current_Nm2 < white) law = {white, bb > 0.0 ? std::max(0.0, (by - white * ab) / bb) : 0.0};
  }
  return law;
}

/// What neighbouring orders scatter together, over what the law says of them.
double beyondLaw(const std::vector<double>& scatter, const NoiseLaw& law, size_t order, size_t highest) {
  const size_t first = order > pooledReach ? order - pooledReach : 1, last = std::min(order + pooledReach, highest);
  double sum = 0.0, count = 0.0;
  for (size_t k = first; k <= last && k < scatter.size(); ++k) sum += scatter[k] / law.at(k), count += 1.0;
  return count > 0.0 ? sum / count : 1.0;
}

void addShare(const Harmonics& part, double share, RunSpectrum& sum) {
  for (size_t k = 0; k < sum.torque_Nm.size(); ++k) {
    sum.torque_Nm[k] += share * part.torque_Nm[k];
    sum.ripple_rad_per_s[k] += share * part.ripple_rad_per_s[k];
    sum.acceleration_rad_per_s2[k] += share * part.acceleration_rad_per_s2[k];
  }
}

size_t samplesOf(const VelocityRun& run) {
  size_t count = 0;
  for (const AngleBinSums& bin : run.bins) count += bin.samples;
  return count;
}

}  // namespace

bool shows(const RunSpectrum& run, size_t order) {
  return order < run.torque_Nm.size() && !std::isinf(run.variance_Nm2[order]);
}

std::complex<double> harmonicOf(const std::vector<double>& values, size_t order) {
  const auto n = static_cast<double>(values.size());
  const Complex step = std::polar(1.0, -static_cast<double>(order) * turn_rad / n);
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

RunSpectrum spectrumOf(std::span<const VelocityRun> parts, const VelocityFrictionOptions& options) {
  const VelocityRun& first = parts.front();
  const size_t highest = std::min(options.highestOrder, first.bins.size() / 3);
  const auto angles = anglesOf(first.bins.size(), options);
  const Waves waves(angles, highest);
  double turns = 0.0;
  size_t samples = 0;
  for (const VelocityRun& part : parts) turns += static_cast<double>(part.turns), samples += samplesOf(part);
  const std::vector<Complex> none(highest + 1, 0.0);
  RunSpectrum spectrum{0.0, none, none, none, {}};
  std::vector<std::vector<Complex>> blocks;
  std::vector<Complex> replaced = none;  // what it makes of the torque that stuck bins are as their neighbours
  for (const VelocityRun& part : parts) {
    const auto turnsOfPart = static_cast<double>(part.turns);
    const auto all = freedOf(options.disc, part.bins, angles, part.halfSpan_s);
    const auto stuck = stuckIn(speedsOf(all, turnsOfPart, options, angles));
    const auto bins = movingOf(all, stuck);
    const Speeds speeds = speedsOf(bins, turnsOfPart, options, angles);
    const Stretch whole(static_cast<double>(part.turns), part.blocks, part.target_rad_per_s);
    const double share = parts.size() > 1 ? static_cast<double>(part.turns) / turns : 1.0;
    spectrum.speed_rad_per_s +=
        share * std::abs(harmonicOf(covered(bins, &AngleBinSums::velocity_rad_per_s, speeds), 0).real());
    const Harmonics found = harmonicsOf(bins, speeds, waves, whole, part, highest, options);
    addShare(found, share, spectrum);
    if (std::find(stuck.begin(), stuck.end(), true) != stuck.end()) {
      const auto asSeen =
          harmonicsOf(all, speedsOf(all, turnsOfPart, options, angles), waves, whole, part, highest, options);
      for (size_t k = 0; k <= highest; ++k) replaced[k] += share * (asSeen.torque_Nm[k] - found.torque_Nm[k]);
    }
    for (const RunBlock& block : part.blocks) {
      const Stretch stretch(static_cast<double>(block.turns), {&block, 1}, part.target_rad_per_s);
      const auto moving = movingOf(freedOf(options.disc, block.bins, angles, part.halfSpan_s), stuck);
      blocks.push_back(harmonicsOf(moving, speeds, waves, stretch, part, highest, options).torque_Nm);
    }
  }
  const auto between = scatterBetween(blocks, highest + 1);
  const double noise_Nm = options.torqueConstant_Nm_per_A * options.noiseRms_A;
  const double white = noise_Nm * noise_Nm / static_cast<double>(std::max<size_t>(1, samples));
  size_t seen = 0;
  while (seen < highest && static_cast<double>(seen + 1) * spectrum.speed_rad_per_s * first.halfSpan_s < mostPhase)
    ++seen;
  const NoiseLaw law = noiseLaw(between, seen, 2.0 * white);
  spectrum.variance_Nm2.push_back(std::max(white, between[0]) + 1e-24);
  for (size_t k = 1; k <= highest; ++k) {
    const double beyond = beyondLaw(between, law, k, seen), variance = law.at(k) * (beyond > lawDoubt ? beyond : 1.0);
    spectrum.variance_Nm2.push_back(k <= seen ? variance + 1e-24 : std::numeric_limits<double>::infinity());
  }
  for (size_t k = 0; k <= highest; ++k) spectrum.variance_Nm2[k] += 0.5 * std::norm(replaced[k]);
  return spectrum;
}

std::vector<std::vector<VelocityRun>> bySpeed(const std::vector<VelocityRun>& runs) {
  std::vector<std::vector<VelocityRun>> speeds;
  for (const VelocityRun& run : runs) {
    const auto begun = std::find_if(speeds.begin(), speeds.end(), [&run](const std::vector<VelocityRun>& parts) {
      return parts.front().brokenOff && parts.front().isAt(run.target_rad_per_s);
    });
    if (begun != speeds.end()) {
      begun->push_back(run);
    } else {
      speeds.push_back({run});
    }
  }
  return speeds;
}

}  // namespace breakaway
