#include "identify/velocity_friction.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "identify/encoder_swing.h"
#include "identify/friction_line.h"
#include "identify/harmonic_evidence.h"
#include "identify/run_spectrum.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double leastFall = 0.02;  // part of the fall above which a run counts as slow
// How friction varies before the map itself has said it: share of the orders that are there, their rms amplitude as
// part of the mean, and how many orders that guess counts for.
constexpr double coarseOrder = 6.0;
constexpr double viscousShare = 0.25, viscousPart = 0.08, viscousOrders = 3.0;
constexpr double coulombShare = 0.1, coulombPart = 0.06, coulombOrders = 3.0;

void addHarmonic(std::vector<Estimate>& bins, size_t order, Complex value) {
  const auto n = static_cast<double>(bins.size());
  for (size_t k = 0; k < bins.size(); ++k) {
    const double angle = turn_rad * (static_cast<double>(k) + 0.5) / n * static_cast<double>(order);
    bins[k].value += (value * std::polar(1.0, angle)).real();
  }
}

/// A curve put together from its harmonics, with the doubt that is the same in all bins.
class Curve {
 public:
  explicit Curve(std::vector<Estimate>& bins) : bins_(bins) {}

  void add(size_t order, Complex value, double variance) {
    addHarmonic(bins_, order, value);
    variance_ += variance;
  }
  void finish() {
    for (Estimate& bin : bins_) bin.standardError = std::sqrt(variance_);
  }

 private:
  std::vector<Estimate>& bins_;
  double variance_ = 0.0;
};

HarmonicPrior startPrior(double share, double part, Complex mean) {
  return {share, 0.5 * part * part * std::norm(mean)};
}

/// The viscous harmonics from 1 on, by what the runs say of them and what their like are.
std::vector<WeighedHarmonic> weighViscous(const std::vector<FrictionLine>& lines, Complex mean,
                                          const VelocityFrictionOptions& options) {
  std::vector<HarmonicEvidence> evidence;
  for (size_t k = 1; k <= options.highestViscousOrder && k < lines.size(); ++k)
    evidence.push_back({lines[k].viscous, lines[k].viscousVariance, 0.0, 0.0, chanceOf(k, coarseOrder)});
  const HarmonicPrior prior = learnt(evidence, startPrior(viscousShare, viscousPart, mean), viscousOrders);
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
  const HarmonicPrior prior = learnt(evidence, startPrior(coulombShare, coulombPart, mean), coulombOrders);
  std::vector<WeighedHarmonic> harmonics(1);
  for (const HarmonicEvidence& one : evidence) harmonics.push_back(weighed(one, prior));
  return harmonics;
}

MovingFriction fitWay(WayRuns runs, const VelocityFrictionOptions& options) {
  MovingFriction friction;
  friction.coulomb_Nm.resize(options.bins);
  friction.viscous_Nm_s_per_rad.resize(options.bins);
  const WayRuns all = runs;
  const auto slow = std::count_if(runs.fall.begin(), runs.fall.end(), [](double g) { return g > leastFall; });
  friction.leftOut = runs.static_Nm.empty() ? leaveOutStribeck(runs) : static_cast<size_t>(slow);
  widen(runs);
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
    lines.push_back(fitOrder(runs, k, k <= options.highestViscousOrder));
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
  coulombCurve.finish();
  viscousCurve.finish();
  return friction;
}

/// What stands out of harmonics that all have this variance.
std::vector<WeighedHarmonic> weighAll(const std::vector<Complex>& harmonics, double variance, Complex mean) {
  std::vector<HarmonicEvidence> evidence;
  evidence.reserve(harmonics.size());
  for (const Complex& one : harmonics) evidence.push_back({one, variance});
  const HarmonicPrior prior = learnt(evidence, startPrior(coulombShare, coulombPart, mean), coulombOrders);
  std::vector<WeighedHarmonic> known;
  known.reserve(evidence.size());
  for (const HarmonicEvidence& one : evidence) known.push_back(weighed(one, prior));
  return known;
}

/// Breakaway torque that is equal and opposite both ways is position torque, and holds the moving rotor alike. Friction
/// at an order, which has one sign both ways, is the doubt about it. The noise is told by the map's finest orders.
void expectPosition(std::array<WayRuns, 2>& ways, const std::array<std::vector<double>, 2>& static_Nm, size_t highest) {
  const size_t bins = static_Nm[0].size();
  if (bins == 0 || static_Nm[1].size() != bins) return;
  double noise = 0.0, count = 0.0;
  for (size_t k = bins / 4; k <= bins / 3; ++k) {
    for (const auto& way : static_Nm) noise += 0.5 * std::norm(harmonicOf(way, k)), count += 1.0;
  }
  noise *= 0.5 / std::max(1.0, count);  // of half a sum or difference of both ways
  std::vector<Complex> position, friction;
  for (size_t k = 1; k <= std::min(highest, bins / 6); ++k) {
    const Complex cw = harmonicOf(static_Nm[0], k), ccw = harmonicOf(static_Nm[1], k);
    position.push_back(0.5 * (ccw - cw));
    friction.push_back(0.5 * (ccw + cw));
  }
  const Complex mean = 0.5 * (harmonicOf(static_Nm[0], 0) + harmonicOf(static_Nm[1], 0));
  const auto positions = weighAll(position, noise, mean), frictions = weighAll(friction, noise, mean);
  for (size_t w = 0; w < 2; ++w) {
    ways[w].position_Nm.assign(1, 0.0);
    ways[w].positionVariance_Nm2.assign(1, 0.0);
    for (size_t k = 0; k < positions.size(); ++k) {
      ways[w].position_Nm.push_back(signOf(Way(w)) * positions[k].value);
      ways[w].positionVariance_Nm2.push_back(positions[k].variance + frictions[k].variance +
                                             std::norm(frictions[k].value));
    }
  }
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
    expectPosition(ways, options.static_Nm, options.highestOrder);
    const double speed = findFall(ways);
    for (WayRuns& way : ways) setFall(way, speed);
  }
  takeOffEncoderSwing(ways);
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
