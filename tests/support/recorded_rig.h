// Recordings of rigs whose physics a test chooses, made with the simulated rig's plant: its own integrator, finer than
// the diagnosis'.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.h"
#include "motor/bench.h"
#include "plant/plant.h"
#include "plant/rig.h"
#include "recording/recording.h"

namespace breakaway::test {

struct RigRecording {
  std::string effects = "[]";         ///< JSON array of a rig file's concealed effects
  std::string positionTorque = "[]";  ///< harmonics_Nm
  double coulomb_Nm = 0.012;
  double static_Nm = 0.012;
  double stribeckVelocity_rad_per_s = 1.5;
  double asymmetry = 0.0;  ///< relative difference of the Coulomb friction, ccw more than cw
  double viscousAsymmetry = 0.0;
  std::string waves = "[]";  ///< relative harmonics of static and Coulomb friction, both ways
  double countsPerRev = 14400;
  double seconds = 40.0;
  double amplitude_rad_per_s = 14.0;
  bool currentDrive = false;  ///< the recording is driven by current_A (mean over each row), else by voltage_V
  double currentNoise_A = 0.01;
  bool voltageToo = false;       ///< the voltage is recorded beside the current that drives
  double currentOffset_A = 0.0;  ///< of the sensor; the current is recorded beside the voltage where there is one
  double wander_Nm = 0.0;        ///< rms of a torque that wanders at random, correlated over 0.1 s; for driving voltage
  double push_Nm = 0.0, pushFrom_s = 0.0, pushTo_s = 0.0;  ///< once, from outside; for driving voltage
  double speedStep_rad_per_s = 0.0;                        ///< not 0: the speed alone is recorded, in such steps
  unsigned seed = 1;
};

struct RecordedRig {
  Bench bench;
  Recording recording;
};

inline std::string rigText(const RigRecording& w) {
  const auto curve = [](double mean, const std::string& waves) {
    return "{\"mean\": " + std::to_string(mean) + ", \"harmonics\": " + waves + "}";
  };
  const double up = 1.0 + 0.5 * w.asymmetry, down = 1.0 - 0.5 * w.asymmetry;
  const double bUp = 1.0 + 0.5 * w.viscousAsymmetry, bDown = 1.0 - 0.5 * w.viscousAsymmetry;
  char viscous[2][40];
  std::snprintf(viscous[0], sizeof viscous[0], "%.9f", 2e-4 * bDown);
  std::snprintf(viscous[1], sizeof viscous[1], "%.9f", 2e-4 * bUp);
  return R"({"schema": "breakaway.rig/1", "name": "test", "loop_rate_Hz": 5000,
    "motor": {"torque_constant_Nm_per_A": 0.07, "back_emf_constant_V_s_per_rad": 0.07, "resistance_ohm": 1.2, "inductance_H": 0.0011, "inertia_kg_m2": 6e-5},
    "friction": {"static_cw": )" +
         curve(w.static_Nm * down, w.waves) + ", \"static_ccw\": " + curve(w.static_Nm * up, w.waves) +
         ", \"coulomb_cw\": " + curve(w.coulomb_Nm * down, w.waves) +
         ", \"coulomb_ccw\": " + curve(w.coulomb_Nm * up, w.waves) + ", \"viscous_cw\": {\"mean\": " + viscous[0] +
         ", \"harmonics\": []}, \"viscous_ccw\": {\"mean\": " + viscous[1] +
         ", \"harmonics\": []}, \"stribeck_velocity_rad_per_s\": " + std::to_string(w.stribeckVelocity_rad_per_s) +
         ", \"scatter_rms\": 0.01}, \"position_torque\": {\"harmonics_Nm\": " + w.positionTorque +
         R"(}, "encoder": {"counts_per_rev": 14400, "index_angle_rad": 0.3},
    "bridge": {"supply_V": 24.0, "dead_zone_duty": 0.0, "pwm_steps": 4800}, "effects": )" +
         w.effects + "}";
}

/// A velocity loop at 1 kHz along a sum of slow sines, recorded row by row.
inline RecordedRig recordRig(const RigRecording& wanted) {
  const auto rig = readRigText(rigText(wanted), "test.rig.json");
  if (!rig) std::fprintf(stderr, "%s\n", rig.error().message().c_str());
  Plant plant(*rig, 5e-5, wanted.seed);
  Noise noise(wanted.seed + 77);
  const double count = 2.0 * std::numbers::pi / wanted.countsPerRev, step = 1e-3;
  const double phase = noise.uniform() * 6.28, second = noise.uniform() * 6.28;
  std::vector<double> time, angle, voltage, current, turning;
  double integral = 0.0, last = 0.0, speed = 0.0, wander = 0.0;
  Noise wanders(wanted.seed + 133);
  for (size_t k = 0; k < static_cast<size_t>(wanted.seconds / step); ++k) {
    const double t = static_cast<double>(k) * step;
    const double seen = std::floor((plant.angle_rad() + 0.3) / count) * count;
    if (k == 0) last = seen;
    speed += 0.2 * ((seen - last) / step - speed);
    last = seen;
    const double reference = wanted.amplitude_rad_per_s * (0.6 * std::sin(2.0 * std::numbers::pi * 0.17 * t + phase) +
                                                           0.4 * std::sin(2.0 * std::numbers::pi * 0.71 * t + second));
    const double error = reference - speed;
    integral += 2.0 * error * step;
    const double volts = std::round((0.08 * error + integral + 0.07 * reference) * 200.0) / 200.0;
    time.push_back(t);
    angle.push_back(seen);
    if (wanted.speedStep_rad_per_s > 0.0)
      turning.push_back(wanted.speedStep_rad_per_s *
                        std::round(plant.velocity_rad_per_s() / wanted.speedStep_rad_per_s));
    voltage.push_back(volts);
    const double push = t >= wanted.pushFrom_s && t < wanted.pushTo_s ? wanted.push_Nm : 0.0;
    plant.applyVoltage(volts + (push + wander) * 1.2 / 0.07);
    wander += std::sqrt(0.02) * wanted.wander_Nm * wanders.normal() - 0.01 * wander;
    double sum = 0.0;
    for (int part = 0; part < 20; ++part) {
      plant.advance(1);
      sum += plant.current_A();
    }
    current.push_back(sum / 20.0 + wanted.currentNoise_A * noise.normal() + wanted.currentOffset_A);
  }
  std::vector<Channel> channels{{"time_s", time}, {"angle_rad", angle}};
  if (wanted.speedStep_rad_per_s > 0.0) channels.back() = {"velocity_rad_per_s", turning};
  if (!wanted.currentDrive || wanted.voltageToo) channels.push_back({"voltage_V", voltage});
  if (wanted.currentDrive || wanted.currentOffset_A != 0.0) channels.push_back({"current_A", current});
  RecordedRig out{{}, *Recording::seal("test.csv", std::move(channels))};
  out.bench.name = "test";
  out.bench.input = wanted.currentDrive ? DriveInput::current : DriveInput::voltage;
  out.bench.countsPerUnit = wanted.countsPerRev;
  out.bench.motor = {0.07, 0.07, 1.3, 0.0011, 7e-5, 1e-4, 0.01};
  out.bench.trusted = {"torque_constant_Nm_per_A"};
  return out;
}

}  // namespace breakaway::test
