// What shows that something was missing: the torque that the drive gives beyond what a model needs, over the axis of
// the finding, before and after the finding is in, on data that the fit never saw.
#pragma once

#include <QString>
#include <optional>

#include "diagnose/diagnosis.h"
#include "diagnose/verdict/where.h"

namespace breakaway {

struct Evidence {
  QString axis;         ///< as Place has it
  bool linear = false;  ///< N over m, instead of Nm over rad
  ResidualMap before, after;
};

/// Over the axis of the first finding, else of the first place; nothing where there is neither, or no map of it. Takes
/// as long as preparing a fit does.
std::optional<Evidence> evidenceOf(const Diagnosis& diagnosis, const Bench& bench, const Recording& recording,
                                   const std::optional<Recording>& heldout);

}  // namespace breakaway
