// One effect that the base model lacks, as a diagnosis reports it.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "diagnose/model/model.h"

namespace breakaway {

/// What another effect in a finding's place makes of held-out data, the other findings beside it.
struct RivalScore {
  std::string effect;
  double error = 0.0, low95 = 0.0, high95 = 0.0;  ///< RMSE as FitScore::heldoutAfter
  /// Over the error with the finding, on the same windows: 1 is as good, more is worse.
  double ratio = 1.0, ratioLow95 = 1.0, ratioHigh95 = 1.0;
};

struct Finding {
  std::string effect;
  double share = 0.0;  ///< part of the base model's excess squared error over the floor that it takes away, 0 … 1
  double pValue = 1.0;
  std::vector<std::string> ambiguousWith;
  std::vector<RivalScore> rivals = {};  ///< all that were fitted in its place, the least error first
  std::vector<Parameter> parameters;
  Message sentence;
  bool saysSomething = true;  ///< its own size can't be nothing, nor what wanders anyway, nor more than the drive gives
};

/// The first of its rivals that isn't the twin which no recording tells from it; null: it has no such rival.
const std::string* realRival(const Finding& finding);
/// Whether held-out data can't tell a rival from the finding: it errs neither less nor more for sure.
bool errsAlike(const RivalScore& rival);
/// Whether each is something that happens in one recording only, at a time of its own.
bool allHappenOnce(const std::vector<Finding>& findings);

}  // namespace breakaway
