// Every figure of the bench, in the order in which a reader meets them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "experiment/drive.h"
#include "figures/bench_figure.h"
#include "figures/external_torque_figures.h"
#include "figures/pulse_figures.h"

namespace breakaway {

struct AllFiguresOptions {
  size_t bins = 180;         ///< around the rotor
  size_t turns = 2;          ///< of the breakaway sweep each way
  double speedRun_s = 25.0;  ///< of each constant speed
  unsigned seed = 1;         ///< of the rotor that observers are judged by; the drives have their own
  PulseFigureOptions pulses;
  std::function<void(double progress, const std::string& activity)> progress;
};

/// Commissions both boards and measures every figure on them: `uneven`, whose friction varies strongly around the
/// rotor, those of slow motion, `bench` all others. `pushed` opens the board of `bench` anew, with a torque from
/// outside to come. Errors: the first that a step met.
Result<std::vector<BenchFigure>> measureFigures(std::unique_ptr<Drive> bench, std::unique_ptr<Drive> uneven,
                                                const OpenPushed& pushed, const AllFiguresOptions& options = {});

}  // namespace breakaway
