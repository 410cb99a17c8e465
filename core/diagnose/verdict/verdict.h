// What a diagnosis comes to, in one word.
#pragma once

#include <string>
#include <vector>

#include "diagnose/verdict/finding.h"

namespace breakaway {

enum class Verdict { nothingMissing, named, ambiguous, outsideCatalogue, undecided };

/// What findings amount to, and whether there is more that has no name: `outside`.
Verdict verdictOf(const std::vector<Finding>& findings, bool outside);
/// As files have it: nothing_missing, named, ambiguous, outside_catalogue, undecided.
std::string nameOf(Verdict verdict);

}  // namespace breakaway
