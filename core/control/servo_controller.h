// The whole control tick of a servo board: current zeroing, observers, position, velocity and current loop.
// Freestanding.
#pragma once

#include "control/current_controller.h"
#include "control/duty_table.h"
#include "control/friction_compensator.h"
#include "control/friction_table.h"
#include "control/motion_controller.h"
#include "control/turn.h"
#include "observer/disturbance_observer.h"
#include "observer/velocity_observer.h"

namespace breakaway {

enum class ServoMode { off, voltage, current, velocity, position };

template <typename Scalar>
struct ServoSettings {
  MotionGains<Scalar> gains;
  Scalar observer_cutoff_rad_per_s = 0;  ///< 0: no disturbance feedback; the estimate runs at its last cutoff
  Scalar inertia_kg_m2 = 0;              ///< nominal
  Scalar torqueConstant_Nm_per_A = 0;    ///< nominal
  Scalar current_limit_A = 0;
  bool operator==(const ServoSettings&) const = default;
};

template <typename Scalar>
struct ServoCommand {
  ServoMode mode = ServoMode::off;
  Scalar target = 0;
  Scalar current_limit_A = 0;  ///< 0: the settings' own
  bool zeroCurrentSensor = false;
};

/// One tick's result; all that telemetry shows besides the raw measurements.
template <typename Scalar>
struct ServoOutput {
  bool enabled = false;
  Scalar duty = 0;       ///< to ask the bridge for, within ±1
  Scalar voltage_V = 0;  ///< the same, times the supply
  Scalar current_A = 0;  ///< with the sensor's zero taken off
  Scalar velocity_rad_per_s = 0;
  Scalar current_reference_A = 0;
  Scalar velocity_reference_rad_per_s = 0;
  Scalar angleAhead_rad = 0;  ///< the angle's reference less the angle; 0 where no angle is asked for
  Scalar disturbance_estimate_Nm = 0;
};

/// Templated on the scalar, no heap, no library calls.
template <typename Scalar>
class ServoController {
 public:
  struct Board {
    Scalar tick_s = 0;
    Scalar count_rad = 0;
    typename CurrentController<Scalar>::Settings current;
    Scalar velocityBandwidth_rad_per_s = 0;
  };

  explicit ServoController(const Board& board) : board_(board), halfCount_rad_(Scalar(0.5) * board.count_rad) {
    current_.configure(board.current, board.tick_s);
    configure({});
  }

  void configure(const ServoSettings<Scalar>& settings) {
    settings_ = settings;
    motion_.configure(settings.gains, board_.tick_s);
    const Scalar Kt = settings.torqueConstant_Nm_per_A;
    perTorque_A_per_Nm_ = Kt > Scalar(0) ? Scalar(1) / Kt : Scalar(0);
    feedback_ = settings.observer_cutoff_rad_per_s > Scalar(0) && Kt > Scalar(0);
    if (settings.observer_cutoff_rad_per_s > Scalar(0)) cutoff_ = settings.observer_cutoff_rad_per_s;
    observer_.configure({cutoff_, settings.inertia_kg_m2, Kt}, board_.tick_s);
    passed_.configure(cutoff_, board_.tick_s);
    const bool known = settings.inertia_kg_m2 > Scalar(0);
    speed_.configure(board_.velocityBandwidth_rad_per_s, known ? Kt / settings.inertia_kg_m2 : Scalar(0),
                     board_.tick_s);
    setLimit();
  }

  /// Of the speed observer and the current loop, in place of the board's own. Precondition: both positive.
  void setBandwidths(Scalar velocity_rad_per_s, Scalar current_rad_per_s) {
    board_.velocityBandwidth_rad_per_s = velocity_rad_per_s;
    board_.current.bandwidth_rad_per_s = current_rad_per_s;
    current_.configure(board_.current, board_.tick_s);
    configure(settings_);
  }

  /// From now on current, velocity and position mode add the friction's torque; a table without bins ends it. The
  /// disturbance feedback then takes what the table leaves over. `cutoff_rad_per_s`: of compensator B, 0: unfiltered.
  void compensate(const FrictionTable<Scalar>& friction, Scalar cutoff_rad_per_s) {
    compensateSoon(friction, cutoff_rad_per_s);
    friction_.prepare(FrictionTable<Scalar>::mostBins);
  }

  /// The same on a board that has ticks to keep: the table is taken bin by bin, one in a tick, and nothing is
  /// compensated meanwhile. It stays as it is until then.
  void compensateSoon(const FrictionTable<Scalar>& friction, Scalar cutoff_rad_per_s) {
    friction_.begin(friction);
    compensator_.configure(cutoff_rad_per_s, board_.tick_s);
    compensator_.reset();
    passed_.reset();
    compensation_Nm_ = passed_Nm_ = 0;
  }

  /// From now on every mode's voltage is asked for through the inverse of the bridge's curve.
  void linearise(const DutyTable<Scalar>& bridge) { bridge_.take(bridge); }

  void command(const ServoCommand<Scalar>& command) {
    if (command.mode != command_.mode) {
      motion_.reset(speed_.velocity_rad_per_s());
      current_.reset();
    }
    if (zeroTicks_ > 0 && !command.zeroCurrentSensor) finishZeroing();
    command_ = command;
    setLimit();
  }

  /// The same command with another target.
  void retarget(Scalar target) { command_.target = target; }

  /// Moves the angle's zero by whole turns, so that a single-precision board can keep it small.
  void shift(Scalar by_rad) {
    speed_.shift(by_rad);
    if (command_.mode == ServoMode::position) command_.target += by_rad;
  }

  /// `angle_rad` is the encoder's count as an angle, `sensor_A` the sensor as it reads, `supply_V` the bridge's supply.
  ServoOutput<Scalar> step(Scalar angle_rad, Scalar sensor_A, Scalar supply_V) {
    const Scalar middle_rad = angle_rad + halfCount_rad_;
    return stepAt(middle_rad, friction_.turnAt(middle_rad), sensor_A, supply_V);
  }

  /// The same at the middle of the encoder's count, as an angle and as a part of a turn, or of what a friction table
  /// covers.
  ServoOutput<Scalar> stepAt(Scalar middle_rad, Turn middle, Scalar sensor_A, Scalar supply_V) {
    ServoOutput<Scalar> out;
    out.enabled = command_.mode != ServoMode::off;
    out.current_A = sensor_A - zero_A_;
    const Scalar flowed_A = wasEnabled_ ? out.current_A : Scalar(0);
    out.velocity_rad_per_s = speed_.step(middle_rad, flowed_A);
    out.disturbance_estimate_Nm = observer_.step(flowed_A, out.velocity_rad_per_s);
    if (friction_.prepares()) friction_.prepare(1);
    if (friction_.known()) passed_Nm_ = passed_.step(compensation_Nm_);
    compensation_Nm_ = 0;
    wasEnabled_ = out.enabled;
    if (command_.mode == ServoMode::off) {
      zero(sensor_A);
      return out;
    }
    const Scalar perSupply = isPositive(supply_V) ? Scalar(1) / supply_V : Scalar(0);
    if (command_.mode == ServoMode::voltage) {
      ask(current_.clampForCurrent(command_.target, out.current_A, out.velocity_rad_per_s, limit_A_), perSupply, out);
    } else {
      out.current_reference_A = reference(middle_rad, middle, out);
      const Scalar most_V = bridge_.known() ? supply_V - bridge_.lost() * supply_V : supply_V;
      ask(current_.step(out.current_reference_A, out.current_A, out.velocity_rad_per_s, most_V), perSupply, out);
    }
    out.voltage_V = out.duty * supply_V;
    return out;
  }

  /// What is taken off the sensor's reading.
  Scalar zero_A() const { return zero_A_; }
  /// That holds now: the settings' own, or the command's where that is less.
  Scalar limit_A() const { return limit_A_; }

 private:
  static constexpr Scalar intentShare = Scalar(0.1);  ///< of the friction that a commanded torque must reach

  void setLimit() {
    const Scalar own = settings_.current_limit_A, wanted = command_.current_limit_A;
    limit_A_ = wanted > Scalar(0) && wanted < own ? wanted : own;
  }

  /// Asks the bridge so that the windings get `wanted_V`, as far as the supply allows.
  void ask(Scalar wanted_V, Scalar perSupply, ServoOutput<Scalar>& out) const {
    out.duty = within(bridge_.inputFor(wanted_V * perSupply), Scalar(1));
  }

  Scalar reference(Scalar middle_rad, Turn middle, ServoOutput<Scalar>& out) {
    const Scalar friction_A = friction_.known() ? frictionCurrent(middle, out.velocity_rad_per_s) : Scalar(0);
    if (command_.mode == ServoMode::current) return within(command_.target + friction_A, limit_A_);
    Scalar compensation = friction_A;
    // What the disturbance observer sees of friction that is compensated already is the same torque through the same
    // filter: without it the reaction torque is left.
    if (feedback_) compensation += (out.disturbance_estimate_Nm - passed_Nm_) * perTorque_A_per_Nm_;
    if (command_.mode == ServoMode::velocity) {
      out.velocity_reference_rad_per_s = command_.target;
      return motion_.velocityStep(command_.target, out.velocity_rad_per_s, compensation, limit_A_);
    }
    const Scalar error = command_.target - middle_rad;
    out.angleAhead_rad = error + halfCount_rad_;
    return motion_.positionStep(error, out.velocity_rad_per_s, compensation, limit_A_);
  }

  /// Current for the friction of the way that the rotor is going, or is to go by the command. In velocity mode the
  /// reference says so, and stands for the speed until the rotor turns the other way; in current mode the commanded
  /// torque does, in proportion up to a share of the friction, so that a small one doesn't throw the rotor about.
  Scalar frictionCurrent(Turn middle, Scalar velocity_rad_per_s) {
    if (isZero(perTorque_A_per_Nm_)) return Scalar(0);
    const auto place = friction_.placeOf(middle);
    const Scalar target = command_.target;
    Scalar torque_Nm = 0;
    const bool against = isNegative(target) != isNegative(velocity_rad_per_s) &&
                         exceeds(velocity_rad_per_s, friction_.blend_rad_per_s());
    if (command_.mode == ServoMode::velocity && !isZero(target) && !against) {
      torque_Nm = friction_.movingTorque_Nm(place, target, velocity_rad_per_s);
    } else {
      torque_Nm = friction_.torque_Nm(place, velocity_rad_per_s, intentAt(place));
    }
    compensation_Nm_ = compensator_.step(torque_Nm);
    return compensation_Nm_ * perTorque_A_per_Nm_;
  }

  /// Within ±1: which way a commanded current is to start the rotor.
  Scalar intentAt(const typename FrictionFeedForward<Scalar>::Place& place) const {
    if (command_.mode != ServoMode::current) return Scalar(0);
    const Scalar wanted_Nm = settings_.torqueConstant_Nm_per_A * command_.target;
    const Scalar whole_Nm = intentShare * friction_.friction_Nm(place);
    if (!isPositive(whole_Nm)) return Scalar(0);
    return exceeds(wanted_Nm, whole_Nm) ? (isNegative(wanted_Nm) ? Scalar(-1) : Scalar(1)) : wanted_Nm / whole_Nm;
  }

  void zero(Scalar sensor_A) {
    if (!command_.zeroCurrentSensor) return;
    zeroSum_A_ += sensor_A;
    ++zeroTicks_;
  }

  void finishZeroing() {
    zero_A_ = zeroSum_A_ / Scalar(zeroTicks_);
    zeroSum_A_ = 0;
    zeroTicks_ = 0;
  }

  Board board_;
  ServoSettings<Scalar> settings_;
  ServoCommand<Scalar> command_;
  VelocityObserver<Scalar> speed_;
  DisturbanceObserver<Scalar> observer_;
  FrictionFeedForward<Scalar> friction_;
  FilteredCompensator<Scalar> compensator_, passed_;
  DutyInverse<Scalar> bridge_;
  MotionController<Scalar> motion_;
  CurrentController<Scalar> current_;
  Scalar halfCount_rad_ = 0, perTorque_A_per_Nm_ = 0, limit_A_ = 0;
  Scalar cutoff_ = 200, zero_A_ = 0, zeroSum_A_ = 0;
  Scalar compensation_Nm_ = 0, passed_Nm_ = 0;  ///< friction's torque, and what of it has passed the observer's filter
  long zeroTicks_ = 0;
  bool wasEnabled_ = false, feedback_ = false;
};

}  // namespace breakaway
