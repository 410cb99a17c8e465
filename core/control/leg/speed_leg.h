// The velocity sweep's leg: one speed, settled to and then held over whole turns. Freestanding.
#pragma once

#include "control/leg/leg.h"

namespace breakaway {

template <typename Scalar>
struct SpeedPlan {
  Scalar target_rad_per_s = 0;
  Scalar wobble = 0;    ///< part of the target, a slow triangle once in run_s while it is held
  Scalar settle_s = 0;  ///< at least, before it counts
  Scalar run_s = 0;     ///< at least, then on to the end of the turn
  std::uint16_t leastTurns = 0;
};

/// The triangle: 0, 1, 0, −1, 0 over phases 0 … 1.
template <typename Scalar>
constexpr Scalar triangle(Scalar part) {
  return part < Scalar(0.25)   ? Scalar(4) * part
         : part < Scalar(0.75) ? Scalar(2) - Scalar(4) * part
                               : Scalar(4) * part - Scalar(4);
}

template <typename Scalar>
class SpeedLeg {
 public:
  enum Phase : LegPhase {
    settle = 1,
    hold,
    done = legEnds,
    notReached,
    lost  ///< it was, and then not held
  };

  void begin(const SpeedPlan<Scalar>& plan, const LegUnits<Scalar>& units) {
    *this = {};
    plan_ = plan;
    turn_ = static_cast<std::uint32_t>(units.countsPerTurn);
    const Scalar size = magnitude(plan.target_rad_per_s);
    near_ = nearPart * size + nearSpeed;
    rippling_ = ripplingPart * size;
    nearer_ = nearerPart * size;
    away_ = lostPart * size;
    settle_us_ = microseconds(plan.settle_s);
    run_us_ = microseconds(plan.run_s);
    perRun_ = run_us_ > 0 ? Scalar(1) / static_cast<Scalar>(run_us_) : Scalar(0);
    phase_ = settle;
    ask_ = {ServoMode::velocity, plan.target_rad_per_s, 0};
  }

  const LegAsk<Scalar>& ask() const { return ask_; }

  LegPhase step(const LegSeen<Scalar>& seen) {
    if (legHasEnded(phase_)) return phase_;
    if (!known_) begun(seen);
    // What floats is looked at in every fourth tick only.
    const bool looks = (++ticks_ & 3u) == 0;
    if (looks) smooth(seen);
    if (phase_ == settle) {
      if (looks) settling(seen);
    } else {
      holding(seen, looks);
    }
    return phase_;
  }

 private:
  static constexpr Scalar nearPart = Scalar(0.015), nearSpeed = Scalar(0.3);
  static constexpr Scalar ripplingPart = Scalar(0.15), nearerPart = Scalar(0.02), lostPart = Scalar(0.3);
  static constexpr Scalar smoothing_us = Scalar(0.15e6);
  static constexpr std::uint32_t near_us = 400'000;     ///< for so long before it counts
  static constexpr std::uint32_t stuck_us = 3'000'000;  ///< without coming nearer to the speed
  static constexpr std::uint32_t lost_us = 1'000'000;   ///< away from the speed while it is held

  void begun(const LegSeen<Scalar>& seen) {
    known_ = true;
    begun_us_ = reached_us_ = nearer_us_ = smoothed_us_ = seen.time_us;
    mean_ = seen.velocity_rad_per_s;
    nearest_ = Scalar(1e30);
  }
  void end(Phase how) {
    phase_ = how;
    ask_ = {};
  }

  /// Cogging's ripple is no part of how near the speed is.
  void smooth(const LegSeen<Scalar>& seen) {
    const std::uint32_t passed_us = seen.time_us - smoothed_us_;
    smoothed_us_ = seen.time_us;
    if (passed_us != step_us_) {
      step_us_ = passed_us;
      weight_ = static_cast<Scalar>(passed_us) / smoothing_us;
      if (weight_ > Scalar(1)) weight_ = Scalar(1);
    }
    mean_ += (seen.velocity_rad_per_s - mean_) * weight_;
    off_ = magnitude(mean_ - plan_.target_rad_per_s);
  }

  void settling(const LegSeen<Scalar>& seen) {
    if (off_ < nearest_ - nearer_) {
      nearest_ = off_;
      nearer_us_ = seen.time_us;
    }
    // A rotor that still comes up to speed would take its inertia's torque for friction.
    const bool near = !exceeds(off_, near_);
    if (!near) reached_us_ = seen.time_us;
    const bool settled = seen.time_us - begun_us_ > settle_us_ && seen.time_us - reached_us_ > near_us;
    // It ripples around its speed and comes no nearer: as steady as it gets.
    const bool stuck = !near && seen.time_us - nearer_us_ > stuck_us;
    if (settled || (stuck && !exceeds(off_, rippling_))) {
      phase_ = hold;
      begun_us_ = reached_us_ = seen.time_us;
      from_ = seen.count;
      next_ = turn_;
    } else if (stuck) {
      end(notReached);
    }
  }

  void holding(const LegSeen<Scalar>& seen, bool looks) {
    const std::uint32_t passed_us = seen.time_us - begun_us_;
    if (looks) {
      // A rotor that is held or dragged down would be measured for ever.
      if (!exceeds(off_, away_)) reached_us_ = seen.time_us;
      if (seen.time_us - reached_us_ >= lost_us) return end(lost);
      if (passed_us - cycle_us_ >= run_us_) cycle_us_ += run_us_;
      const Scalar wobble = triangle(static_cast<Scalar>(passed_us - cycle_us_) * perRun_) * plan_.wobble;
      ask_.target = plan_.target_rad_per_s + plan_.target_rad_per_s * wobble;
    }
    const std::int32_t way = aheadOf(seen.count, from_);
    if ((way < 0 ? 0u - static_cast<std::uint32_t>(way) : static_cast<std::uint32_t>(way)) < next_) return;
    next_ += turn_;
    ++turns_;
    if (passed_us >= run_us_ && turns_ >= plan_.leastTurns) end(done);
  }

  SpeedPlan<Scalar> plan_;
  LegAsk<Scalar> ask_;
  Scalar near_ = 0, rippling_ = 0, nearer_ = 0, away_ = 0, perRun_ = 0;  ///< rad/s; 1/µs
  Scalar mean_ = 0, off_ = 0, nearest_ = 0, weight_ = 0;
  LegPhase phase_ = notBegun;
  std::int32_t from_ = 0;
  std::uint32_t turn_ = 0, next_ = 0;
  std::uint32_t settle_us_ = 0, run_us_ = 0, begun_us_ = 0, reached_us_ = 0, nearer_us_ = 0, smoothed_us_ = 0;
  std::uint32_t step_us_ = 0, cycle_us_ = 0, ticks_ = 0, turns_ = 0;
  bool known_ = false;
};

}  // namespace breakaway
