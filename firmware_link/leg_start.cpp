#include "firmware_link/leg_start.h"

#include <cmath>

#include "firmware_link/board_link.h"

namespace breakaway {

namespace {

float single(double value) {
  return static_cast<float>(value);
}

wire::StartHoming startOf(const wire::LegHead& head, const HomingPlan<double>& p, std::int32_t) {
  return {head,
          {single(p.searchSpeed_rad_per_s), single(p.approachSpeed_rad_per_s), single(p.backOff_rad),
           single(p.tolerance_rad), single(p.mostTurns), single(p.timeout_s), single(p.stall_s), p.approaches}};
}

wire::StartBreakaway startOf(const wire::LegHead& head, const BreakawayPlan<double>& p, std::int32_t targetCounts) {
  std::uint8_t ways = 0;
  if (p.growing) ways |= wire::StartBreakaway::growing;
  if (p.ramp.learning) ways |= wire::StartBreakaway::learning;
  return {head,
          {targetCounts, ways, single(p.near_rad), single(p.nearSpeed_rad_per_s), single(p.near_s), single(p.move_s),
           single(p.dwell_s), single(p.mostDwell_s), single(p.restSpeed_rad_per_s), single(p.hold_A),
           single(p.resistance_ohm), single(p.deadZone_V), single(p.ramp.start_A), single(p.ramp.rate_A_per_s),
           single(p.ramp.top_A), p.motionCounts, single(p.motionSpeed_rad_per_s)}};
}

wire::StartSpeed startOf(const wire::LegHead& head, const SpeedPlan<double>& p, std::int32_t) {
  return {head, {single(p.target_rad_per_s), single(p.wobble), single(p.settle_s), single(p.run_s), p.leastTurns}};
}

wire::Type typeOf(const wire::StartHoming&) {
  return wire::Type::startHoming;
}
wire::Type typeOf(const wire::StartBreakaway&) {
  return wire::Type::startBreakaway;
}
wire::Type typeOf(const wire::StartSpeed&) {
  return wire::Type::startSpeed;
}

}  // namespace

LegStart legStart(const Leg& leg, wire::LegHead head, double count_rad) {
  head.current_limit_A = single(leg.current_limit_A);
  const auto counts = static_cast<std::int64_t>(std::nearbyint(leg.target_rad / count_rad));
  const auto targetCounts = static_cast<std::int32_t>(static_cast<std::uint32_t>(counts));
  return std::visit(
      [&](const auto& plan) {
        const auto start = startOf(head, plan, targetCounts);
        return LegStart{typeOf(start), bodyOf(start)};
      },
      leg.plan);
}

}  // namespace breakaway
