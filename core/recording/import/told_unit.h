// Units that lines above a table tell, where names tell none.
#pragma once

#include <optional>
#include <string>

#include "recording/import/raw_table.h"

namespace breakaway {

/// "deg" or "rad" where a line above the table says in what its angles are ("inDegrees=yes", "Angles are in radians.").
std::optional<std::string> toldAngleUnit(const RawTable& table);

}  // namespace breakaway
