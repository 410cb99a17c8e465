// A tuning as files and in words.
#pragma once

#include <string>

#include "motor/bench.h"
#include "stability/tuning_study.h"

namespace breakaway {

/// Into `folder`: tuning.json (breakaway.tuning/1), bench.json (the bench file with the tuned controller),
/// root_locus.csv, response.csv, noise.csv, figures/*.svg.
Result<void> writeTuning(const TuningStudy& study, const Bench& bench, const std::string& folder);

/// What tuning.json holds, but for where it comes from (base/made.h). `name` is the rig's.
std::string tuningJson(const TuningStudy& study, const std::string& name);

/// The bench file's `controller`: the tuned velocity loop.
BenchController controllerOf(const Tuning& tuning);

/// Gains, margins at the worst corner, the rule beside the exact bounds, and noise, one sentence per line.
std::string inWords(const TuningStudy& study);

}  // namespace breakaway
