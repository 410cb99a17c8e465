// Numbers in remarks and errors.
#pragma once

#include <string>

namespace breakaway {

/// At most nine digits.
std::string shortText(double value);

}  // namespace breakaway
