#include "support/foreign_families.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace breakaway::test {

namespace {

std::string part(double of, double whole) {
  return fmt::format("{:.0f} % of the friction", 100.0 * of / whole);
}

using C = Concealed;
using M = Motor;
using D = Draw;

/// Two masses that swing against each other at so many Hz.
void twoMasses(C& c, const M& m, D& draw, double Hz, double damping) {
  c.loadInertia = draw.evenly(0.4, 3.0) * m.inertia;
  const double reduced = m.inertia * c.loadInertia / (m.inertia + c.loadInertia), swing = turn * Hz;
  c.stiffness = swing * swing * reduced;
  c.damping = 2.0 * damping * swing * reduced;
  c.loadFriction = draw.chance(0.5) ? draw.between(0.02, 0.3) : 0.0;
}

std::vector<Family> catalogued() {
  constexpr auto an = Conceals::anEffect;
  std::vector<Family> all;
  all.push_back({{"backlash", an}, false, false, false, true, [](C& c, const M& m, D& d, double, double) {
                   twoMasses(c, m, d, d.evenly(30.0, 125.0), d.evenly(0.1, 0.5));
                   c.play = std::max(m.linear ? d.evenly(5e-5, 1e-3) : d.evenly(8e-3, 0.08), 12.0 * m.count());
                   return fmt::format("play of {:.2g}, load {:.1f} J with {:.0f} % of the friction", c.play,
                                      c.loadInertia / m.inertia, 100.0 * c.loadFriction);
                 }});
  all.push_back({{"compliance", an}, false, false, false, true, [](C& c, const M& m, D& d, double, double rate_Hz) {
                   const double Hz = d.evenly(15.0, std::min(150.0, rate_Hz / 6.0));
                   twoMasses(c, m, d, Hz, d.evenly(0.01, 0.1));
                   return fmt::format("swings at {:.0f} Hz, load {:.1f} J with {:.0f} % of the friction", Hz,
                                      c.loadInertia / m.inertia, 100.0 * c.loadFriction);
                 }});
  all.push_back({{"end_stop", an}, false, false, true, false, [](C& c, const M& m, D& d, double, double) {
                   const double swing = turn * d.evenly(5.0, 80.0);
                   c.stopStiffness = swing * swing * m.inertia;
                   c.stopDamping = 2.0 * d.evenly(0.03, 0.5) * swing * m.inertia;
                   return fmt::format("a stop of {:.0f} Hz", swing / turn);
                 }});
  all.push_back({{"transport_delay", an}, false, false, false, true, [](C& c, const M&, D& d, double, double rate_Hz) {
                   c.late_s = std::clamp(d.evenly(1.5, 8.0) / rate_Hz, 1.5e-3, 0.02);
                   return fmt::format("{:.1f} ms late", 1e3 * c.late_s);
                 }});
  all.push_back({{"stribeck", an}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.stribeck = d.between(0.2, 0.5) * m.coulomb;
                   c.stribeckSpeed = d.evenly(0.01, 0.06) * m.fastest;
                   return part(c.stribeck, m.coulomb);
                 }});
  all.push_back({{"presliding", an}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   const double over = d.evenly(6.0, 60.0);
                   c.bristle = m.coulomb / (over * m.count());
                   return fmt::format("over {:.0f} counts", over);
                 }});
  all.push_back({{"constant_load", an}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.load = d.sign() * d.between(0.08, 0.5) * m.coulomb;
                   return part(c.load, m.coulomb);
                 }});
  all.push_back({{"imbalance", an}, true, false, true, false, [](C& c, const M& m, D& d, double, double) {
                   c.arm = d.between(0.12, 0.6) * m.coulomb;
                   c.armDown = d.between(-3.0, 3.0);
                   return part(c.arm, m.coulomb);
                 }});
  const auto waves = [](const M& m, D& d, int most, auto orderOf) {
    std::vector<Wave> some;
    const int count = d.whole(1, most);
    some.reserve(static_cast<size_t>(count));
    for (int k = 0; k < count; ++k)
      some.push_back({d.between(0.12, 0.4) * m.coulomb / (k + 1), orderOf(), d.between(0.0, turn)});
    return some;
  };
  const auto orders = [](const std::vector<Wave>& some, double coulomb) {
    std::string words = "orders";
    for (const Wave& wave : some) words += fmt::format(" {} ({:.0f} %)", wave.order, 100.0 * wave.amplitude / coulomb);
    return words;
  };
  all.push_back({{"cogging", an}, false, false, true, false, [=](C& c, const M& m, D& d, double, double) {
                   c.detents = waves(m, d, 3, [&] {
                     return m.linear ? d.whole(1, 2) : d.oneOf(std::array{4, 6, 7, 8, 12, 14, 21, 24, 42});
                   });
                   return orders(c.detents, m.coulomb);
                 }});
  all.push_back(
      {{"position_dependent_friction", an}, false, false, true, false, [=](C& c, const M& m, D& d, double, double) {
         c.uneven = waves(m, d, 2, [&] { return m.linear ? 1 : d.whole(1, 6); });
         return orders(c.uneven, m.coulomb);
       }});
  all.push_back({{"load_dependent_friction", an}, false, false, false, false, [](C& c, const M&, D& d, double, double) {
                   c.ofTorque = d.between(0.1, 0.3);
                   return fmt::format("{:.0f} % of the torque", 100.0 * c.ofTorque);
                 }});
  all.push_back({{"dead_time", an}, false, true, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.deadVolts = d.between(0.01, 0.05) * m.supply_V;
                   return fmt::format("{:.2g} V", c.deadVolts);
                 }});
  all.push_back({{"winding_heating", an}, false, true, false, false, [](C& c, const M&, D& d, double, double) {
                   c.warming = d.between(0.12, 0.4);
                   c.warming_s = d.evenly(5.0, 30.0);
                   return fmt::format("{:.0f} %, within {:.0f} s", 100.0 * c.warming, c.warming_s);
                 }});
  all.push_back({{"quadratic_drag", an}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.drag = d.between(0.3, 1.2) * m.coulomb / std::pow(0.5 * m.fastest, 2);
                   return fmt::format("{:.0f} % of the friction at half speed",
                                      25.0 * c.drag * m.fastest * m.fastest / m.coulomb);
                 }});
  all.push_back({{"torque_saturation", an}, false, false, false, false, [](C& c, const M&, D& d, double, double) {
                   c.saturation = d.between(0.15, 0.5);
                   return fmt::format("1/{:.2f} at the peak", 1.0 + c.saturation);
                 }});
  all.push_back({{"supply_sag", an}, false, true, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.source_ohm = d.between(0.06, 0.25) * m.supply_V / m.most_A;
                   return fmt::format("{:.2g} ohm", c.source_ohm);
                 }});
  all.push_back({{"encoder_eccentricity", an}, true, false, true, false, [](C& c, const M& m, D& d, double, double) {
                   c.discOff = std::max(d.evenly(4e-3, 4e-2), 6.0 * m.count());
                   c.discAt = d.between(-3.0, 3.0);
                   return fmt::format("{:.2g} rad", c.discOff);
                 }});
  all.push_back(
      {{"external_disturbance", an}, false, false, false, false, [](C& c, const M& m, D& d, double length_s, double) {
         const double from_s = d.between(0.1, 0.7) * length_s;
         c.pushes = {{from_s, from_s + d.evenly(0.1, 1.0), d.sign() * d.between(0.5, 2.5) * m.coulomb}};
         return part(c.pushes[0].torque, m.coulomb);
       }});
  return all;
}

std::vector<Family> beyondCatalogue() {
  constexpr auto outside = Conceals::physicsOutside;
  std::vector<Family> all;
  all.push_back({{"torque_dead_band", outside}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.deadTorque = d.between(0.3, 0.9) * m.coulomb;
                   return part(c.deadTorque, m.coulomb);
                 }});
  all.push_back({{"breathing_friction", outside}, false, false, false, false, [](C& c, const M&, D& d, double, double) {
                   c.breathing = d.between(0.2, 0.5);
                   c.breathing_s = d.between(1.5, 8.0);
                   return fmt::format("{:.0f} % of the friction", 100.0 * c.breathing);
                 }});
  all.push_back({{"slipping_clutch", outside}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.clutch = d.between(0.3, 0.6) * m.peak();
                   return fmt::format("{:.0f} % of the peak", 100.0 * c.clutch / m.peak());
                 }});
  all.push_back({{"magnetic_catch", outside}, true, false, true, false, [](C& c, const M& m, D& d, double, double) {
                   c.catching = d.between(0.6, 1.5) * m.coulomb;
                   c.catchWidth = d.between(0.04, 0.12);
                   c.catchAt = d.between(-2.0, 2.0);
                   return part(c.catching, m.coulomb);
                 }});
  all.push_back(
      {{"friction_of_two_speeds", outside}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
         c.above = d.between(0.4, 0.8) * m.coulomb;
         c.aboveSpeed = d.between(0.15, 0.3) * m.fastest;
         return part(c.above, m.coulomb);
       }});
  all.push_back({{"thixotropy", outside}, false, false, false, false, [](C& c, const M& m, D& d, double, double) {
                   c.thinning = d.between(0.4, 0.9) * m.coulomb;
                   c.thinning_s = d.evenly(0.5, 4.0);
                   c.thinningSpeed = 0.5 * m.fastest * d.evenly(0.3, 2.0);
                   return part(c.thinning, m.coulomb);
                 }});
  return all;
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> some{{{"sound", Conceals::nothing}, false, false, false, false, {}}};
    for (auto&& more : {catalogued(), beyondCatalogue()}) some.insert(some.end(), more.begin(), more.end());
    return some;
  }();
  return all;
}

}  // namespace breakaway::test
