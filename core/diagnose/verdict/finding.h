// One effect that the base model lacks, as a diagnosis reports it.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "diagnose/model/model.h"

namespace breakaway {

struct Finding {
  std::string effect;
  double share = 0.0;  ///< part of the base model's excess squared error over the floor that it takes away, 0 … 1
  double pValue = 1.0;
  std::vector<std::string> ambiguousWith;
  std::vector<Parameter> parameters;
  Message sentence;
  bool saysSomething = true;  ///< its own size can't be nothing, nor what wanders anyway, nor more than the drive gives
};

/// The first of its rivals that isn't the twin which no recording tells from it; null: it has no such rival.
const std::string* realRival(const Finding& finding);
/// Whether each is something that happens in one recording only, at a time of its own.
bool allHappenOnce(const std::vector<Finding>& findings);

}  // namespace breakaway
