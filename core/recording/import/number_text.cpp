#include "recording/import/number_text.h"

#include <fmt/core.h>

namespace breakaway {

std::string shortText(double value) {
  return fmt::format("{:.9g}", value);
}

Message placesIn(size_t count) {
  return count == 1 ? message("1 place") : message("{} places", count);
}

}  // namespace breakaway
