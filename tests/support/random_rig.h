// Rig files at random, for what must hold on rigs that nobody has looked at.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

#include "base/random.h"

namespace breakaway::test {

class RandomRig {
 public:
  explicit RandomRig(unsigned seed) : noise_(seed) {}

  /// A whole rig file: motor of 5 mNm to 1 Nm friction, loop rate, encoder, supply and sensor chosen to go with it.
  /// With `honest` the bridge loses up to 2.8 % of the supply over its first per cents of duty, as discontinuous
  /// current does, the supply has an impedance, the current sensor warms up and sits on a supply of its own, and the
  /// encoder has the tolerances of a good one.
  std::string text(bool honest = false) {
    const double Kt = logUniform(0.02, 0.4), supply = pick({12.0, 24.0, 36.0, 48.0});
    // Friction current from 60 mA to 1.2 A: what a sensor of 5 A with 17 mA noise is bought for.
    const double coulomb = Kt * logUniform(0.06, 1.2), excess = uniform(1.15, 1.6);
    const double resistance = uniform(0.02, 0.12) * supply / (coulomb / Kt * uniform(1.0, 2.0));
    const double free = supply / Kt;
    const double viscous = coulomb * uniform(0.1, 0.5) / free;
    const double inertia = coulomb / free / uniform(0.02, 0.2) * 1.0;
    std::string out = "{\n \"schema\": \"breakaway.rig/1\", \"name\": \"random\", \"loop_rate_Hz\": " +
                      number(pick({1000.0, 2000.0, 4000.0, 5000.0, 10000.0, 20000.0})) + ",\n";
    out += " \"motor\": {\"torque_constant_Nm_per_A\": " + number(Kt) +
           ", \"back_emf_constant_V_s_per_rad\": " + number(Kt) + ", \"resistance_ohm\": " + number(resistance) +
           ", \"inductance_H\": " + number(resistance * logUniform(3e-4, 2e-3)) +
           ", \"inertia_kg_m2\": " + number(inertia) + "},\n \"friction\": {\n";
    for (const char* way : {"cw", "ccw"}) {
      out += std::string("  \"static_") + way + "\": " + curve(coulomb * excess * uniform(0.95, 1.05), 0.25) + ",\n";
      out += std::string("  \"coulomb_") + way + "\": " + curve(coulomb * uniform(0.95, 1.05), 0.2) + ",\n";
      out += std::string("  \"viscous_") + way + "\": " + curve(viscous * uniform(0.9, 1.1), 0.15) + ",\n";
    }
    out += "  \"stribeck_velocity_rad_per_s\": " + number(uniform(0.5, 3.0)) +
           ", \"scatter_rms\": " + number(uniform(0.005, 0.015)) + "},\n";
    out += " \"position_torque\": {\"harmonics_Nm\": [[1, " + number(coulomb * uniform(0.0, 0.1)) + ", " + phase() +
           "], [" + number(pick({6.0, 8.0, 12.0, 14.0, 18.0})) + ", " + number(coulomb * uniform(0.02, 0.25)) + ", " +
           phase() + "]]},\n";
    out += " \"encoder\": {\"counts_per_rev\": " +
           number(pick({2000.0, 4000.0, 4096.0, 8192.0, 10000.0, 14400.0, 20000.0})) +
           ", \"index_angle_rad\": " + number(uniform(-6.0, 6.0));
    if (honest) out += ", \"eccentricity_rad\": 3e-4, \"quadrature_error_counts\": 0.1, \"index_width_counts\": 2";
    out += "},\n";
    out += " \"current_sensor\": {\"sensitivity_V_per_A\": 0.185, \"offset_A\": " + number(uniform(-0.06, 0.06)) +
           ", \"drift_A_per_s\": " + number(uniform(-2e-5, 2e-5)) +
           ", \"noise_rms_A\": 0.017, \"adc_bits\": 12, \"adc_range_V\": 5.0";
    if (honest) {
      out +=
          ", \"supply_deviation_V\": 0.01, \"offset_V_per_degC\": -0.00026, \"temperature_rise_degC\": 12, "
          "\"temperature_time_s\": 400";
    }
    out += "},\n";
    const double steps = pick({1000.0, 2400.0, 4800.0}), deadZone = uniform(0.0, 0.02);
    out += " \"bridge\": {\"supply_V\": " + number(supply) + ", \"dead_zone_duty\": " + number(deadZone) +
           ", \"pwm_steps\": " + number(steps);
    return out + (honest ? ", " + dutyCurve(deadZone) + ", \"supply_resistance_ohm\": 0.02" : "") + "}\n}\n";
  }

 private:
  double uniform(double low, double high) { return low + (high - low) * noise_.uniform(); }
  double logUniform(double low, double high) { return low * std::pow(high / low, noise_.uniform()); }
  template <size_t N>
  double pick(const double (&values)[N]) {
    return values[static_cast<size_t>(noise_.uniform() * N)];
  }
  std::string phase() { return number(uniform(0.0, 6.28)); }
  static std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
  }
  /// x − a·(1 − e^(−x/b)) beyond the dead zone, sampled.
  std::string dutyCurve(double deadZone) {
    const double scale = uniform(0.01, 0.04), lost = scale * uniform(0.2, 0.7);
    std::string out = "\"duty_curve\": [";
    for (int k = 1; k <= 24; ++k) {
      const double x = 0.25 * std::pow(k / 24.0, 2.0);
      out +=
          (k == 1 ? "[" : ", [") + number(deadZone + x) + ", " + number(x - lost * (1.0 - std::exp(-x / scale))) + "]";
    }
    return out + "]";
  }
  /// Two to four harmonics up to order 9 whose rms together is up to `most` of the mean, and at least half of it.
  std::string curve(double mean, double most) {
    const int count = 2 + static_cast<int>(3.0 * noise_.uniform());
    const double each = uniform(0.5, 1.0) * most / std::sqrt(0.5 * count);
    std::string out = "{\"mean\": " + number(mean) + ", \"harmonics\": [";
    int order = 0;
    for (int k = 0; k < count; ++k) {
      order += 1 + static_cast<int>(2.0 * noise_.uniform());
      out += (k == 0 ? "[" : ", [") + number(order) + ", " +
             number(each * uniform(0.7, 1.0) / (count > 3 ? 1.2 : 1.0)) + ", " + phase() + "]";
    }
    return out + "]}";
  }

  Noise noise_;
};

}  // namespace breakaway::test
