// JSON of one object per sample.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "recording/import/json_cells.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// The samples' fields are columns, objects and short lists within them flattened; entries of one signal each are put
/// together.
Result<RawTable> samplesOf(const std::vector<const Json*>& samples, const std::string& name);

/// {"0": {"time": 0.1, …}, "1": {…}, …}: samples by their number, stamp or key.
bool areSamplesByKey(const Json& json);

/// Those samples; keys that are stamps are a field of their own: numbers other than the samples' own, or dates.
Json withKeys(const Json& json);

}  // namespace breakaway
