// The table of a fleet's page: sorted by any column and filtered in the browser, however long it is.
#pragma once

#include <string>
#include <vector>

#include "fleet/entry.h"
#include "fleet/spread.h"

namespace breakaway {

/// A report's path or address as a page's links have it: what isn't plain is spelled out, so that no path is anything
/// but a path, and nothing in it has to be escaped.
std::string addressOf(const std::string& report);

/// Rows that stand in the page as such, for browsers that run no script.
inline constexpr size_t plainRows = 200;

/// Columns of the table, with the fleet in the order of `order`: HTML of the table with its first rows, the data of all
/// rows as JSON by columns with four digits, and the script that draws the rows that are seen.
std::string fleetTable(const std::vector<FleetEntry>& entries, const std::vector<FleetColumn>& base,
                       const std::vector<StandsOut>& order);

}  // namespace breakaway
