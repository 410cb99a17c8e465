// The one experiment to run next: it separates rivals, shows what this recording can't, or looks closer at a place.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "diagnose/model/excitation.h"
#include "diagnose/verdict/finding.h"
#include "diagnose/verdict/place.h"
#include "diagnose/verdict/verdict.h"
#include "motor/bench.h"
#include "motor/maneuver.h"

namespace breakaway {

struct NextExperiment {
  Message sentence;  ///< with speeds, angles and amplitudes within the bench's limits and what was seen
  std::vector<std::string> separates;
  Maneuver maneuver = {};  ///< the same for a board; empty where it takes hands
};

/// By the verdict: rivals first; then what was found, to confirm it; then the place that nothing explains; with nothing
/// missing, the experiment that would show the most effects that these recordings could not show at all.
NextExperiment nextExperiment(Verdict verdict, const std::vector<Finding>& findings, const std::vector<Place>& where,
                              const Bench& bench, const Excitation& seen);

/// The experiment that would show the most of what recordings like these can't; without a sentence if they show all.
NextExperiment mostInformative(const Excitation& seen);

/// Effects that recordings like these can't show, though others of the same rig could.
std::vector<std::string> unseenEffects(const Excitation& seen);

}  // namespace breakaway
