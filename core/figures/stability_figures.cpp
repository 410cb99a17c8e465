#include "figures/stability_figures.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "draw/html_report.h"
#include "report/tuning_figures.h"
#include "stability/bench_loop.h"
#include "stability/root_locus.h"

namespace breakaway {

namespace {

Curve polesAt(const ServoLoop& loop, double cutoff_rad_per_s, const std::string& label, int colour) {
  Curve marks{label, {}, {}};
  for (const auto& pole : poles(closedLoop(withCutoff(loop, cutoff_rad_per_s)))) {
    if (std::abs(pole) < 1e-6) continue;
    const auto s = std::log(pole) / loop.board.tick_s;
    marks.x.push_back(s.real());
    marks.y.push_back(s.imag());
  }
  marks.style = Curve::Style::points;
  marks.colour = colour;
  marks.width_px = 4.0;
  return marks;
}

/// The same poles as those of continuous time, where one can read how fast and how damped they are.
BenchFigure slowPoles(const ServoLoop& loop, const RootLocus& locus, const BenchFigure& discrete,
                      const CutoffBounds& bounds) {
  BenchFigure figure{"root-locus-slow",
                     "The same poles as s = ln(z)/T, near the origin; arrows point to where they go as the observer's "
                     "cutoff g grows. Left of the dashed lines the loop is damped by 0.707 and more.",
                     slowPolesFigure(loop, locus),
                     {}};
  for (size_t branch = 0; branch < locus.branches.size(); ++branch) {
    const std::string name = "pole_" + std::to_string(branch + 1);
    Channel cutoff{"cutoff_rad_per_s", {}}, real{name + "_real_per_s", {}}, imaginary{name + "_imaginary_per_s", {}};
    for (size_t k = 0; k < locus.branches[branch].size(); ++k) {
      const auto& pole = locus.branches[branch][k];
      // A pole at z = 0 has no counterpart: e^−14 of it is left after a tick at most.
      const auto s = std::log(std::abs(pole) > 1e-6 ? pole : std::complex<double>(1e-6)) / loop.board.tick_s;
      cutoff.values.push_back(locus.cutoff_rad_per_s[k]);
      real.values.push_back(s.real());
      imaginary.values.push_back(s.imag());
    }
    if (figure.columns.empty()) figure.columns.push_back(std::move(cutoff));
    figure.columns.push_back(std::move(real));
    figure.columns.push_back(std::move(imaginary));
  }
  const double tuned = loop.settings.observer_cutoff_rad_per_s;
  double slowest = -1e300, leastDamping = 1.0;
  for (const auto& pole : poles(closedLoop(loop))) {
    if (std::abs(pole) < 1e-6) continue;
    const auto s = std::log(pole) / loop.board.tick_s;
    slowest = std::max(slowest, s.real());
    leastDamping = std::min(leastDamping, -s.real() / std::abs(s));
  }
  if (bounds.lessDamped_rad_per_s) {
    figure.figure.curves.push_back(polesAt(loop, *bounds.lessDamped_rad_per_s,
                                           "at g = " + numberText(*bounds.lessDamped_rad_per_s, 3) + " rad/s", 2));
  }
  figure.keyNumbers = {
      {"tuned_cutoff_rad_per_s", tuned}, {"slowest_pole_per_s", slowest}, {"least_damping", leastDamping}};
  for (const auto& [name, value] : discrete.keyNumbers) {
    if (name == "less_damped_rad_per_s") figure.keyNumbers.emplace_back(name, value);
  }
  return figure;
}

}  // namespace

Result<std::vector<BenchFigure>> rootLociOfBench(const CommissionedBench& bench) {
  BoardTiming timing;
  timing.tick_s = 1.0 / bench.measured.identity.loopRate_Hz;
  auto loop = loopOfBench(bench.measured.bench, timing);
  if (!loop) return loop.error();
  const ControllerSettings& tuned = bench.measured.settings;
  loop->settings.observer_cutoff_rad_per_s = tuned.observer_cutoff_rad_per_s;
  loop->settings.gains.velocity_kp_A_s_per_rad = tuned.velocity_kp_A_s_per_rad;
  loop->settings.gains.velocity_ki_A_per_rad = tuned.velocity_ki_A_per_rad;
  const CutoffBounds bounds = cutoffBounds(*loop);
  const double highest = 1.2 * bounds.unstable_rad_per_s.value_or(bounds.searched_rad_per_s / 1.2);
  const RootLocus locus = rootLocus(*loop, decades(0.1 * tuned.observer_cutoff_rad_per_s, highest, 300));
  BenchFigure figure{"root-locus",
                     "Poles of the sampled velocity loop around the measured motor over the observer's cutoff, and "
                     "where they are at the tuned one. Outside the unit circle the loop is unstable.",
                     rootLocusFigure(*loop, locus),
                     {{"cutoff_rad_per_s", locus.cutoff_rad_per_s}}};
  for (size_t branch = 0; branch < locus.branches.size(); ++branch) {
    const std::string name = "pole_" + std::to_string(branch + 1);
    Channel real{name + "_real", {}}, imaginary{name + "_imaginary", {}};
    for (const auto& pole : locus.branches[branch]) {
      real.values.push_back(pole.real());
      imaginary.values.push_back(pole.imag());
    }
    figure.columns.push_back(std::move(real));
    figure.columns.push_back(std::move(imaginary));
  }
  figure.keyNumbers = {{"tuned_cutoff_rad_per_s", tuned.observer_cutoff_rad_per_s},
                       {"rule_of_thumb_rad_per_s", bounds.ruleOfThumb_rad_per_s}};
  if (bounds.lessDamped_rad_per_s)
    figure.keyNumbers.emplace_back("less_damped_rad_per_s", *bounds.lessDamped_rad_per_s);
  if (bounds.unstable_rad_per_s) figure.keyNumbers.emplace_back("unstable_rad_per_s", *bounds.unstable_rad_per_s);
  return std::vector<BenchFigure>{figure, slowPoles(*loop, locus, figure, bounds)};
}

}  // namespace breakaway
