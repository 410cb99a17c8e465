// How far a log's rows are apart, where it says so beside them.
#pragma once

#include <optional>

#include "recording/import/raw_table.h"

namespace breakaway {

/// What a note, a line above the table or a field beside the rows tells ("dt": 0.01, "Sampling Period;10;ms",
/// "# sample rate: 100 Hz"), from 1 µs to 100 s. Nothing where none does, or several disagree; a period or an interval
/// of 1 or more needs a unit, a rate without one is in Hz.
std::optional<double> toldStep_s(const RawTable& table);

}  // namespace breakaway
