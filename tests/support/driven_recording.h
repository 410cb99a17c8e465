// Recordings of a model along a drive of its own, made by simulating that model.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "diagnose/simulate/simulation.h"
#include "diagnose/simulate/simulator.h"
#include "recording/recording.h"

namespace breakaway::test {

struct DrivenRecording {
  double seconds = 6.0;
  double row_s = 1e-3;
  double hold_s = 4e-3;  ///< the drive changes this often
  double size = 1.0;     ///< of the drive
  bool current = true;   ///< the current is recorded where voltage drives
  bool pulses = false;   ///< the drive jumps and rests, and is 4.5 to 9 times the Coulomb friction at size 1
};

/// Starts, turns, stops and rests, with faster motion on top; twice the Coulomb friction at `unit` = F and size 1.
inline double mixedDrive(double t, double unit) {
  const double pause = std::fmod(t, 3.0) < 2.4 ? 1.0 : 0.0;
  return pause * unit * (2.0 * std::sin(4.1 * t) + 1.1 * std::sin(17.0 * t + 1.0) + 0.5 * std::sin(61.0 * t));
}

/// Jumps from rest and back, one way and the other.
inline double pulsedDrive(double t, double unit) {
  const double number = std::floor(t / 0.6), within = t - 0.6 * number;
  const double way = std::fmod(number, 2.0) < 0.5 ? 1.0 : -1.0, strength = 1.0 + 0.5 * std::fmod(number, 3.0);
  return within < 0.07 ? way * strength * 4.5 * unit : 0.0;
}

/// Drive input that is the Coulomb friction of a model at standstill: Nm, A or V.
inline double frictionInput(const Model& model) {
  const double torque = model.baseValue("coulomb_Nm").value_or(0.012);
  if (model.input == DriveInput::torque) return torque;
  const double current = torque / model.baseValue("torque_constant_Nm_per_A").value_or(1.0);
  return model.input == DriveInput::current ? current : current * model.baseValue("resistance_ohm").value_or(1.0);
}

/// What encoder and current sensor would show, without noise, if `model` were the rig.
inline Recording drivenRecording(const Model& model, const DrivenRecording& wanted) {
  Bench names;
  names.input = model.input;
  std::vector<double> time, input, angle, current;
  for (long k = 0; k < std::lround(wanted.seconds / wanted.row_s); ++k) {
    time.push_back(static_cast<double>(k) * wanted.row_s);
    const double held = std::floor(time.back() / wanted.hold_s + 1e-6) * wanted.hold_s;
    const double unit = wanted.size * frictionInput(model);
    input.push_back(wanted.pulses ? pulsedDrive(held, unit) : mixedDrive(held, unit));
    angle.push_back(0.0);
  }
  const auto seal = [&] {
    std::vector<Channel> channels{{"time_s", time}, {"angle_rad", angle}, {names.inputChannel(), input}};
    if (!current.empty()) channels.push_back({"current_A", current});
    return *Recording::seal("driven.csv", channels);
  };
  const Track track = *makeTrack(seal(), model.axis, model.input, model.supply_V, model.count);
  Simulator simulator(model, track, 0, track.rows() - 1);
  MotionState state;
  for (size_t k = 0; k < track.rows(); ++k) {
    angle[k] = simulator.shown(state.position);
    if (simulator.physics().electrical && wanted.current) {
      const Physics& p = simulator.physics();
      const double slope =
          p.inductance > 0.0
              ? (simulator.input(k) - p.resistance * state.current - p.backEmf * state.velocity) / p.inductance
              : 0.0;
      current.push_back(simulator.sensed(state.current, slope));
    }
    if (k + 1 < track.rows()) simulator.run(state, k, k + 1);
  }
  return seal();
}

}  // namespace breakaway::test
