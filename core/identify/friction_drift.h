// How friction changed while breakaways were measured.
#pragma once

#include <optional>
#include <vector>

#include "base/estimate.h"
#include "base/message.h"
#include "friction/measurements.h"

namespace breakaway {

struct FrictionDrift {
  Estimate part;            ///< of the mean torque that starts motion, from the first breakaway to the last
  double duration_s = 0.0;  ///< between these
};

/// By places where motion was started at least twice, each way; the mean of both ways, so that a load that grows isn't
/// taken for friction. Nothing where no place was, or one way only.
std::optional<FrictionDrift> frictionDrift(const std::vector<BreakawayEvent>& events);

/// What to say of it; nothing where it is no more than 5 % for sure, which any rig's friction may wander by.
std::optional<Message> wordsOf(const FrictionDrift& drift);

}  // namespace breakaway
