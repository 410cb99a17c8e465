// The breakaway sweep's leg: to an angle, stand there, and a slow ramp of voltage until the rotor moves. Freestanding.
#pragma once

#include "control/leg/leg.h"

namespace breakaway {

/// A ramp of current, positive in the way's direction.
template <typename Scalar>
struct RampShape {
  Scalar start_A = 0, rate_A_per_s = 0;
  Scalar top_A = 0;       ///< given up beyond it
  bool learning = false;  ///< nothing is expected: it grows exponentially until something moves
  static constexpr Scalar learningDoubling_s = Scalar(0.7);
  static constexpr Scalar learningFirst_A = Scalar(1e-3);
};

/// 2^x for x ≥ 0 to 4.4e-6 of it, at most 2^30: a polynomial through 2^f at Chebyshev's places from 0 to 1.
template <typename Scalar>
constexpr Scalar powerOfTwo(Scalar x) {
  if (!(x < Scalar(30))) return Scalar(1 << 30);
  const auto whole = static_cast<std::uint32_t>(x);
  const Scalar f = x - static_cast<Scalar>(whole);
  const Scalar cubic = Scalar(0.24152036) + f * (Scalar(0.05179315) + f * Scalar(0.013677529));
  return (Scalar(1) + f * (Scalar(0.69300897) + f * cubic)) * static_cast<Scalar>(std::uint32_t(1) << whole);
}

/// The ramp's current `inRamp_s` after its beginning.
template <typename Scalar>
constexpr Scalar rampCurrent(const RampShape<Scalar>& ramp, Scalar inRamp_s) {
  if (!ramp.learning) return ramp.start_A + ramp.rate_A_per_s * inRamp_s;
  return ramp.start_A +
         ramp.learningFirst_A * (powerOfTwo(inRamp_s * (Scalar(1) / ramp.learningDoubling_s)) - Scalar(1));
}

template <typename Scalar>
struct BreakawayPlan {
  std::int32_t targetCounts = 0;  ///< where to stand
  Scalar near_rad = 0;            ///< of it
  Scalar nearSpeed_rad_per_s = 0;
  Scalar near_s = 0;                    ///< for so long
  Scalar move_s = 0;                    ///< at most, to get there
  Scalar dwell_s = 0, mostDwell_s = 0;  ///< at rest before the ramp, and given up after
  Scalar restSpeed_rad_per_s = 0;
  bool growing = true;        ///< the way's direction
  Scalar hold_A = 0;          ///< meanwhile, positive in the way's direction
  Scalar resistance_ohm = 0;  ///< currents are asked for as voltages along the winding's line
  Scalar deadZone_V = 0;
  RampShape<Scalar> ramp;
  std::uint16_t motionCounts = 0;  ///< that count as motion, together with the speed
  Scalar motionSpeed_rad_per_s = 0;
};

template <typename Scalar>
class BreakawayLeg {
 public:
  enum Phase : LegPhase {
    move = 1,
    stand,
    ramp,
    broke = legEnds,  ///< sustained motion
    restless,         ///< it doesn't come to rest
    held,             ///< nothing moved up to the ramp's top
    saturated         ///< nor at what the supply gives
  };

  void begin(const BreakawayPlan<Scalar>& plan, const LegUnits<Scalar>& units) {
    *this = {};
    plan_ = plan;
    near_ = units.counts(plan.near_rad);
    near_us_ = microseconds(plan.near_s);
    move_us_ = microseconds(plan.move_s);
    dwell_us_ = microseconds(plan.dwell_s);
    mostDwell_us_ = microseconds(plan.mostDwell_s);
    phase_ = move;
    ask_ = {ServoMode::position, 0, plan.targetCounts};
  }

  const LegAsk<Scalar>& ask() const { return ask_; }

  LegPhase step(const LegSeen<Scalar>& seen) {
    if (legHasEnded(phase_)) return phase_;
    if (!known_) {
      known_ = true;
      enter(move, seen);
    }
    const std::uint32_t inStage_us = seen.time_us - stage_us_;
    switch (phase_) {
      case move: {
        const bool near = isWithin(aheadOf(seen.count, plan_.targetCounts), near_) &&
                          !exceeds(seen.velocity_rad_per_s, plan_.nearSpeed_rad_per_s);
        if (!near) beside_us_ = seen.time_us;
        if (seen.time_us - beside_us_ > near_us_ || inStage_us > move_us_) {
          enter(stand, seen);
          push(plan_.hold_A);
        }
        break;
      }
      case stand:
        if (inStage_us > dwell_us_ && !exceeds(seen.velocity_rad_per_s, plan_.restSpeed_rad_per_s)) {
          enter(ramp, seen);
          standing_ = seen.count;
        } else if (inStage_us > mostDwell_us_) {
          end(restless);
        }
        break;
      default:
        climb(seen, inStage_us);
    }
    return phase_;
  }

 private:
  void enter(Phase phase, const LegSeen<Scalar>& seen) {
    phase_ = phase;
    stage_us_ = beside_us_ = seen.time_us;
  }
  void end(Phase how) {
    phase_ = how;
    ask_ = {};
  }

  /// Asks for a current along the winding's line. Returns the size of the voltage.
  Scalar push(Scalar inWay_A) {
    const Scalar volts = inWay_A * plan_.resistance_ohm;
    const Scalar whole = inWay_A == Scalar(0) ? volts
                         : isNegative(volts)  ? volts - plan_.deadZone_V
                                              : volts + plan_.deadZone_V;
    ask_ = {ServoMode::voltage, plan_.growing ? whole : -whole, 0};
    return magnitude(whole);
  }

  void climb(const LegSeen<Scalar>& seen, std::uint32_t inStage_us) {
    const std::int32_t inWay = plan_.growing ? aheadOf(seen.count, standing_) : aheadOf(standing_, seen.count);
    const bool along = isNegative(seen.velocity_rad_per_s) != plan_.growing;
    if (inWay >= plan_.motionCounts && along && exceeds(seen.velocity_rad_per_s, plan_.motionSpeed_rad_per_s))
      return end(broke);
    const Scalar next = rampCurrent(plan_.ramp, static_cast<Scalar>(inStage_us) * Scalar(1e-6));
    if (next > plan_.ramp.top_A) return end(held);
    if (push(next) > seen.supply_V) end(saturated);
  }

  BreakawayPlan<Scalar> plan_;
  LegAsk<Scalar> ask_;
  LegPhase phase_ = notBegun;
  std::int32_t near_ = 0, standing_ = 0;
  std::uint32_t near_us_ = 0, move_us_ = 0, dwell_us_ = 0, mostDwell_us_ = 0, stage_us_ = 0, beside_us_ = 0;
  bool known_ = false;
};

}  // namespace breakaway
