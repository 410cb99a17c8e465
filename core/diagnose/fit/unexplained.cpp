#include "diagnose/fit/unexplained.h"

#include <algorithm>
#include <cmath>

#include "diagnose/fit/inverse_rows.h"
#include "diagnose/fit/servo_start.h"
#include "diagnose/simulate/simulator.h"

namespace breakaway {

namespace {

constexpr double memory_s = 0.3;  ///< over which a gain in speed is told

/// The track as it was before encoder and drive changed it, if the model says that they did.
Track actualTrack(const Model& model, const Simulator& simulator, const Track& track) {
  Track actual = track.rowsFrom(0, track.rows() - 1);
  if (model.servo) actual.input = reconstructedInput(model, track);
  if (simulator.stepper().terms().empty() && !simulator.changesInput()) return actual;
  for (size_t k = 0; k < track.rows(); ++k) {
    actual.position[k] = simulator.truePosition(track.position[k]);
    if (!model.servo) actual.input[k] = simulator.input(k);
  }
  return actual;
}

/// The current that the model expects, from the voltage left for the windings.
struct Winding {
  double current = 0.0;  ///< A
  double slope = 0.0;    ///< A/s

  void advance(const Physics& p, double volts, double dt) {
    const double settled = volts / p.resistance;
    const double before = current;
    current = settled + (current - settled) * (p.inductance > 0.0 ? std::exp(-dt * p.resistance / p.inductance) : 0.0);
    slope = dt > 0.0 ? (current - before) / dt : 0.0;
  }
};

/// With the torque in every row.
Unexplained along(const Model& model, const Track& track, Simulator& simulator, const InverseRows& rows) {
  const Stepper& stepper = simulator.stepper();
  const Physics& p = stepper.physics();
  const size_t n = rows.time.size();
  Unexplained out;
  out.step_s = rows.step_s;
  out.inertia = p.inertia;
  out.time = rows.time;
  out.position = rows.position;
  out.velocity = rows.velocity;
  for (auto* values : {&out.acceleration, &out.drive, &out.current, &out.speedingUp, &out.travel, &out.torque})
    values->assign(n, 0.0);
  if (p.electrical && !track.current.empty()) out.voltage.assign(n, 0.0);
  out.usable = rows.moving;
  out.driven.assign(n, 0);
  out.row.assign(n, 0);
  MotionState state;
  Winding winding, read;  // what acts, and what a sensor reads at each row
  size_t row = 0;
  double usualSpeed = n > 0 ? std::abs(rows.velocity[0]) : 0.0;
  double way = 0.0, turned = n > 0 ? rows.position[0] : 0.0;
  for (size_t k = 0; k < n; ++k) {
    while (row + 1 < track.rows() && track.time[row + 1] <= rows.time[k] + 1e-9) ++row;
    out.row[k] = row;
    simulator.stepperAt(row);
    const double t = rows.time[k], u = rows.input[k], v = rows.velocity[k];
    const double uNow = 0.5 * (rows.input[k > 0 ? k - 1 : 0] + u);  // held from row to row: at the instant the mean
    const double s = v > 0.0 ? 1.0 : -1.0;
    const bool connected = track.connected[row] != 0;
    if (std::abs(v) > 4.0 * rows.velocityNoise && s != way) {
      way = s;
      turned = rows.position[k];
    }
    state.position = rows.position[k];
    state.velocity = track.motion.resting.empty() || track.motion.resting[row] == 0 ? v : 0.0;
    state.acceleration = rows.acceleration[k];
    state.turned = turned;
    state.way = way;
    if (!track.motion.rest_s.empty()) state.rest_s = track.motion.rest_s[row];
    double current = 0.0, slope = 0.0;
    if (p.electrical && connected) {
      const double lost = stepper.losesVoltage() ? stepper.lostVoltage(state, u, state.position, v, t) : 0.0;
      const Winding before = winding;
      winding.advance(p, u - lost - p.backEmf * v, rows.step_s);
      // At the instant itself: what the inductance keeps, or the mean of what acts before and after.
      current = p.inductance > 0.0 ? before.current : 0.5 * (before.current + winding.current);
      slope = winding.slope;
      out.driven[k] = 1;
      if (!out.voltage.empty()) {
        const double readNow = p.inductance > 0.0 ? read.current : winding.current;
        const double until = k + 1 < n ? 0.5 * (v + rows.velocity[k + 1]) : v;  // the mean speed up to the next row
        read.advance(p, u - lost - p.backEmf * until, rows.step_s);
        if (std::isfinite(track.current[row]))
          out.voltage[k] = p.resistance * (simulator.sensed(readNow, slope) - track.current[row]);
      }
    } else if (p.electrical) {
      winding = read = {};
    } else if (connected) {
      current = model.input == DriveInput::current ? uNow : 0.0;
      out.driven[k] = 1;
    }
    const double drive = !connected ? 0.0 : p.electrical ? p.torqueConstant * current : p.torqueConstant * uNow;
    const Stepper::Forces forces = stepper.forcesAt(state, rows.position[k], v, s, drive, t);
    const double resistance = p.viscous * v + forces.load + s * forces.friction;
    out.drive[k] = drive;
    out.current[k] = current;
    usualSpeed += -std::expm1(-rows.step_s / memory_s) * (std::abs(v) - usualSpeed);
    out.speedingUp[k] = (std::abs(v) - usualSpeed) / memory_s;
    out.travel[k] = std::abs(rows.position[k] - turned);
    out.acceleration[k] = (drive - resistance) / p.inertia;
    out.torque[k] = drive - resistance - p.inertia * rows.acceleration[k];
    if (!stepper.remembers() || k + 1 == n) continue;
    MotionState next = state;
    next.position = rows.position[k + 1];
    next.velocity = rows.velocity[k + 1];
    next.acceleration = rows.acceleration[k + 1];
    next.current = p.electrical ? current : 0.0;
    stepper.keepHistory(next, state, u, rows.step_s, t + rows.step_s);
    state = next;
  }
  return out;
}

/// The rows with what was recorded of the drive `late_s` afterwards.
InverseRows driveMoved(InverseRows rows, double late_s) {
  const std::vector<double> recorded = rows.input;
  const auto last = static_cast<double>(recorded.size()) - 1.0;
  for (size_t k = 0; k < recorded.size(); ++k) {
    const double at = std::clamp(static_cast<double>(k) + late_s / rows.step_s, 0.0, last);
    const auto before = static_cast<size_t>(at);
    const double part = at - static_cast<double>(before);
    rows.input[k] = (1.0 - part) * recorded[before] + part * recorded[std::min(before + 1, recorded.size() - 1)];
  }
  return rows;
}

}  // namespace

Unexplained unexplainedAlong(const Model& model, const Track& track) {
  Simulator simulator(model, track, 0, track.rows() - 1);
  Unexplained out = along(model, track, simulator, inverseRows(actualTrack(model, simulator, track)));
  for (size_t k = 0; k < out.torque.size(); ++k) {
    if (out.usable[k] == 0) out.torque[k] = 0.0;
  }
  return out;
}

std::vector<double> torqueAlong(const Model& model, const Track& track, const InverseRows& rows) {
  Simulator simulator(model, track, 0, track.rows() - 1);
  const double late_s = simulator.physics().driveLate_s.value_or(0.0);
  return along(model, track, simulator, late_s != 0.0 ? driveMoved(rows, late_s) : rows).torque;
}

}  // namespace breakaway
