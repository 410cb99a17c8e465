#include "diagnose/simulate/simulation.h"

#include "diagnose/simulate/physics.h"
#include "diagnose/simulate/restart.h"

namespace breakaway {

Trace simulate(const Physics& physics, const std::vector<CompiledTerm>& terms, const Track& track,
               double restartEvery_s, double horizon_s) {
  Stepper stepper(physics, terms);
  Trace trace;
  trace.restarts = restartRows(track, restartEvery_s);
  trace.position.resize(track.rows());
  trace.velocity.resize(track.rows());
  if (physics.electrical) trace.current_A.resize(track.rows());
  MotionState state;
  size_t next = 0;
  for (size_t row = 0; row < track.rows(); ++row) {
    if (next < trace.restarts.size() && trace.restarts[next] == row) {
      state = restartState(stepper, track, row, horizon_s);
      ++next;
    }
    trace.position[row] = state.position;
    trace.velocity[row] = state.velocity;
    if (physics.electrical) trace.current_A[row] = state.current;
    if (row + 1 < track.rows()) run(stepper, track, row, row + 1, state);
  }
  return trace;
}

Result<Trace> simulate(const Model& model, const Recording& recording, const SimulateOptions& options) {
  const auto track = makeTrack(recording, model.axis, model.input, model.supply_V, model.count);
  if (!track) return track.error();
  const auto terms = termsOf(model);
  if (!terms) return terms.error();
  return simulate(physicsOf(model), *terms, *track, options.restartEvery_s, model.restartHorizon_s);
}

}  // namespace breakaway
