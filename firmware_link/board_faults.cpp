#include "firmware_link/board_faults.h"

#include <cmath>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr double resistanceStep = 1e-3;  // a plant that is prepared anew in every tick would be slow

/// Whether a shaft on its way from `before_rad` to `now_rad` passed `place_rad`, in any turn.
bool passes(double before_rad, double now_rad, double place_rad) {
  return std::floor((before_rad - place_rad) / turn_rad) != std::floor((now_rad - place_rad) / turn_rad);
}

}  // namespace

BoardFaults::BoardFaults(const std::vector<RigFault>& faults) {
  for (const RigFault& fault : faults) plays_.push_back({fault, false, false});
}

BoardTrouble BoardFaults::step(double time_s, double angle_rad) {
  BoardTrouble trouble;
  if (first_) before_rad_ = angle_rad;
  first_ = false;
  for (Play& play : plays_) {
    if (!play.fault.acts(time_s)) continue;
    if (!play.begun && play.fault.kind == FaultKind::encoderJump) slippedCounts_ += std::llround(play.fault.counts);
    play.begun = true;
    add(play, time_s, angle_rad, trouble);
  }
  trouble.slippedCounts = slippedCounts_;
  before_rad_ = angle_rad;
  return trouble;
}

void BoardFaults::add(Play& play, double time_s, double angle_rad, BoardTrouble& trouble) const {
  const RigFault& fault = play.fault;
  const double since_s = time_s - fault.start_s;
  switch (fault.kind) {
    case FaultKind::linkLoss:
      trouble.linkLost = true;
      break;
    case FaultKind::overCurrent:
      trouble.past_A += fault.current_A;
      break;
    case FaultKind::blocked:
      play.caught = play.caught || std::isnan(fault.angle_rad) || passes(before_rad_, angle_rad, fault.angle_rad);
      trouble.blocked = trouble.blocked || play.caught;
      break;
    case FaultKind::encoderJump:
      break;
    case FaultKind::indexLost:
      trouble.hidesIndex = true;
      break;
    case FaultKind::falseIndex:
      trouble.showsIndex = trouble.showsIndex || passes(before_rad_, angle_rad, fault.angle_rad);
      break;
    case FaultKind::supplyDrop:
      trouble.supplyPart *= fault.part;
      break;
    case FaultKind::temperatureDrift:
      trouble.past_A += fault.offset_A_per_s * since_s;
      trouble.resistancePart *= 1.0 + resistanceStep * std::floor(fault.resistance_per_s * since_s / resistanceStep);
      break;
  }
}

}  // namespace breakaway
