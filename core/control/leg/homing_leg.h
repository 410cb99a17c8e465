// Homing's leg: finds the encoder's index, sees it again after a turn, and passes its edge slowly from one side.
// Freestanding.
#pragma once

#include "control/leg/leg.h"

namespace breakaway {

template <typename Scalar>
struct HomingPlan {
  Scalar searchSpeed_rad_per_s = 0, approachSpeed_rad_per_s = 0;  ///< positive
  Scalar backOff_rad = 0;
  Scalar tolerance_rad = 0;  ///< between two sights of one edge
  Scalar mostTurns = 0;      ///< of the search, and from one sight of the index to the next
  Scalar timeout_s = 0;
  Scalar stall_s = 0;  ///< without any motion
  std::uint8_t approaches = 0;
};

template <typename Scalar>
class HomingLeg {
 public:
  enum Phase : LegPhase {
    search = 1,
    verify,
    backOff,
    approach,
    done = legEnds,
    still,     ///< the rotor doesn't move
    timedOut,  ///< not done in time
    noIndex,   ///< none within the search's turns
    notAgain,  ///< none where it was looked for after the first
    twice,     ///< one elsewhere than a turn after the first, and another, or none, after that
    lost,      ///< none when passing slowly
    twoPlaces  ///< edges further apart than the tolerance
  };

  void begin(const HomingPlan<Scalar>& plan, const LegUnits<Scalar>& units) {
    *this = {};
    plan_ = plan;
    turn_ = units.countsPerTurn;
    backOff_ = units.counts(plan.backOff_rad);
    tolerance_ = units.counts(plan.tolerance_rad);
    still_ = units.counts(Scalar(0.02));
    most_ = units.turns(plan.mostTurns);
    timeout_us_ = microseconds(plan.timeout_s);
    stall_us_ = microseconds(plan.stall_s);
    coasting_ = Scalar(3) * plan.searchSpeed_rad_per_s;
    phase_ = search;
    turnAt(plan.searchSpeed_rad_per_s);
  }

  const LegAsk<Scalar>& ask() const { return ask_; }

  LegPhase step(const LegSeen<Scalar>& seen) {
    if (legHasEnded(phase_)) return phase_;
    if (!known_) {
      known_ = true;
      begun_us_ = seen.time_us;
      before_ = seen.count;
      enter(search, seen);
      return phase_;
    }
    const std::int32_t before = before_;
    before_ = seen.count;
    if (stands(seen)) {
      end(still);
    } else if (seen.time_us - begun_us_ > timeout_us_) {
      end(timedOut);
    } else {
      stage(seen, before);
    }
    return phase_;
  }

 private:
  void turnAt(Scalar velocity) { ask_ = {ServoMode::velocity, velocity, 0}; }
  void end(Phase how) {
    phase_ = how;
    ask_ = {};
  }
  void enter(Phase phase, const LegSeen<Scalar>& seen) {
    phase_ = phase;
    from_ = moved_ = seen.count;
    moved_us_ = seen.time_us;
    turnAt(phase == backOff    ? -plan_.searchSpeed_rad_per_s
           : phase == approach ? plan_.approachSpeed_rad_per_s
                               : plan_.searchSpeed_rad_per_s);
  }

  bool stands(const LegSeen<Scalar>& seen) {
    if (!isWithin(aheadOf(seen.count, moved_), still_)) {
      moved_ = seen.count;
      moved_us_ = seen.time_us;
    }
    return seen.time_us - moved_us_ > stall_us_;
  }

  void stage(const LegSeen<Scalar>& seen, std::int32_t before) {
    const std::int32_t since = aheadOf(seen.count, from_);
    switch (phase_) {
      case search:
        // Coasting from what ran before it, a rotor passes degrees within a tick; once it has slowed down, one that is
        // as fast slips from where it stuck, and may do so over the index in every turn.
        coasts_ = coasts_ && exceeds(seen.velocity_rad_per_s, coasting_);
        if (coasts_) {
          from_ = seen.count;
        } else if (seen.index && aheadOf(seen.count, before) >= 0) {
          enter(verify, seen);
        } else if (since > most_) {
          end(noIndex);
        }
        return;
      case verify:
        verifyAt(since, seen);
        return;
      case backOff:
        if (since < -backOff_) enter(approach, seen);
        return;
      default:
        pass(seen, before, since);
    }
  }

  /// A sound index comes once in a turn; anywhere else it is a disturbed wire, a lost count, or a turn that has other
  /// counts: then the next one comes as far again.
  void verifyAt(std::int32_t since, const LegSeen<Scalar>& seen) {
    if (since > most_ + odd_) return end(odd_ > 0 ? twice : notAgain);
    if (!seen.index || since <= odd_) return;
    if (odd_ > 0) return end(twice);
    if (!isWithin(since - turn_, tolerance_)) {
      odd_ = since;
    } else {
      enter(backOff, seen);
    }
  }

  void pass(const LegSeen<Scalar>& seen, std::int32_t before, std::int32_t since) {
    if (since > 4 * backOff_) return end(lost);
    const std::int32_t tick = aheadOf(seen.count, before);
    if (!seen.index || tick < 0 || since <= backOff_ / 5) return;
    const std::int32_t edge = seen.count - tick / 2;
    if (passes_ == 0) edge_ = edge;
    if (!isWithin(aheadOf(edge, edge_), tolerance_)) return end(twoPlaces);
    ++passes_;
    enter(backOff, seen);
    if (passes_ >= plan_.approaches) end(done);
  }

  HomingPlan<Scalar> plan_;
  LegAsk<Scalar> ask_;
  Scalar coasting_ = 0;
  LegPhase phase_ = notBegun;
  std::int32_t turn_ = 0, backOff_ = 0, tolerance_ = 0, still_ = 0, most_ = 0;
  std::uint32_t timeout_us_ = 0, stall_us_ = 0, begun_us_ = 0, moved_us_ = 0;
  std::int32_t from_ = 0, moved_ = 0, before_ = 0, edge_ = 0;
  std::int32_t odd_ = 0;  ///< from the first sight of the index to one that came elsewhere than a turn later
  std::uint8_t passes_ = 0;
  bool known_ = false, coasts_ = true;
};

}  // namespace breakaway
