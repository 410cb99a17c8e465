#include "identify/velocity_friction.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "identify/encoder_swing.h"
#include "identify/friction_line.h"
#include "identify/harmonic_evidence.h"
#include "identify/inertia_share.h"
#include "identify/run_spectrum.h"
#include "identify/way_runs.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double leastVelocityFall = 0.02;  // part of the fall above which a run counts as slow
// How viscous friction varies before the map itself has said it: share of the orders that are there, their rms
// amplitude as part of the mean, and how many orders that guess counts for.
constexpr double coarseOrder = 6.0;
constexpr double viscousShare = 0.25, viscousPart = 0.08, viscousOrders = 3.0;

void addHarmonic(std::vector<Estimate>& bins, size_t order, Complex value) {
  const auto n = static_cast<double>(bins.size());
  for (size_t k = 0; k < bins.size(); ++k) {
    const double angle = turn_rad * (static_cast<double>(k) + 0.5) / n * static_cast<double>(order);
    bins[k].value += (value * std::polar(1.0, angle)).real();
  }
}

/// A curve put together from its harmonics, with the doubt that is the same in all bins, and that of the angle, which
/// counts where the curve is steep.
class Curve {
 public:
  explicit Curve(std::vector<Estimate>& bins) : bins_(bins), slopes_(bins.size()) {}

  void add(size_t order, Complex value, double variance) {
    addHarmonic(bins_, order, value);
    addHarmonic(slopes_, order, Complex(0.0, static_cast<double>(order)) * value);
    variance_ += variance;
  }
  void finish(double angleError_rad) {
    for (size_t k = 0; k < bins_.size(); ++k)
      bins_[k].standardError = std::hypot(std::sqrt(variance_), angleError_rad * slopes_[k].value);
  }

 private:
  std::vector<Estimate>& bins_;
  std::vector<Estimate> slopes_;
  double variance_ = 0.0;
};

/// The viscous harmonics from 1 on, by what the runs say of them and what their like are.
std::vector<WeighedHarmonic> weighViscous(const std::vector<FrictionLine>& lines, Complex mean,
                                          const VelocityFrictionOptions& options) {
  std::vector<HarmonicEvidence> evidence;
  for (size_t k = 1; k <= options.highestViscousOrder && k < lines.size(); ++k)
    evidence.push_back({lines[k].viscous, lines[k].viscousVariance, 0.0, 0.0, chanceOf(k, coarseOrder)});
  const HarmonicPrior prior =
      learnt(evidence, {viscousShare, 0.5 * viscousPart * viscousPart * std::norm(mean)}, viscousOrders);
  std::vector<WeighedHarmonic> harmonics(1);
  for (const HarmonicEvidence& one : evidence) harmonics.push_back(weighed(one, prior));
  harmonics.resize(lines.size());
  return harmonics;
}

/// The Coulomb harmonics from 1 on, given the viscous ones.
std::vector<WeighedHarmonic> weighCoulomb(const std::vector<FrictionLine>& lines,
                                          const std::vector<WeighedHarmonic>& viscous, const WayRuns& runs,
                                          Complex mean) {
  std::vector<HarmonicEvidence> evidence;
  for (size_t k = 1; k < lines.size(); ++k) {
    HarmonicEvidence one = lines[k].coulombGiven(viscous[k]);
    one.chance = chanceOf(k, coarseOrder);
    if (k < runs.position_Nm.size()) {
      one.expected = runs.position_Nm[k];
      one.expectedVariance = runs.positionVariance_Nm2[k];
    }
    evidence.push_back(one);
  }
  const HarmonicPrior prior = learnt(evidence, coulombPrior(mean), coulombOrders);
  std::vector<WeighedHarmonic> harmonics(1);
  for (const HarmonicEvidence& one : evidence) harmonics.push_back(weighed(one, prior));
  return harmonics;
}

/// Without the runs that still show how friction falls, or freed of that; with variances that the residuals bear out.
/// Returns how many slow ones there are.
size_t prepare(WayRuns& runs, const VelocityFrictionOptions& options) {
  const auto slow = std::count_if(runs.fall.begin(), runs.fall.end(), [](double g) { return g > leastVelocityFall; });
  const size_t leftOut = runs.static_Nm.empty() ? leaveOutStribeck(runs) : static_cast<size_t>(slow);
  widen(runs);
  widenHarmonics(runs, options.highestViscousOrder);
  return leftOut;
}

/// `all`: the way's runs before they were prepared; `first`: its line of order 1 beside an encoder's swing, or none.
MovingFriction fitWay(const WayRuns& runs, const WayRuns& all, const FrictionLine* first,
                      const VelocityFrictionOptions& options) {
  MovingFriction friction;
  friction.coulomb_Nm.resize(options.bins);
  friction.viscous_Nm_s_per_rad.resize(options.bins);
  const FrictionLine mean = fitOrder(runs, 0, true);
  const double zero_Nm = options.torqueConstant_Nm_per_A * options.zeroError_A;
  friction.coulombMean_Nm = {mean.coulomb.real(), std::hypot(std::sqrt(mean.coulombVariance), zero_Nm,
                                                             options.scaleError * mean.coulomb.real())};
  friction.viscousMean_Nm_s_per_rad = {
      mean.viscous.real(), std::hypot(std::sqrt(mean.viscousVariance), options.scaleError * mean.viscous.real())};
  std::vector<FrictionLine> lines{mean};
  const double mostVariance = options.mostError * options.mostError * std::norm(mean.coulomb);
  size_t highest = 0;  // finer ones than any run's bins show are no part of the map
  for (const RunSpectrum& one : all.spectra) highest = std::max(highest, one.torque_Nm.size() - 1);
  for (size_t k = 1; k <= highest; ++k) {
    lines.push_back(k == 1 && first ? *first : fitOrder(runs, k, k <= options.highestViscousOrder));
    if (k == 1 && first) continue;
    // What fast runs blur the slowest may still show: position torque is the same at any speed.
    if (runs.spectra.size() < all.spectra.size() && lines[k].coulombVariance > mostVariance)
      lines[k] = fitOrder(all, k, false);
  }
  const auto viscous = weighViscous(lines, mean.viscous, options);
  const auto coulomb = weighCoulomb(lines, viscous, runs, mean.coulomb);
  Curve coulombCurve(friction.coulomb_Nm), viscousCurve(friction.viscous_Nm_s_per_rad);
  coulombCurve.add(0, mean.coulomb, std::pow(friction.coulombMean_Nm.standardError, 2));
  viscousCurve.add(0, mean.viscous, std::pow(friction.viscousMean_Nm_s_per_rad.standardError, 2));
  for (size_t k = 1; k < lines.size(); ++k) {
    coulombCurve.add(k, coulomb[k].value, coulomb[k].variance);
    viscousCurve.add(k, viscous[k].value, viscous[k].variance);
  }
  const double angleError_rad = std::hypot(options.angleError_rad, options.disc.angleError_rad());
  coulombCurve.finish(angleError_rad);
  viscousCurve.finish(angleError_rad);
  return friction;
}

}  // namespace

Estimate meanCurrent_A(const VelocityRun& run) {
  const double sign = signOf(run.way());
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
  auto found = wayRunsOf(runs, options);
  if (!found) return found.error();
  auto& ways = *found;
  if (options.disc.known()) widenBySwing(ways, options.inertia_kg_m2, options.disc);
  freeOfInertia(ways, options.inertia_kg_m2, options.inertiaError_kg_m2);
  const bool swung = takeOffEncoderSwing(ways, options.disc.known());
  const auto all = ways;
  size_t leftOut[2];
  for (size_t w = 0; w < 2; ++w) leftOut[w] = prepare(ways[w], options);
  const auto swing = swung ? swingOf(ways) : std::nullopt;
  std::array<MovingFriction, 2> friction;
  for (size_t w = 0; w < 2; ++w) {
    friction[w] = fitWay(ways[w], all[w], swing ? &swing->lines[w] : nullptr, options);
    friction[w].leftOut = leftOut[w];
  }
  return friction;
}

std::vector<double> movingCurrent_A(const std::vector<VelocityRun>& runs, Way way,
                                    const VelocityFrictionOptions& options) {
  std::vector<VelocityRun> slowest;
  for (auto& parts : bySpeed(runs)) {
    if (parts.front().way() != way) continue;
    if (slowest.empty() || std::abs(parts[0].target_rad_per_s) < std::abs(slowest[0].target_rad_per_s))
      slowest = std::move(parts);
  }
  if (slowest.empty()) return {};
  const RunSpectrum spectrum = spectrumOf(slowest, options);
  std::vector<Estimate> bins(slowest[0].bins.size());
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
