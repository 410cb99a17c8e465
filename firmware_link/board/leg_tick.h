// The leg that the board runs by itself, and how telemetry tells of it. Freestanding.
#pragma once

#include <cstdint>

#include "control/leg/breakaway_leg.h"
#include "control/leg/homing_leg.h"
#include "control/leg/speed_leg.h"
#include "firmware_link/wire/leg_messages.h"
#include "firmware_link/wire/telemetry.h"

namespace breakaway::board {

template <typename Scalar>
class LegTick {
 public:
  void begin(const wire::StartHoming& start, const LegUnits<Scalar>& units) {
    const auto& p = start.plan;
    homing_.begin({p.searchSpeed_rad_per_s, p.approachSpeed_rad_per_s, p.backOff_rad, p.tolerance_rad, p.mostTurns,
                   p.timeout_s, p.stall_s, p.approaches},
                  units);
    begun(Kind::homing, start.head);
  }
  void begin(const wire::StartBreakaway& start, const LegUnits<Scalar>& units) {
    const auto& p = start.plan;
    breakaway_.begin({p.targetCounts,
                      p.near_rad,
                      p.nearSpeed_rad_per_s,
                      p.near_s,
                      p.move_s,
                      p.dwell_s,
                      p.mostDwell_s,
                      p.restSpeed_rad_per_s,
                      (p.ways & wire::StartBreakaway::growing) != 0,
                      p.hold_A,
                      p.resistance_ohm,
                      p.deadZone_V,
                      {p.rampStart_A, p.rampRate_A_per_s, p.rampTop_A, (p.ways & wire::StartBreakaway::learning) != 0},
                      p.motionCounts,
                      p.motionSpeed_rad_per_s},
                     units);
    begun(Kind::breakaway, start.head);
  }
  void begin(const wire::StartSpeed& start, const LegUnits<Scalar>& units) {
    const auto& p = start.plan;
    speed_.begin({p.target_rad_per_s, p.wobble, p.settle_s, p.run_s, p.leastTurns}, units);
    begun(Kind::speed, start.head);
  }

  /// Something else was commanded, or something stopped the motor.
  void forget() { *this = {}; }
  /// The leg with that number has begun already.
  bool has(std::uint8_t number) const { return kind_ != Kind::none && number_ == number; }
  bool runs() const { return kind_ != Kind::none && !legHasEnded(phase_); }

  /// One tick of a leg that runs.
  const LegAsk<Scalar>& step(const LegSeen<Scalar>& seen) {
    switch (kind_) {
      case Kind::homing:
        phase_ = homing_.step(seen);
        return homing_.ask();
      case Kind::speed:
        phase_ = speed_.step(seen);
        return speed_.ask();
      default:
        phase_ = breakaway_.step(seen);
        return breakaway_.ask();
    }
  }
  const LegAsk<Scalar>& ask() const {
    return kind_ == Kind::homing ? homing_.ask() : kind_ == Kind::speed ? speed_.ask() : breakaway_.ask();
  }

  /// For SampleFlag.
  std::uint8_t flags() const {
    if (kind_ == Kind::none) return 0;
    return static_cast<std::uint8_t>(phase_ << wire::SampleFlag::phaseShift |
                                     ((number_ & 1u) != 0 ? wire::SampleFlag::odd : 0));
  }

 private:
  enum class Kind : std::uint8_t { none, homing, breakaway, speed };
  void begun(Kind kind, const wire::LegHead& head) {
    kind_ = kind;
    number_ = head.number;
    phase_ = notBegun;
  }

  HomingLeg<Scalar> homing_;
  BreakawayLeg<Scalar> breakaway_;
  SpeedLeg<Scalar> speed_;
  Kind kind_ = Kind::none;
  std::uint8_t number_ = 0;
  LegPhase phase_ = notBegun;
};

}  // namespace breakaway::board
