#include "recording/import/number_text.h"

#include <fmt/core.h>

namespace breakaway {

std::string shortText(double value) {
  return fmt::format("{:.9g}", value);
}

}  // namespace breakaway
