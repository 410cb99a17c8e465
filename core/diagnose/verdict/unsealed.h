// What a sealed trial's answer is worth once the trial is unsealed.
#pragma once

#include <string>
#include <vector>

#include "diagnose/verdict/verdict.h"

namespace breakaway {

/// Effects by name; inseparable twins count as one.
struct Unsealed {
  std::vector<std::string> right;   ///< concealed and named, as concealed
  std::vector<std::string> missed;  ///< concealed, not named
  std::vector<std::string> wrong;   ///< named, not concealed
  bool isRight = false;             ///< nothing missed, nothing wrong, and nothing suspected where nothing was
};

/// `outside`: the catalogue doesn't hold what was concealed, and the only right answer is to give no name and to say
/// so.
Unsealed unseal(const std::vector<std::string>& concealed, bool outside, const std::vector<std::string>& named,
                Verdict verdict);

}  // namespace breakaway
