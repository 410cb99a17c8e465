// Numbers as text from which the same number comes back.
#pragma once

#include <string>

namespace breakaway {

/// The shortest text that reads back to the same double; `appendExact` puts it behind what is there.
std::string exactText(double value);
void appendExact(std::string& text, double value);

}  // namespace breakaway
