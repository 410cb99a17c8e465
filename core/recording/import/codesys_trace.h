// Traces of PLCs that are programmed with CODESYS (and of drives that are built on it): a head of keys, and for each
// variable the rows of its own stamps.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// Nothing when it isn't such a trace. The stamps' unit isn't told in it.
std::optional<Result<RawTable>> readCodesysTrace(std::string_view text, char lineEnd, const std::string& name);

}  // namespace breakaway
