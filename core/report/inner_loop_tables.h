// Speed observer and current loop over their bandwidth, as tables and in words.
#pragma once

#include <string>
#include <vector>

#include "stability/tuning_study.h"

namespace breakaway {

/// A line of a table; what isn't finite stays empty.
std::string numberRow(const std::vector<double>& values);

/// CSV, a line a bandwidth; what no gains hold for has only its bandwidth and what holds it.
std::string speedObserverTable(const TuningStudy& study);
/// The same; its head alone without a winding.
std::string currentLoopTable(const TuningStudy& study);

/// What they are, by whom, and the lines around it from a quarter to four times of it.
std::string innerLoopWords(const TuningStudy& study);

}  // namespace breakaway
