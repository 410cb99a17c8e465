// A fleet as a table for other programs.
#pragma once

#include <string>
#include <vector>

#include "fleet/entry.h"

namespace breakaway {

/// One row an entry, in their order: `id`, `verdict`, `names` (blanks between), `gain` with `_low95` and `_high95`,
/// `heldout_before`, `heldout_after`, `floor`, `channel`; each base parameter with `_low95` and `_high95`; the
/// findings' parameters as EFFECT.PARAMETER; `stands_out` (robust deviations) and `stands_out_by`; `at`, `report`,
/// `error`; further fields of the manifest by their own names, "manifest_NAME" where that is one of these. What an
/// entry doesn't have is empty. Texts are quoted where they must be (RFC 4180); lines end with a line feed.
std::string summaryCsv(const std::vector<FleetEntry>& entries);

/// Names of the further fields over all entries, in the order in which they come.
std::vector<std::string> furtherNames(const std::vector<FleetEntry>& entries);

}  // namespace breakaway
