#include "diagnose/simulate/simulation.h"

#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/simulator.h"

namespace breakaway {

Trace simulate(const Model& model, const Track& track, double restartEvery_s) {
  Simulator simulator(model, track, 0, track.rows() - 1);
  const bool electrical = simulator.physics().electrical;
  Trace trace;
  trace.restarts = restartRows(track, restartEvery_s);
  trace.position.resize(track.rows());
  trace.velocity.resize(track.rows());
  if (electrical) trace.current_A.resize(track.rows());
  MotionState state;
  size_t next = 0;
  for (size_t row = 0; row < track.rows(); ++row) {
    if (next < trace.restarts.size() && trace.restarts[next] == row) {
      state = simulator.restart(row, state);
      ++next;
    }
    trace.position[row] = simulator.shown(state.position);
    trace.velocity[row] = state.velocity;
    if (electrical) trace.current_A[row] = state.current;
    if (row + 1 < track.rows()) simulator.run(state, row, row + 1);
  }
  return trace;
}

Result<Trace> simulate(const Model& model, const Recording& recording, const SimulateOptions& options) {
  const auto track =
      makeTrack(recording, model.axis, model.input, model.supply_V, model.count, model.servo.has_value());
  if (!track) return track.error();
  const auto terms = termsOf(model);
  if (!terms) return terms.error();
  Trace trace = simulate(model, *track, options.restartEvery_s);
  if (!track->speedAlone()) {
    for (double& one : trace.position) one -= 0.5 * model.count;  // as the encoder shows it, on average
  }
  return trace;
}

}  // namespace breakaway
