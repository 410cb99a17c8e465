#include "figures/stability_figures.h"

#include <algorithm>

#include "report/tuning_figures.h"
#include "stability/bench_loop.h"
#include "stability/root_locus.h"

namespace breakaway {

Result<BenchFigure> rootLocusOfBench(const CommissionedBench& bench) {
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
  return figure;
}

}  // namespace breakaway
