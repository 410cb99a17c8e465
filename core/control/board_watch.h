// What a board looks for in every control tick, and for which it opens the windings by itself. Freestanding.
#pragma once

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

  explicit BoardWatch(const Limits& limits) : limits_(limits) {}

  /// Forgets how long something has lasted; for a new command after a trip.
  void restart() { low_s_ = atLimit_s_ = 0; }

  /// The angle's zero was moved; see ServoController::shift().
  void shift(Scalar by_rad) {
    angle_rad_ += by_rad;
    anchor_rad_ += by_rad;
  }

  Trip step(const Seen& seen) {
    const Trip jump = angle(seen);
    if (magnitude(seen.current_A) > limits_.trip_A) return seen.enabled ? Trip::overCurrent : Trip::openSensor;
    low_s_ = seen.supply_V < limits_.leastSupply * limits_.supply_V ? low_s_ + limits_.tick_s : Scalar(0);
    if (low_s_ > limits_.supplyLowFor_s) return Trip::supplyLow;
    if (jump != Trip::none) return jump;
    return blocked(seen);
  }

  /// By how much the angle jumped at the last trip of that kind.
  Scalar jumped_rad() const { return jumped_rad_; }
  const Limits& limits() const { return limits_; }

 private:
  static Scalar magnitude(Scalar value) { return value < Scalar(0) ? -value : value; }

  /// Whatever stops a shaft can do so within a tick, but nothing can make it that much faster.
  Trip angle(const Seen& seen) {
    const Scalar before = change_rad_;
    const Scalar change = ticks_ > 0 ? seen.angle_rad - angle_rad_ : Scalar(0);
    if (ticks_ == 0) anchor_rad_ = seen.angle_rad;
    angle_rad_ = seen.angle_rad;
    const Scalar room =
        Scalar(4.5) * limits_.count_rad + limits_.mostAcceleration_rad_per_s2 * limits_.tick_s * limits_.tick_s;
    const Scalar least = (before < Scalar(0) ? before : Scalar(0)) - room;
    const Scalar most = (before > Scalar(0) ? before : Scalar(0)) + room;
    // The first change says how fast the shaft was when the board woke up; one that lasts after a jump is motion.
    const bool known = ticks_ > 1 && !jumped_;
    if (ticks_ < 2) ++ticks_;
    jumped_ = known && !(change >= least && change <= most);
    if (!jumped_) {
      change_rad_ = change;
      return Trip::none;
    }
    jumped_rad_ = change - before;  // what comes next is compared with what was before the jump
    return Trip::encoderJump;
  }

  Trip blocked(const Seen& seen) {
    const Scalar current = magnitude(seen.wanted_A) > magnitude(seen.current_A) ? seen.wanted_A : seen.current_A;
    const bool atLimit = seen.enabled && seen.limit_A > Scalar(0) && magnitude(current) > Scalar(0.9) * seen.limit_A;
    const bool moved = magnitude(seen.angle_rad - anchor_rad_) > limits_.blockedTravel_rad + limits_.count_rad;
    if (moved) anchor_rad_ = seen.angle_rad;
    atLimit_s_ = atLimit && !moved ? atLimit_s_ + limits_.tick_s : Scalar(0);
    return atLimit_s_ > limits_.blockedFor_s ? Trip::blocked : Trip::none;
  }

  Limits limits_;
  Scalar angle_rad_ = 0, change_rad_ = 0, jumped_rad_ = 0, anchor_rad_ = 0, low_s_ = 0, atLimit_s_ = 0;
  int ticks_ = 0;  ///< seen, up to two
  bool jumped_ = false;
};

}  // namespace breakaway
