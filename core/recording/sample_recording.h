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

/// The names of a sample's columns on this axis, in order.
std::vector<std::string> sampleColumns(Axis axis);

/// Appends the sample's values in that order.
void appendRow(const Sample& sample, std::vector<double>& rows);

/// The samples as a recording in the columns of columns.h, named for the axis. Fails when there is none.
Result<Recording> sealSamples(const std::string& name, std::span<const Sample> samples,
                              std::vector<std::pair<std::string, std::string>> notes, Axis axis = Axis::rotary);

}  // namespace breakaway
