// WPILOG: what robot controllers and the SysId routine record.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "recording/import/raw_table.h"

namespace breakaway {

bool isWpilog(std::string_view bytes);

/// All entries of numbers and truths, over the stamps of the first position (or else of the longest entry); the others
/// hold their last value there. Units are those of the entries' metadata. The state of SysId's routine becomes a column
/// of numbers, one per test. Errors, at `name`: damaged, no numbers.
Result<RawTable> readWpilog(std::string_view bytes, const std::string& name);

}  // namespace breakaway
