#include "session/torque_view.h"

#include <algorithm>

#include "diagnose/fit/motion.h"

namespace breakaway {

std::optional<TorqueView> torqueViewOf(const Diagnosis& diagnosis, const Model& model, const Recording& recording) {
  if (!diagnosis.fit.inTorque()) return {};
  auto track = makeTrack(recording, model.axis, model.input, model.supply_V, model.count, model.servo.has_value());
  if (!track) return {};
  track->motion = motionOf(*track);
  TorqueView view{torqueTrace(diagnosis.base, *track), torqueTrace(model, *track), {}, 0.0};
  view.along.position = track->position;
  view.along.velocity = track->motion.velocity;
  view.along.current_A = track->current;
  view.wander = std::max(diagnosis.fit.floor, diagnosis.fit.floorWithWander);
  return view;
}

}  // namespace breakaway
