#include "identify/way_runs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/statistics.h"
#include "identify/run_spectrum.h"

namespace breakaway {

namespace {

using Complex = std::complex<double>;
constexpr double coulombShare = 0.1, coulombPart = 0.06;  // of the orders; rms amplitude over the mean

/// What stands out of harmonics that all have this variance.
std::vector<WeighedHarmonic> weighAll(const std::vector<Complex>& harmonics, double variance, Complex mean) {
  std::vector<HarmonicEvidence> evidence;
  evidence.reserve(harmonics.size());
  for (const Complex& one : harmonics) evidence.push_back({one, variance});
  const HarmonicPrior prior = learnt(evidence, coulombPrior(mean), coulombOrders);
  std::vector<WeighedHarmonic> known;
  known.reserve(evidence.size());
  for (const HarmonicEvidence& one : evidence) known.push_back(weighed(one, prior));
  return known;
}

/// Of a curve whose values stand for their bins' middles, as a breakaway map's do.
Complex harmonicOfPoints(const std::vector<double>& values, size_t order) {
  const double x = static_cast<double>(order) * std::numbers::pi / static_cast<double>(values.size());
  return harmonicOf(values, order) * (order == 0 ? 1.0 : std::sin(x) / x);
}

/// Breakaway torque that is equal and opposite both ways is position torque, and holds the moving rotor alike. Friction
/// at an order, which has one sign both ways, is the doubt about it. The noise is told by the map's finest orders.
void expectPosition(std::array<WayRuns, 2>& ways, const std::array<std::vector<double>, 2>& static_Nm, size_t highest) {
  const size_t bins = static_Nm[0].size();
  if (bins == 0 || static_Nm[1].size() != bins) return;
  std::vector<double> finest;
  const size_t last = (bins - 1) / 2;
  for (size_t k = bins / 4; k <= last; ++k) {
    for (const auto& way : static_Nm) finest.push_back(0.5 * std::norm(harmonicOfPoints(way, k)));
  }
  // Of half a sum or difference of both ways. A gear's teeth or a stepper's steps may be among these orders.
  const double noise = 0.5 * quantile(finest, 0.5) / std::numbers::ln2;
  std::vector<Complex> position, friction;
  for (size_t k = 1; k <= std::min(highest, last); ++k) {
    const Complex cw = harmonicOfPoints(static_Nm[0], k), ccw = harmonicOfPoints(static_Nm[1], k);
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

/// B·ω_k of each run: a rotor that speeds up and slows down within the turn meets viscous friction that does so, too.
void freeOfRipple(WayRuns& way) {
  const double viscous = fitOrder(way, 0, true).viscous.real();
  for (RunSpectrum& run : way.spectra) {
    for (size_t k = 1; k < run.torque_Nm.size(); ++k) run.torque_Nm[k] -= viscous * run.ripple_rad_per_s[k];
  }
}

}  // namespace

HarmonicPrior coulombPrior(Complex mean) {
  return {coulombShare, 0.5 * coulombPart * coulombPart * std::norm(mean)};
}

Result<std::array<WayRuns, 2>> wayRunsOf(const std::vector<VelocityRun>& runs, const VelocityFrictionOptions& options) {
  std::array<WayRuns, 2> ways;
  for (const auto& parts : bySpeed(runs))
    ways[static_cast<size_t>(parts.front().way())].spectra.push_back(spectrumOf(parts, options));
  for (size_t w = 0; w < 2; ++w) {
    WayRuns& way = ways[w];
    if (way.spectra.size() < 2) {
      return Error{std::string("velocity sweep, ") + (w == 0 ? "cw" : "ccw"),
                   message("has {} speeds, expected at least two", way.spectra.size())};
    }
    std::sort(way.spectra.begin(), way.spectra.end(),
              [](const auto& a, const auto& b) { return a.speed_rad_per_s < b.speed_rad_per_s; });
    way.fall.assign(way.spectra.size(), 0.0);
    way.widened_Nm2 = way.fall;
    const auto& still = options.static_Nm[w];
    for (size_t k = 0; !still.empty() && k <= std::min(options.highestOrder, still.size() / 3); ++k)
      way.static_Nm.push_back(harmonicOfPoints(still, k));
  }
  if (!ways[0].static_Nm.empty() && !ways[1].static_Nm.empty()) {
    expectPosition(ways, options.static_Nm, options.highestOrder);
    const double speed = findFall(ways);
    for (WayRuns& way : ways) setFall(way, speed);
  }
  for (WayRuns& way : ways) freeOfRipple(way);
  return ways;
}

}  // namespace breakaway
