#include "support/foreign_motor.h"

#include <algorithm>
#include <cstddef>

namespace breakaway::test {

namespace {

constexpr std::array<Motor, 6> makes{{{"gimbal motor", false, 0.06, 6.0, 2e-3, 2.5e-5, 1.5e-3, 12.0, 8192.0},
                                      {"hobby servo", false, 1.0, 3.0, 5e-4, 5e-3, 0.1, 7.4, 4096.0},
                                      {"brushless motor", false, 0.06, 0.5, 5e-4, 2e-5, 0.02, 24.0, 4000.0},
                                      {"NEMA 23", false, 0.35, 1.2, 3e-3, 5e-5, 0.04, 36.0, 4000.0},
                                      {"400 W servo", false, 0.5, 1.6, 6e-3, 1.5e-4, 0.06, 160.0, 65536.0},
                                      {"belt axis", true, 60.0, 2.0, 4e-3, 12.0, 25.0, 100.0, 2e5}}};

}  // namespace

Motor motorFrom(Draw& draw, bool rotary) {
  Motor m = makes[static_cast<size_t>(draw.whole(0, rotary ? 4 : 5))];
  for (double* value : {&m.constant, &m.resistance, &m.inductance, &m.inertia, &m.coulomb})
    *value *= draw.evenly(0.6, 1.7);
  m.counts *= draw.oneOf(std::array{0.5, 1.0, 2.0});
  m.most_A = std::min(0.8 * m.supply_V / m.resistance, draw.evenly(6.0, 20.0) * m.coulomb / m.constant);
  m.fastest = std::min(0.8 * m.supply_V / m.constant, m.linear ? 0.8 : 250.0);
  m.viscous = m.coulomb / m.fastest * draw.evenly(0.2, 1.5);
  return m;
}

}  // namespace breakaway::test
