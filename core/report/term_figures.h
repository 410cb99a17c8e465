// Pictures of what an effect adds, each over the axis on which a technician would look for it.
#pragma once

#include <vector>

#include "diagnose/diagnosis.h"
#include "diagnose/simulate/track.h"
#include "report/diagnosis_figures.h"

namespace breakaway {

/// The findings' terms with their 95 % intervals, over the axis that Effect::drawnOver() names; effects that name none
/// have no picture. `tracks` are the training recordings.
std::vector<NamedFigure> termFigures(const Diagnosis& diagnosis, const std::vector<Track>& tracks);

}  // namespace breakaway
