// The whole control tick of a servo board: current zeroing, observers, position, velocity and current loop.
// Freestanding.
#pragma once

#include "control/current_controller.h"
#include "control/friction_compensator.h"
#include "control/motion_controller.h"
#include "observer/disturbance_observer.h"
#include "observer/reaction_torque_observer.h"
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
  Scalar voltage_V = 0;
  Scalar current_A = 0;  ///< with the sensor's zero taken off
  Scalar velocity_rad_per_s = 0;
  Scalar current_reference_A = 0;
  Scalar velocity_reference_rad_per_s = 0;
  Scalar angle_reference_rad = 0;
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

  explicit ServoController(const Board& board) : board_(board) {
    current_.configure(board.current, board.tick_s);
    configure({});
  }

  void configure(const ServoSettings<Scalar>& settings) {
    settings_ = settings;
    motion_.configure(settings.gains, board_.tick_s);
    if (settings.observer_cutoff_rad_per_s > Scalar(0)) cutoff_ = settings.observer_cutoff_rad_per_s;
    observer_.configure({cutoff_, settings.inertia_kg_m2, settings.torqueConstant_Nm_per_A}, board_.tick_s);
    reaction_.configure({{cutoff_, settings.inertia_kg_m2, settings.torqueConstant_Nm_per_A}, Scalar(0), Scalar(0)},
                        board_.tick_s);
    const bool known = settings.inertia_kg_m2 > Scalar(0);
    speed_.configure(board_.velocityBandwidth_rad_per_s,
                     known ? settings.torqueConstant_Nm_per_A / settings.inertia_kg_m2 : Scalar(0), board_.tick_s);
  }

  /// From now on current, velocity and position mode add the friction's torque; a table without bins ends it. The
  /// disturbance feedback then takes what the table leaves over. `cutoff_rad_per_s`: of compensator B, 0: unfiltered.
  void compensate(const FrictionTable<Scalar>& friction, Scalar cutoff_rad_per_s) {
    friction_ = friction;
    compensator_.configure(cutoff_rad_per_s, board_.tick_s);
    compensator_.reset();
    compensation_Nm_ = 0;
  }

  void command(const ServoCommand<Scalar>& command) {
    if (command.mode != command_.mode) {
      motion_.reset(speed_.velocity_rad_per_s());
      current_.reset();
    }
    if (zeroTicks_ > 0 && !command.zeroCurrentSensor) finishZeroing();
    command_ = command;
  }

  /// Moves the angle's zero by whole turns, so that a single-precision board can keep it small.
  void shift(Scalar by_rad) {
    speed_.shift(by_rad);
    if (command_.mode == ServoMode::position) command_.target += by_rad;
  }

  /// `angle_rad` is the encoder's count as an angle, `sensor_A` the sensor as it reads, `supply_V` the bridge's supply.
  ServoOutput<Scalar> step(Scalar angle_rad, Scalar sensor_A, Scalar supply_V) {
    ServoOutput<Scalar> out;
    out.enabled = command_.mode != ServoMode::off;
    out.current_A = sensor_A - zero_A_;
    out.velocity_rad_per_s =
        speed_.step(angle_rad + Scalar(0.5) * board_.count_rad, wasEnabled_ ? out.current_A : Scalar(0));
    out.disturbance_estimate_Nm = observer_.step(wasEnabled_ ? out.current_A : Scalar(0), out.velocity_rad_per_s);
    reaction_.step(wasEnabled_ ? out.current_A : Scalar(0), out.velocity_rad_per_s, compensation_Nm_);
    out.angle_reference_rad = angle_rad;
    wasEnabled_ = out.enabled;
    compensation_Nm_ = 0;
    if (command_.mode == ServoMode::off) {
      zero(sensor_A);
      return out;
    }
    const Scalar limit = currentLimit();
    if (command_.mode == ServoMode::voltage) {
      out.voltage_V =
          within(current_.clampForCurrent(command_.target, out.current_A, out.velocity_rad_per_s, limit), supply_V);
      return out;
    }
    out.current_reference_A = reference(angle_rad, limit, out);
    out.voltage_V = current_.step(out.current_reference_A, out.current_A, out.velocity_rad_per_s, supply_V);
    return out;
  }

 private:
  Scalar currentLimit() const {
    const Scalar own = settings_.current_limit_A, wanted = command_.current_limit_A;
    return wanted > Scalar(0) && wanted < own ? wanted : own;
  }

  Scalar reference(Scalar angle_rad, Scalar limit, ServoOutput<Scalar>& out) {
    const Scalar friction_A = frictionCurrent(angle_rad, out.velocity_rad_per_s);
    if (command_.mode == ServoMode::current) return within(command_.target + friction_A, limit);
    const bool feedback =
        settings_.observer_cutoff_rad_per_s > Scalar(0) && settings_.torqueConstant_Nm_per_A > Scalar(0);
    const Scalar left_Nm = friction_.bins > 0 ? reaction_.estimate_Nm() : out.disturbance_estimate_Nm;
    const Scalar compensation = friction_A + (feedback ? left_Nm / settings_.torqueConstant_Nm_per_A : Scalar(0));
    if (command_.mode == ServoMode::velocity) {
      out.velocity_reference_rad_per_s = command_.target;
      return motion_.velocityStep(command_.target, out.velocity_rad_per_s, compensation, limit);
    }
    out.angle_reference_rad = command_.target;
    return motion_.positionStep(command_.target - angle_rad - Scalar(0.5) * board_.count_rad, out.velocity_rad_per_s,
                                compensation, limit);
  }

  /// Current for the friction of the way that the rotor is going, or is about to go when the velocity's target says so.
  Scalar frictionCurrent(Scalar angle_rad, Scalar velocity_rad_per_s) {
    if (friction_.bins <= 0 || !(settings_.torqueConstant_Nm_per_A > Scalar(0))) return Scalar(0);
    const Scalar blend = friction_.blend_rad_per_s;
    const bool against = command_.target > Scalar(0) ? velocity_rad_per_s < -blend : velocity_rad_per_s > blend;
    const bool byTarget = command_.mode == ServoMode::velocity && command_.target != Scalar(0) && !against;
    compensation_Nm_ = compensator_.step(friction_.torque_Nm(angle_rad + Scalar(0.5) * board_.count_rad,
                                                             byTarget ? command_.target : velocity_rad_per_s));
    return compensation_Nm_ / settings_.torqueConstant_Nm_per_A;
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
  ReactionTorqueObserver<Scalar> reaction_;
  FrictionTable<Scalar> friction_;
  FilteredCompensator<Scalar> compensator_;
  MotionController<Scalar> motion_;
  CurrentController<Scalar> current_;
  Scalar cutoff_ = 200, zero_A_ = 0, zeroSum_A_ = 0, compensation_Nm_ = 0;
  long zeroTicks_ = 0;
  bool wasEnabled_ = false;
};

}  // namespace breakaway
