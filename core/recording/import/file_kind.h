// What kind of file it is, by its first bytes.
#pragma once

#include <optional>
#include <string_view>

#include "base/message.h"

namespace breakaway {

/// What a file is that import doesn't read, and what makes one of it that import reads: "is a Parquet file; pandas
/// converts it: …". Nothing for files that it may read.
std::optional<Message> unreadKind(std::string_view bytes, std::string_view name);

}  // namespace breakaway
