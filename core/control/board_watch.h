// What a board looks for in every control tick, and for which it opens the windings by itself. Freestanding.
#pragma once

#include "control/magnitude.h"

namespace breakaway {

enum class Trip { none, overCurrent, openSensor, supplyLow, encoderJump, blocked };

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
  };
  struct Seen {
    Scalar angle_rad = 0;  ///< the encoder's count as an angle
    Scalar current_A = 0;  ///< measured, the sensor's zero taken off
    Scalar wanted_A = 0;   ///< current reference; 0 when the voltage is commanded
    Scalar limit_A = 0;    ///< that holds in this tick; 0: none
    Scalar supply_V = 0;
    bool enabled = false;
  };

  explicit BoardWatch(const Limits& limits)
      : limits_(limits),
        least_V_(limits.leastSupply * limits.supply_V),
        room_rad_(Scalar(4.5) * limits.count_rad + limits.mostAcceleration_rad_per_s2 * limits.tick_s * limits.tick_s),
        still_rad_(limits.blockedTravel_rad + limits.count_rad),
        lowFor_(ticksIn(limits.supplyLowFor_s)),
        blockedFor_(ticksIn(limits.blockedFor_s)) {}

  /// Forgets how long something has lasted; for a new command after a trip.
  void restart() { low_ = atLimit_ = 0; }

  /// The angle's zero was moved; see ServoController::shift().
  void shift(Scalar by_rad) {
    angle_rad_ += by_rad;
    anchor_rad_ += by_rad;
  }

  Trip step(const Seen& seen) {
    const Trip jump = angle(seen);
    if (exceeds(seen.current_A, limits_.trip_A)) return seen.enabled ? Trip::overCurrent : Trip::openSensor;
    low_ = seen.supply_V < least_V_ ? low_ + 1 : 0;
    if (low_ > lowFor_) return Trip::supplyLow;
    if (jump != Trip::none) return jump;
    return blocked(seen);
  }

  /// By how much the angle jumped at the last trip of that kind.
  Scalar jumped_rad() const { return jumped_rad_; }
  const Limits& limits() const { return limits_; }

 private:
  /// Whole ticks, what is lacking to one by rounding apart.
  long ticksIn(Scalar duration_s) const {
    return limits_.tick_s > Scalar(0) ? static_cast<long>(duration_s / limits_.tick_s * Scalar(1.000001)) : 0;
  }

  /// Whatever stops a shaft can do so within a tick, but nothing can make it that much faster.
  Trip angle(const Seen& seen) {
    const Scalar before = change_rad_;
    const Scalar change = ticks_ > 0 ? seen.angle_rad - angle_rad_ : Scalar(0);
    if (ticks_ == 0) anchor_rad_ = seen.angle_rad;
    angle_rad_ = seen.angle_rad;
    // The first change says how fast the shaft was when the board woke up; one that lasts after a jump is motion.
    const bool known = ticks_ > 1 && !jumped_;
    if (ticks_ < 2) ++ticks_;
    jumped_ =
        known && exceeds(change, room_rad_) &&
        (isNegative(change) != isNegative(before) || (exceeds(change, before) && exceeds(change - before, room_rad_)));
    if (!jumped_) {
      change_rad_ = change;
      return Trip::none;
    }
    jumped_rad_ = change - before;  // what comes next is compared with what was before the jump
    return Trip::encoderJump;
  }

  Trip blocked(const Seen& seen) {
    const Scalar almost_A = Scalar(0.9) * seen.limit_A;
    const bool atLimit = seen.enabled && seen.limit_A > Scalar(0) &&
                         (exceeds(seen.wanted_A, almost_A) || exceeds(seen.current_A, almost_A));
    const bool moved = exceeds(seen.angle_rad - anchor_rad_, still_rad_);
    if (moved) anchor_rad_ = seen.angle_rad;
    atLimit_ = atLimit && !moved ? atLimit_ + 1 : 0;
    return atLimit_ > blockedFor_ ? Trip::blocked : Trip::none;
  }

  Limits limits_;
  Scalar least_V_, room_rad_, still_rad_;  ///< supply that counts as dropped; change and travel that are none
  long lowFor_, blockedFor_, low_ = 0, atLimit_ = 0;  ///< ticks
  Scalar angle_rad_ = 0, change_rad_ = 0, jumped_rad_ = 0, anchor_rad_ = 0;
  int ticks_ = 0;  ///< seen, up to two
  bool jumped_ = false;
};

}  // namespace breakaway
