// Lists by name, as scripts hold them: "rpm = [0.0, 61.4, 76.2]", "t = [0 0.01 0.02];".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

/// The longest lists are columns, single numbers notes. Nothing: the text holds anything else than such lists, numbers
/// by name and comments.
std::optional<Result<RawTable>> readNamedLists(std::string_view text, const std::string& name);

}  // namespace breakaway
