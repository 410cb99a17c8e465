#include "experiment/travel.h"

#include <fmt/core.h>

namespace breakaway {

std::string millimetresText(double length_m) {
  return fmt::format("{:.1f} mm", 1e3 * length_m);
}

double indexTolerance_m(double count_m) {
  return 1e-4 + 8.0 * count_m;
}

}  // namespace breakaway
