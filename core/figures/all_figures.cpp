#include "figures/all_figures.h"

#include <utility>

#include "base/numbers.h"
#include "figures/chain_figures.h"
#include "figures/commissioned_bench.h"
#include "figures/compensation_figures.h"
#include "figures/friction_figures.h"
#include "figures/homing_figures.h"
#include "figures/motion_figures.h"
#include "figures/observer_figures.h"
#include "figures/stability_figures.h"

namespace breakaway {

namespace {

using Figures = std::vector<BenchFigure>;

Result<Figures> alone(Result<BenchFigure> figure) {
  if (!figure) return figure.error();
  return Figures{std::move(*figure)};
}

/// The identified rotor, its sensors as they were measured, for judging observers.
ObserverFigureOptions observersOf(const CommissionedBench& bench, unsigned seed) {
  ObserverFigureOptions options;
  options.rotor.inertia_kg_m2 = bench.inertia_kg_m2();
  options.rotor.torqueConstant_Nm_per_A = bench.torqueConstant_Nm_per_A();
  options.rotor.count_rad = turn_rad / bench.measured.identity.countsPerRev;
  options.rotor.tick_s = 1.0 / bench.measured.identity.loopRate_Hz;
  options.rotor.currentNoise_A = bench.measured.noiseRms_A;
  options.rotor.seed = seed;
  return options;
}

/// All that one commissioned board shows, in the reader's order.
Result<Figures> ofBench(CommissionedBench& bench, const OpenPushed& pushed, const AllFiguresOptions& options) {
  const std::vector<std::function<Result<Figures>()>> chapters{
      [&] { return alone(bridgeFigure(bench.measured)); },
      [&] { return alone(currentSensorFigure(bench.measured)); },
      [&] { return alone(currentStepFigure(bench)); },
      [&] { return alone(indexPassesFigure(bench)); },
      [&] { return alone(constantVelocityFigure(bench.measured)); },
      [&] { return constantVelocityOverTimeFigures(bench); },
      [&] { return rootLociOfBench(bench); },
      [&] { return alone(onePulseFigure(bench, options.pulses)); },
      [&] { return twoWayPulseFigures(bench, options.pulses); },
      [&] { return externalTorqueFigures(bench, pushed); },
      [&] { return alone(methodsFigure(bench)); },
      [&] { return alone(positionStepFigure(bench)); },
      [&] { return alone(velocityRampFigure(bench)); },
      [&] { return Result<Figures>(staticFrictionFigures(bench.measured)); },
      [&] { return Result<Figures>(Figures{breakawayMapFigure(bench.measured)}); },
      [&] { return Result<Figures>(viscousFigures(bench.measured)); },
      [&] { return alone(totalViscousFigure(bench.measured)); },
      [&] { return alone(overallFrictionFigure(bench.measured)); },
      [&] { return alone(velocityEstimatorFigure(observersOf(bench, options.seed))); },
      [&] { return alone(disturbanceCutoffFigure(observersOf(bench, options.seed))); },
  };
  Figures all;
  for (size_t k = 0; k < chapters.size(); ++k) {
    if (options.progress)
      options.progress(0.5 + 0.2 * static_cast<double>(k) / static_cast<double>(chapters.size()), "measuring figures");
    auto some = chapters[k]();
    if (!some) return some.error();
    for (BenchFigure& one : *some) all.push_back(std::move(one));
  }
  return all;
}

CommissionOptions commissioning(const AllFiguresOptions& options, double from, double share) {
  CommissionOptions commission;
  commission.sweeps.bins = options.bins;
  commission.sweeps.turns = options.turns;
  commission.sweeps.speedRun_s = options.speedRun_s;
  commission.keepRecordings = false;
  if (options.progress) {
    commission.progress = [&options, from, share](double part, const std::string& activity) {
      options.progress(from + share * part, activity);
    };
  }
  return commission;
}

}  // namespace

Result<std::vector<BenchFigure>> measureFigures(std::unique_ptr<Drive> bench, std::unique_ptr<Drive> uneven,
                                                const OpenPushed& pushed, const AllFiguresOptions& options) {
  auto even = commissionBench(std::move(bench), commissioning(options, 0.0, 0.5));
  if (!even) return even.error();
  auto figures = ofBench(*even, pushed, options);
  if (!figures) return figures.error();
  auto other = commissionBench(std::move(uneven), commissioning(options, 0.7, 0.28));
  if (!other) return other.error();
  auto slow = slowMotionFigure(*other);
  if (!slow) return slow.error();
  figures->push_back(std::move(*slow));
  return figures;
}

}  // namespace breakaway
