// What a board looks for in every control tick, and for which it opens the windings by itself. Freestanding.
#pragma once

#include "control/magnitude.h"

namespace breakaway {

/// As the wire numbers them; see FaultCode.
enum class Trip {
  none = 0,
  overCurrent = 1,
  openSensor = 2,
  supplyLow = 3,
  encoderJump = 4,
  blocked = 5,
  overSpeed = 6,  ///< faster than the motor may turn, or than it was asked to
  supplyHigh = 10,
  contradiction = 11,  ///< voltage, current and motion don't belong to one motor
  windingHeat = 12     ///< more current for longer than the winding bears
};

/// Templated on the scalar, no heap, no library calls.
template <typename Scalar>
class BoardWatch {
 public:
  struct Limits {
    Scalar tick_s = 0;
    Scalar count_rad = 0;
    Scalar trip_A = 0;  ///< of the measured current; with the windings open it means a broken sensor
    Scalar supply_V = 0;
    Scalar leastSupply = Scalar(0.8);         ///< part of the supply below which it counts as dropped
    Scalar supplyLowFor_s = Scalar(0.005);    ///< shorter drops are a sag
    Scalar mostAcceleration_rad_per_s2 = 0;   ///< a change of the angle that needs more is no motion
    Scalar blockedFor_s = Scalar(1);          ///< at the current limit without motion
    Scalar blockedTravel_rad = Scalar(0.01);  ///< less travel than this is no motion
    Scalar mostSupply = Scalar(1.25);         ///< part of the supply above which something feeds it
    Scalar resistance_ohm = 0;                ///< of the motor; 0: nothing is foretold
    Scalar backEmf_V_s_per_rad = 0;
    Scalar inductance_H = 0;
    Scalar mostVelocity_rad_per_s = 0;  ///< that the motor may turn at, whatever it is asked; 0: no limit
    Scalar continuous_A = 0;            ///< that the winding bears for ever; 0: no limit
  };
  struct Seen {
    Scalar angle_rad = 0;  ///< the encoder's count as an angle
    Scalar current_A = 0;  ///< measured, the sensor's zero taken off
    Scalar wanted_A = 0;   ///< current reference; 0 when the voltage is commanded
    Scalar limit_A = 0;    ///< that holds in this tick; 0: none
    Scalar supply_V = 0;
    bool enabled = false;
    Scalar voltage_V = 0;  ///< that the winding gets
    Scalar velocity_rad_per_s = 0;
    bool follows = false;        ///< a speed was asked for
    Scalar asked_rad_per_s = 0;  ///< that speed
  };
  /// What the winding got, what flowed and how fast the encoder turned, over the last 20 ms.
  struct Motor {
    Scalar voltage_V = 0, current_A = 0, velocity_rad_per_s = 0;
  };

  explicit BoardWatch(const Limits& limits)
      : limits_(limits),
        least_V_(limits.leastSupply * limits.supply_V),
        most_V_(limits.mostSupply * limits.supply_V),
        lost_V_(lostPart * limits.supply_V + limits.backEmf_V_s_per_rad * limits.count_rad / motorTime_s),
        share_(Scalar(steps) * limits.tick_s / motorTime_s),
        perRound_(limits.tick_s > Scalar(0) ? Scalar(1) / (Scalar(steps) * limits.tick_s) : Scalar(0)),
        inductance_(limits.inductance_H * perRound_),
        heatShare_(Scalar(steps) * limits.tick_s / heatTime_s),
        cooling_(limits.tick_s / heatTime_s),
        mostHeat_(limits.continuous_A * limits.continuous_A),
        mostVelocity_rad_per_s_(limits.mostVelocity_rad_per_s),
        mostSlip_rad_per_s_(slipPart * limits.mostVelocity_rad_per_s),
        aside_rad_per_s_(Scalar(0.05) * limits.mostVelocity_rad_per_s + Scalar(2) * limits.count_rad / motorTime_s),
        room_rad_(Scalar(4.5) * limits.count_rad + limits.mostAcceleration_rad_per_s2 * limits.tick_s * limits.tick_s),
        still_rad_(limits.blockedTravel_rad + limits.count_rad),
        lowFor_(ticksIn(limits.supplyLowFor_s)),
        blockedFor_(ticksIn(limits.blockedFor_s)) {}

  /// Forgets how long something has lasted; for a new command after a trip.
  void restart() { low_ = high_ = atLimit_ = 0; }

  /// Draws the speed's limit tighter than the board's own, or wider; 0: none.
  void limitVelocity(Scalar most_rad_per_s) { mostVelocity_rad_per_s_ = most_rad_per_s; }

  /// The angle's zero was moved; see ServoController::shift().
  void shift(Scalar by_rad) {
    angle_rad_ += by_rad;
    anchor_rad_ += by_rad;
    roundStart_rad_ += by_rad;
  }

  Trip step(const Seen& seen) {
    const Trip jump = angle(seen);
    if (exceeds(seen.current_A, limits_.trip_A)) return seen.enabled ? Trip::overCurrent : Trip::openSensor;
    low_ = isAbove(least_V_, seen.supply_V) ? low_ + 1 : 0;
    if (low_ > lowFor_) return Trip::supplyLow;
    high_ = isAbove(seen.supply_V, most_V_) ? high_ + 1 : 0;
    if (high_ > lowFor_) return Trip::supplyHigh;
    if (const Trip motion = motor(seen); motion != Trip::none) return motion;
    if (jump != Trip::none) return jump;
    return blocked(seen);
  }

  /// By how much the angle jumped at the last trip of that kind.
  Scalar jumped_rad() const { return jumped_rad_; }
  const Motor& motor() const { return motor_; }
  /// What the current's change took of motor()'s voltage.
  Scalar inductive_V() const { return inductive_V_; }
  const Limits& limits() const { return limits_; }

 private:
  // What a sound bench may differ by from V = R·i + Ke·ω: the bridge's losses as a part of the supply, a hot winding's
  // resistance and what falls with the current, a magnet's strength.
  static constexpr Scalar lostPart = Scalar(0.06), hotPart = Scalar(0.4), magnetPart = Scalar(0.15);
  static constexpr Scalar motorTime_s = Scalar(0.02);  ///< over which voltage, current and speed are smoothed
  static constexpr Scalar heatTime_s = Scalar(20);     ///< of the winding
  static constexpr Scalar overshoot = Scalar(0.5);     ///< of the speed that was asked for
  static constexpr Scalar slowing = Scalar(0.25);      ///< of the smoothing's rate, at which a lower speed is held to
  static constexpr Scalar slipPart = Scalar(0.12);     ///< of the speed's limit, for what has just broken loose
  static constexpr int steps = 8;                      ///< ticks of a round, a few operations in each
  static constexpr Scalar perSampled = Scalar(0.25);   ///< voltage and current are seen in four of them
  // Which ones: two even and two odd, each of the four remainders by four once, so that no ripple of two or four ticks
  // stands in the mean.
  static constexpr unsigned seenTicks = 0b1101'0010u;

  /// Whole ticks, what is lacking to one by rounding apart.
  long ticksIn(Scalar duration_s) const {
    return limits_.tick_s > Scalar(0) ? static_cast<long>(duration_s / limits_.tick_s * Scalar(1.000001)) : 0;
  }

  /// Whatever stops a shaft can do so within a tick, and what it meets may throw it back no faster than it came, which
  /// takes two ticks to show; but nothing can make it that much faster, nor turn it about and on again in two ticks:
  /// there the encoder jumped and the shaft went on.
  Trip angle(const Seen& seen) {
    const Scalar before = change_rad_, came = exceeds(before, earlier_rad_) ? before : earlier_rad_;
    const Scalar change = ticks_ > 0 ? seen.angle_rad - angle_rad_ : Scalar(0);
    if (ticks_ == 0) anchor_rad_ = seen.angle_rad;
    angle_rad_ = seen.angle_rad;
    // The first change says how fast the shaft was when the board woke up; one that lasts after a jump is motion.
    const bool far = ticks_ > 1 && !jumped_ && exceeds(change, room_rad_);
    if (ticks_ < 2) ++ticks_;
    const bool back = far && isNegative(change) != isNegative(came);
    const bool wentOn = far && !back && thrownBack_ && isNegative(change) != isNegative(before);
    jumped_ = back ? exceeds(change, came) && exceeds(change + came, limits_.count_rad)
                   : wentOn || (far && exceeds(change, before) && exceeds(change - before, room_rad_));
    thrownBack_ = back && !jumped_;
    if (!wentOn && (back || jumped_)) jumped_rad_ = change - before;
    if (!jumped_) {
      earlier_rad_ = before;
      change_rad_ = change;
      return Trip::none;
    }
    return Trip::encoderJump;  // what comes next is compared with what was before the jump
  }

  /// What voltage, current and encoder say together. Smoothed values of one time are compared, so that neither a ripple
  /// nor a step of the current counts. A round's sums are worked on in the next one, a part in each tick.
  Trip motor(const Seen& seen) {
    if (!seen.enabled) {
      motor_ = {};
      last_ = sum_ = {};
      step_ = 0;
      inductive_V_ = 0;
      acting_V_ = 0;
      roundStart_rad_ = seen.angle_rad;
      roundStart_A_ = seen.current_A;
      coasting_rad_per_s_ = seen.velocity_rad_per_s;
      allowed_rad_per_s_ = magnitude(coasting_rad_per_s_) + aside_rad_per_s_;
      heat_ -= cooling_ * heat_;
      return Trip::none;
    }
    if (step_ == steps) {
      step_ = 0;
      last_ = {sum_.voltage_V, sum_.current_A, seen.current_A - roundStart_A_, seen.angle_rad - roundStart_rad_};
      sum_ = {};
      roundStart_rad_ = seen.angle_rad;
      roundStart_A_ = seen.current_A;
    }
    if ((seenTicks >> step_ & 1u) != 0) {
      sum_.voltage_V += acting_V_;
      sum_.current_A += seen.current_A;
    }
    acting_V_ = seen.voltage_V;  // from now to the next tick
    return part(step_++, seen);
  }

  Trip part(int which, const Seen& seen) {
    switch (which) {
      case 0:
        smooth(motor_.voltage_V, perSampled * last_.voltage_V);
        break;
      case 1:
        smooth(motor_.current_A, perSampled * last_.current_A);
        break;
      case 2:
        smooth(motor_.velocity_rad_per_s, perRound_ * last_.turned_rad);
        smooth(coasting_rad_per_s_, Scalar(0));
        break;
      case 3:
        smooth(inductive_V_, inductance_ * last_.rise_A);
        resistive_V_ = limits_.resistance_ohm * motor_.current_A;
        induced_V_ = limits_.backEmf_V_s_per_rad * motor_.velocity_rad_per_s;
        break;
      case 4:
        usual_V_ = lost_V_ + hotPart * magnitude(resistive_V_) + magnetPart * magnitude(induced_V_);
        break;
      case 5:
        if (isPositive(limits_.resistance_ohm) &&
            exceeds(motor_.voltage_V - resistive_V_ - induced_V_ - inductive_V_, usual_V_))
          return Trip::contradiction;
        break;
      case 6:
        heat_ += heatShare_ * (motor_.current_A * motor_.current_A - heat_);
        if (isPositive(mostHeat_) && isAbove(heat_, mostHeat_)) return Trip::windingHeat;
        break;
      default:
        if (tooFast(seen)) return Trip::overSpeed;
    }
    return Trip::none;
  }

  /// Beyond the motor's limit; or faster than was asked for, but what slows down after a change of the reference is
  /// given the time for it, and so is what sticks and slips: a light rotor leaps where static friction lets go.
  bool tooFast(const Seen& seen) {
    const Scalar size = magnitude(motor_.velocity_rad_per_s + coasting_rad_per_s_);
    if (isPositive(mostVelocity_rad_per_s_) && exceeds(size, mostVelocity_rad_per_s_)) return true;
    const Scalar present = size + aside_rad_per_s_;
    if (!seen.follows) {
      allowed_rad_per_s_ = present;
      slip_rad_per_s_ = 0;
      return false;
    }
    allowed_rad_per_s_ += slowing * share_ * (present - allowed_rad_per_s_);
    const Scalar target = magnitude(seen.asked_rad_per_s);
    const bool along = isNegative(motor_.velocity_rad_per_s) == isNegative(seen.asked_rad_per_s);
    if (!along || !isPositive(target)) {
      slip_rad_per_s_ = 0;
    } else if (isAbove(size, target)) {
      slip_rad_per_s_ -= slowing * share_ * slip_rad_per_s_;
    } else {
      slip_rad_per_s_ = mostSlip_rad_per_s_;
    }
    const Scalar more = isAbove(slip_rad_per_s_, overshoot * target) ? slip_rad_per_s_ : overshoot * target;
    const Scalar asked = target + more + aside_rad_per_s_;
    if (exceeds(asked, allowed_rad_per_s_)) allowed_rad_per_s_ = asked;
    return isPositive(aside_rad_per_s_) && exceeds(size, allowed_rad_per_s_);
  }

  /// Takes a round's mean into its smoothed value.
  void smooth(Scalar& value, Scalar mean) const { value += share_ * (mean - value); }

  Trip blocked(const Seen& seen) {
    const Scalar almost_A = Scalar(0.9) * seen.limit_A;
    const bool atLimit = seen.enabled && isPositive(seen.limit_A) &&
                         (exceeds(seen.wanted_A, almost_A) || exceeds(seen.current_A, almost_A));
    const bool moved = exceeds(seen.angle_rad - anchor_rad_, still_rad_);
    if (moved) anchor_rad_ = seen.angle_rad;
    atLimit_ = atLimit && !moved ? atLimit_ + 1 : 0;
    return atLimit_ > blockedFor_ ? Trip::blocked : Trip::none;
  }

  Limits limits_;
  Scalar least_V_, most_V_;                                      ///< supply that counts as dropped, as fed
  Scalar lost_V_, share_;                                        ///< of the motor's voltage; of a new value in its mean
  Scalar perRound_;                                              ///< one over a round's time
  Scalar inductance_;                                            ///< per time of a round, V per A of change
  Scalar heatShare_, cooling_, mostHeat_;                        ///< of a round, of a tick; A²
  Scalar mostVelocity_rad_per_s_;                                ///< whatever is asked
  Scalar mostSlip_rad_per_s_, aside_rad_per_s_;                  ///< beyond what is asked, when it breaks loose; always
  Scalar room_rad_, still_rad_;                                  ///< change and travel that are none
  long lowFor_, blockedFor_, low_ = 0, high_ = 0, atLimit_ = 0;  ///< ticks
  Motor motor_;                                                  ///< smoothed
  struct Round {
    Scalar voltage_V = 0, current_A = 0;  ///< sums over the ticks that are seen
    Scalar rise_A = 0, turned_rad = 0;    ///< from its first tick to the next one's
  };
  Round last_, sum_;
  Scalar resistive_V_ = 0, induced_V_ = 0, inductive_V_ = 0, usual_V_ = 0;
  Scalar heat_ = 0, allowed_rad_per_s_ = 0, slip_rad_per_s_ = 0;
  // What voltage, current and speed are smoothed from is nothing; so much of the speed at which the windings were
  // energised is not yet in the smoothed one.
  Scalar coasting_rad_per_s_ = 0;
  Scalar roundStart_rad_ = 0, roundStart_A_ = 0;
  Scalar acting_V_ = 0;  ///< since the last tick
  int step_ = 0;         ///< of the round
  Scalar angle_rad_ = 0, jumped_rad_ = 0, anchor_rad_ = 0;
  Scalar change_rad_ = 0, earlier_rad_ = 0;   ///< over the last tick, and over the one before it
  int ticks_ = 0;                             ///< seen, up to two
  bool jumped_ = false, thrownBack_ = false;  ///< in the last tick
};

}  // namespace breakaway
