// Rig files of linear axes, for tests and figures.
#pragma once

#include <cstdio>
#include <string>

#include "base/random.h"

namespace breakaway::test {

/// What makes an axis odd; the rest goes with it.
struct LinearAxis {
  double length_m = 0.4, mass_kg = 1.8, counts_per_m = 1e6, coulomb_N = 5.0, forceConstant_N_per_A = 14.0;
  double resistance_ohm = 2.2, supply_V = 24.0;
  double start = 0.3;  ///< part of the travel at which it stands at power-up
  bool hasIndex = true;
  double scatter = 0.01, gainError = 0.0;
  std::string more;  ///< further fields of the rig file, each with a comma before it
};

/// `seed` draws the curves' phases and swings.
inline std::string linearRigText(const LinearAxis& axis, unsigned seed) {
  Noise noise(seed);
  const auto number = [](double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", value);
    return std::string(text);
  };
  const auto wave = [&](int order, double most) {
    return "[" + std::to_string(order) + ", " + number(most * (0.3 + 0.7 * noise.uniform())) + ", " +
           number(6.28 * noise.uniform()) + "]";
  };
  const auto curve = [&](const std::string& name, double mean, double swing) {
    return "  \"" + name + "\": {\"mean\": " + number(mean) + ", \"harmonics\": [" + wave(1, swing) + ", " +
           wave(2, 0.5 * swing) + ", " + wave(4, 0.25 * swing) + "]},\n";
  };
  const double free_m_per_s = axis.supply_V / axis.forceConstant_N_per_A;
  std::string text =
      "{\"schema\": \"breakaway.rig/1\", \"name\": \"axis\", \"axis\": \"linear\", \"loop_rate_Hz\": 5000,\n";
  text += " \"travel\": {\"length_m\": " + number(axis.length_m) +
          ", \"start_m\": " + number(axis.start * axis.length_m) +
          "},\n \"motor\": {\"force_constant_N_per_A\": " + number(axis.forceConstant_N_per_A) +
          ", \"back_emf_constant_V_s_per_m\": " + number(axis.forceConstant_N_per_A) +
          ", \"resistance_ohm\": " + number(axis.resistance_ohm) +
          ", \"inductance_H\": " + number(1e-3 * axis.resistance_ohm) + ", \"mass_kg\": " + number(axis.mass_kg) +
          "},\n \"friction\": {\n";
  for (const char* way : {"_cw", "_ccw"}) {
    text += curve(std::string("static") + way, axis.coulomb_N * (1.2 + 0.1 * noise.uniform()), 0.15);
    text += curve(std::string("coulomb") + way, axis.coulomb_N * (0.97 + 0.06 * noise.uniform()), 0.14);
    text += curve(std::string("viscous") + way, 0.6 * axis.coulomb_N / free_m_per_s, 0.12);
  }
  text += "  \"stribeck_velocity_m_per_s\": " + number(0.006 + 0.004 * noise.uniform()) +
          ", \"scatter_rms\": " + number(axis.scatter) + "},\n \"position_force\": {\"harmonics_N\": [" +
          wave(10, 0.08 * axis.coulomb_N) + "]},\n \"encoder\": {\"counts_per_m\": " + number(axis.counts_per_m);
  if (axis.hasIndex) text += ", \"index_m\": " + number(0.55 * axis.length_m);
  text +=
      "},\n \"current_sensor\": {\"sensitivity_V_per_A\": 0.185, \"offset_A\": 0.05, \"drift_A_per_s\": 1e-5, "
      "\"noise_rms_A\": 0.017, \"adc_bits\": 12, \"adc_range_V\": 5.0, \"gain_error\": " +
      number(axis.gainError) + "},\n \"bridge\": {\"supply_V\": " + number(axis.supply_V) +
      ", \"dead_zone_duty\": 0.01, \"pwm_steps\": 4800}" + axis.more + "\n}\n";
  return text;
}

}  // namespace breakaway::test
