// Numbers in remarks and errors.
#pragma once

#include <string>

namespace breakaway {

/// At most nine digits.
std::string shortText(double value);
/// The shortest text that reads back as the same number.
std::string exactText(double value);

}  // namespace breakaway
