#include "trial/trial_recorder.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motor/bench.h"
#include "trial/trial_loop.h"

namespace breakaway {

namespace {

double rounded(double value, double step) {
  return step * std::round(value / step);
}

/// What the encoder would show with endless resolution.
double shown(const TrialSensors& sensors, double position) {
  return position + sensors.eccentricity.at(position);
}

/// The torque that an open-loop operator would ask for from the nominal motor, Nm.
double feedforward(const TrialRig& rig, const TrialCourse& course, size_t k) {
  const PlantPhysics& p = rig.physics;
  const double next = k + 1 < course.velocity.size() ? course.velocity[k + 1] : course.velocity[k];
  const double v = course.velocity[k];
  return 0.95 * p.totalInertia() * (next - v) / course.row_s + rig.viscous() * v +
         1.1 * rig.coulomb() * std::tanh(v / (0.03 * rig.topSpeed));
}

/// The drive input that gives a torque at a speed: V, duty, A or Nm, rounded as a digital drive rounds it.
double inputFor(const TrialRig& rig, double torque, double velocity) {
  const PlantPhysics& p = rig.physics;
  if (rig.input == DriveInput::torque) return rounded(torque, rig.peakTorque / 65536.0);
  const double current = torque / p.torqueConstant;
  if (rig.input == DriveInput::current) return rounded(current, rig.peakCurrent_A() / 65536.0);
  const double duty =
      rounded(std::clamp((p.resistance_ohm * current + p.torqueConstant * velocity) / rig.supply_V, -1.0, 1.0), 1e-5);
  return rig.input == DriveInput::duty ? duty : duty * rig.supply_V;
}

double plantInput(const TrialRig& rig, double input) {
  switch (rig.input) {
    case DriveInput::current:
      return input * rig.physics.torqueConstant;
    case DriveInput::duty:
      return input * rig.supply_V;
    default:
      return input;
  }
}

double plantStep_s(const PlantPhysics& p) {
  return p.coupling.present() || p.bristles.stiffness > 0.0 || p.stops.present ? 25e-6 : 50e-6;
}

}  // namespace

Recording recordTrial(const TrialRig& rig, const TrialCourse& course, const std::string& name, std::uint64_t seed,
                      TrialTrace* trace) {
  const TrialSensors& s = rig.sensors;
  const double step_s = plantStep_s(rig.physics);
  Plant plant(rig.physics, step_s, seed);
  TrialController controller(rig);
  Random random(seed ^ 0x5eed5eed5eedULL);
  const size_t rows = course.velocity.size();
  const int perRow = static_cast<int>(std::lround(s.row_s / step_s));
  const int skewSteps = static_cast<int>(std::lround(s.currentSkew_s / step_s));
  const auto skewRows = static_cast<size_t>((skewSteps + perRow - 1) / perRow);
  const int lateBy = static_cast<int>(skewRows) * perRow - skewSteps;  // steps after an earlier row

  std::vector<double> time(rows), position(rows), input(rows), sampled(rows + skewRows + 1, 0.0), current;
  for (size_t k = 0; k < rows; ++k) {
    time[k] = rounded(static_cast<double>(k) * s.row_s, 1e-6);
    const double exact = shown(s, plant.angle_rad());
    position[k] = std::floor(exact / s.count) * s.count;
    double torque = 0.0, speed = 0.0;
    if (rig.loop.mode == ControlMode::openLoop) {
      torque = feedforward(rig, course, k);
      speed = course.velocity[k];
    } else {
      torque = controller.torque(position[k], course.position[k], course.velocity[k]);
      speed = controller.velocity();
    }
    input[k] = inputFor(rig, torque + course.shake[k], speed);
    if (trace) {
      trace->position.push_back(exact);
      trace->current.push_back(plant.current_A());
      trace->input.push_back(plantInput(rig, input[k]));
    }
    if (skewRows == 0) sampled[k] = plant.current_A();
    plant.apply(plantInput(rig, input[k]));
    plant.advance(lateBy);
    if (skewRows > 0) sampled[k + skewRows] = plant.current_A();
    plant.advance(perRow - lateBy);
  }
  Bench names;
  names.axis = rig.axis;
  names.input = rig.input;
  std::vector<Channel> channels{{"time_s", std::move(time)}, {names.positionChannel(), std::move(position)}};
  if (s.current) {
    const bool commanded = rig.input == DriveInput::current;
    for (size_t k = 0; k < rows; ++k) {
      const double seen = (commanded ? input[k] : sampled[k]) + s.currentOffset_A + s.currentNoise_A * random.normal();
      current.push_back(rounded(seen, s.currentStep_A));
    }
    channels.push_back({"current_A", std::move(current)});
  }
  // Of a current, what its sensor shows stands there already.
  if (rig.input != DriveInput::current) channels.push_back({names.inputChannel(), std::move(input)});
  if (rig.loop.mode != ControlMode::openLoop && random.uniform() < 0.3 && rig.axis == Axis::rotary) {
    channels.push_back({"velocity_reference_rad_per_s", course.velocity});
  }
  auto recording = Recording::seal(name, std::move(channels));
  assert(recording.ok());
  return *recording;
}

BenchController describedLoop(const TrialRig& rig) {
  const TrialGains gains = gainsOf(rig);
  const double kt = rig.physics.torqueConstant;
  BenchController controller;
  controller.mode = rig.loop.mode;
  controller.kp = gains.kp / kt;
  controller.ki = gains.ki / kt;
  controller.kd = gains.kd / kt;
  controller.observerCutoff_rad_per_s = rig.loop.observerCutoff_rad_per_s;
  controller.nominalInertia = rig.physics.totalInertia();
  controller.nominalTorqueConstant = kt;
  controller.currentLimit_A = rig.peakCurrent_A();
  return controller;
}

}  // namespace breakaway
