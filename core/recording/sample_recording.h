// From a drive's samples to a sealed recording.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/axis.h"
#include "base/result.h"
#include "recording/recording.h"
#include "recording/sample.h"

namespace breakaway {

/// The samples as a recording in the columns of columns.h, named for the axis. Fails when there is none.
Result<Recording> sealSamples(const std::string& name, std::span<const Sample> samples,
                              std::vector<std::pair<std::string, std::string>> notes, Axis axis = Axis::rotary);

}  // namespace breakaway
