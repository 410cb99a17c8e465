// A tuning as files and in words.
#pragma once

#include <string>

#include "motor/bench.h"
#include "stability/tuning_study.h"

namespace breakaway {

/// Into `folder`: tuning.json (breakaway.tuning/1), bench.json (the bench file with the tuned controller),
/// root_locus.csv, response.csv, noise.csv, figures/*.svg.
Result<void> writeTuning(const TuningStudy& study, const Bench& bench, const std::string& folder);

/// The bench file's `controller`: the tuned velocity loop.
BenchController controllerOf(const Tuning& tuning);

/// Gains, margins at the worst corner, the rule beside the exact bounds, and noise, one sentence per line.
std::string inWords(const TuningStudy& study);

}  // namespace breakaway
