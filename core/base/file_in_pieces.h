// Files that are too large to be held at once, written as whole as any other (atomic_file.h).
#pragma once

#include <functional>
#include <string>

#include "base/result.h"

namespace breakaway {

/// As writeFile(), with `next` giving one piece after the other, an empty one at the end. Its error ends the writing,
/// and nothing has changed.
Result<void> writeFileInPieces(const std::string& path, const std::function<Result<std::string>()>& next);

}  // namespace breakaway
