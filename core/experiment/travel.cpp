#include "experiment/travel.h"

#include <cstdio>

namespace breakaway {

std::string millimetresText(double length_m) {
  char text[40];
  std::snprintf(text, sizeof text, "%.1f mm", 1e3 * length_m);
  return text;
}

double indexTolerance_m(double count_m) {
  return 1e-4 + 8.0 * count_m;
}

}  // namespace breakaway
