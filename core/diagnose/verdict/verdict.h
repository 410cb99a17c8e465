// What a diagnosis comes to, in one word.
#pragma once

#include <string>

namespace breakaway {

enum class Verdict { nothingMissing, named, ambiguous, outsideCatalogue };

/// The contract's name: nothing_missing, named, ambiguous, outside_catalogue.
std::string nameOf(Verdict verdict);

}  // namespace breakaway
