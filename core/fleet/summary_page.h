// A fleet as one HTML page that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "fleet/entry.h"

namespace breakaway {

/// The verdicts, what stands out, all entries in a table (fleet_table.h), how each parameter is spread, what was found,
/// the trend by date where there is more than one, and the errors.
std::string summaryPage(const std::vector<FleetEntry>& entries);

}  // namespace breakaway
