#include "experiment/leg.h"

#include <cmath>

#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr double countsOfUnknown = 1 << 20;  // fine enough for any encoder

std::int32_t wrapped(double whole) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(whole)));
}

}  // namespace

LegRunner::LegRunner(double countsPerRev) : countsPerTurn_(countsPerRev > 0.0 ? countsPerRev : countsOfUnknown) {
}

std::int32_t LegRunner::countOf(double angle_rad) const {
  return wrapped(std::nearbyint(angle_rad / turn_rad * countsPerTurn_));
}

void LegRunner::begin(const Leg& leg) {
  current_limit_A_ = leg.current_limit_A;
  const LegUnits<double> units{static_cast<std::int32_t>(countsPerTurn_)};
  if (const auto* homing = std::get_if<HomingPlan<double>>(&leg.plan)) {
    leg_.emplace<HomingLeg<double>>().begin(*homing, units);
  } else if (const auto* speed = std::get_if<SpeedPlan<double>>(&leg.plan)) {
    leg_.emplace<SpeedLeg<double>>().begin(*speed, units);
  } else {
    auto plan = std::get<BreakawayPlan<double>>(leg.plan);
    plan.targetCounts = countOf(leg.target_rad);
    leg_.emplace<BreakawayLeg<double>>().begin(plan, units);
  }
}

LegPhase LegRunner::step(const Sample& sample) {
  LegSeen<double> seen;
  seen.time_us = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::llround(sample.time_s * 1e6)));
  seen.count = countOf(sample.angle_rad);
  seen.index = sample.index;
  seen.velocity_rad_per_s = sample.velocity_rad_per_s;
  seen.supply_V = sample.supply_V;
  return std::visit([&seen](auto& leg) { return leg.step(seen); }, leg_);
}

Command LegRunner::command() const {
  const LegAsk<double>& ask = std::visit([](const auto& leg) -> const LegAsk<double>& { return leg.ask(); }, leg_);
  if (ask.mode == ServoMode::off) return {};
  const double target = ask.mode == ServoMode::position ? ask.targetCounts * turn_rad / countsPerTurn_ : ask.target;
  return {static_cast<Command::Mode>(ask.mode), target, current_limit_A_, false};
}

}  // namespace breakaway
