// Variables as Octave's `save -text` writes them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Matrices by their columns, ranges and scalars; texts, cells and others are left out. Nothing: the text is none.
std::optional<Result<RawTable>> readOctaveText(std::string_view text, char lineEnd, const std::string& name);

}  // namespace breakaway
