// One effect that the base model lacks, as a diagnosis reports it.
#pragma once

#include <string>
#include <vector>

#include "diagnose/model/model.h"

namespace breakaway {

struct Finding {
  std::string effect;
  double share = 0.0;  ///< part of the base model's excess squared error over the floor that it takes away, 0 … 1
  double pValue = 1.0;
  std::vector<std::string> ambiguousWith;
  std::vector<Parameter> parameters;
  std::string sentence;
};

}  // namespace breakaway
