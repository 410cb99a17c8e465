#include "base/student.h"

#include <algorithm>

namespace breakaway {

double student95(double freedom) {
  const double z = 1.959964, f = std::max(freedom, 1.0), z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4.0 * f) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * f * f) +
         (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * f * f * f);
}

}  // namespace breakaway
