// Numbers in remarks and errors.
#pragma once

#include <cstddef>
#include <string>

#include "base/message.h"

namespace breakaway {

/// At most nine digits.
std::string shortText(double value);
/// "1 place", "2 places".
Message placesIn(size_t count);

}  // namespace breakaway
