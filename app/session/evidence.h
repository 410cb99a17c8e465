// What shows that something was missing: the torque that the drive gives beyond what a model needs, over the axis of
// the finding, before and after the finding is in, on data that the fit never saw.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/diagnosis.h"
#include "diagnose/verdict/explained.h"
#include "diagnose/verdict/where.h"

namespace breakaway {

struct Evidence {
  std::string effect;   ///< the finding that it is of; empty: a place
  QString axis;         ///< as Place has it
  bool linear = false;  ///< N over m, instead of Nm over rad
  ResidualMap before, after;
  Course law;  ///< what the finding says of `before`, along all that was recorded; of a place, what all say
};

/// Each finding's, over its own axis, where residuals are mapped over that; where no finding has one, the first
/// place's; nothing where there is none either. Takes as long as preparing a fit does.
std::vector<Evidence> evidenceOf(const Diagnosis& diagnosis, const Bench& bench, const Recording& recording,
                                 const std::optional<Recording>& heldout);

}  // namespace breakaway
