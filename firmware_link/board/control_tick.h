// One control tick of the portable board: readings in, bridge out, limits checked whatever was asked. Freestanding, no
// heap, no unbounded loop.
#pragma once

#include <cstdint>

#include "control/board_watch.h"
#include "control/servo_controller.h"
#include "firmware_link/board/board_hardware.h"
#include "firmware_link/wire/messages.h"

namespace breakaway::board {

/// Limits that the host may draw tighter; 0: none, speed apart.
template <typename Scalar>
struct TickLimits {
  Scalar velocity_rad_per_s = 0;
  Scalar travel_rad = 0;
  Scalar temperature_degC = 0;
};

template <typename Scalar>
struct TickOutcome {
  Drive<Scalar> drive;
  wire::Measured<Scalar> measured;
  wire::FaultCode fault = wire::FaultCode::none;  ///< the windings are open already
};

template <typename Scalar>
class ControlTick {
 public:
  explicit ControlTick(const BoardHardware<Scalar>& hardware)
      : hardware_(hardware), servo_(hardware.servo), watch_(hardware.watch) {
    configure(hardware.start);
  }

  void configure(const ServoSettings<Scalar>& settings) {
    servo_.configure(settings);
    ownLimit_A_ = settings.current_limit_A;
  }
  void compensate(const FrictionTable<Scalar>& friction, Scalar cutoff_rad_per_s) {
    servo_.compensate(friction, cutoff_rad_per_s);
  }

  void command(const wire::MotorCommand& wanted) {
    using Flag = wire::MotorCommand::Flag;
    static_assert(static_cast<int>(wire::MotorCommand::Mode::position) == static_cast<int>(ServoMode::position));
    if ((wanted.flags & Flag::fresh) != 0) {
      watch_.restart();
      travelStart_ = count_;
    }
    watched_ = (wanted.flags & Flag::watched) != 0;
    wanted_ = wanted;
    obey();
  }
  void off() {
    command({});
    left_ = 0;
  }

  TickOutcome<Scalar> step(const Readings<Scalar>& readings, const TickLimits<Scalar>& limits) {
    using wire::Channel;
    count_ = readings.count;
    if (!known_) origin_ = travelStart_ = count_;
    known_ = true;
    keepAngleSmall();
    const Scalar angle = angleOf(count_), bus = readings.supply_V > Scalar(1e-3) ? readings.supply_V : Scalar(1e-3);
    const ServoOutput<Scalar> out = servo_.step(angle, readings.current_A, bus);
    zero_A_ = readings.current_A - out.current_A;
    TickOutcome<Scalar> outcome;
    outcome.fault = judged(readings, out, angle, limits);
    const bool enabled = out.enabled && outcome.fault == wire::FaultCode::none;
    outcome.drive = {enabled, enabled ? realisable(out.voltage_V / bus) : Scalar(0)};
    wire::Measured<Scalar>& m = outcome.measured;
    m.angle_counts = count_;
    m.flags = static_cast<std::uint8_t>((enabled ? wire::SampleFlag::enabled : 0) |
                                        (readings.index ? wire::SampleFlag::index : 0));
    m[Channel::current] = out.current_A;
    m[Channel::duty] = outcome.drive.duty;
    m[Channel::supply] = readings.supply_V;
    m[Channel::velocity] = out.velocity_rad_per_s;
    m[Channel::currentReference] = out.current_reference_A;
    m[Channel::velocityReference] = out.velocity_reference_rad_per_s;
    m[Channel::angleAhead] = out.angle_reference_rad - angle;
    m[Channel::disturbance] = out.disturbance_estimate_Nm;
    m[Channel::sensorCurrent] = readings.current_A;
    m[Channel::temperature] = hardware_.hasTemperature ? readings.temperature_degC : Scalar(__builtin_nanf(""));
    return outcome;
  }

  wire::MotorCommand::Mode mode() const { return wanted_.mode; }
  bool acts() const { return watched_ || wanted_.mode != wire::MotorCommand::Mode::off; }
  Scalar limit_A() const {
    const Scalar wanted = commandLimit_A();
    return wanted > Scalar(0) && wanted < ownLimit_A_ ? wanted : ownLimit_A_;
  }
  /// What is taken off the sensor's reading.
  Scalar zero_A() const { return zero_A_; }
  Scalar jumped_rad() const { return watch_.jumped_rad(); }

 private:
  void obey() {
    ServoCommand<Scalar> servo{static_cast<ServoMode>(wanted_.mode), static_cast<Scalar>(wanted_.target),
                               commandLimit_A(), (wanted_.flags & wire::MotorCommand::zeroCurrentSensor) != 0};
    if (servo.mode == ServoMode::position) servo.target += angleOf(wanted_.targetCounts);
    servo_.command(servo);
  }
  Scalar commandLimit_A() const { return static_cast<Scalar>(wanted_.current_limit_A); }

  static std::int32_t difference(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
  }
  Scalar angleOf(std::int32_t count) const {
    return static_cast<Scalar>(difference(count, origin_)) * hardware_.servo.count_rad;
  }

  /// Single precision tells counts apart within a few turns only. Whole turns leave the friction table as it is.
  void keepAngleSmall() {
    const auto turn = static_cast<std::int32_t>(hardware_.countsPerRev);
    const std::int32_t turns = difference(count_, origin_) / turn;
    if (turns == 0) return;
    origin_ = static_cast<std::int32_t>(static_cast<std::uint32_t>(origin_) +
                                        static_cast<std::uint32_t>(turns) * hardware_.countsPerRev);
    const Scalar by = -static_cast<Scalar>(turns) * static_cast<Scalar>(turn) * hardware_.servo.count_rad;
    servo_.shift(by);
    watch_.shift(by);
    if (wanted_.mode == wire::MotorCommand::Mode::position) obey();  // the target's rounding would add up
  }

  wire::FaultCode judged(const Readings<Scalar>& readings, const ServoOutput<Scalar>& out, Scalar angle,
                         const TickLimits<Scalar>& limits) {
    using wire::FaultCode;
    static_assert(static_cast<int>(FaultCode::blocked) == static_cast<int>(Trip::blocked) &&
                  static_cast<int>(FaultCode::overCurrent) == static_cast<int>(Trip::overCurrent));
    const Trip trip =
        watch_.step({angle, out.current_A, out.current_reference_A, limit_A(), readings.supply_V, out.enabled});
    if (!out.enabled && !watched_) return FaultCode::none;
    if (trip != Trip::none) return static_cast<FaultCode>(trip);
    const Scalar speed = magnitude(out.velocity_rad_per_s);
    if (!(speed <= limits.velocity_rad_per_s)) return FaultCode::overSpeed;
    const Scalar travel = magnitude(static_cast<Scalar>(difference(count_, travelStart_)) * hardware_.servo.count_rad);
    if (limits.travel_rad > Scalar(0) && travel > limits.travel_rad) return FaultCode::travel;
    const bool hot = hardware_.hasTemperature && limits.temperature_degC > Scalar(0) &&
                     !(readings.temperature_degC <= limits.temperature_degC);
    return hot ? FaultCode::overTemperature : FaultCode::none;
  }

  static Scalar magnitude(Scalar value) { return value < Scalar(0) ? -value : value; }

  /// The duty that the timer can make; what a step leaves over goes into the next one, so that the mean is exact.
  Scalar realisable(Scalar duty) {
    const Scalar wanted = within(duty + left_, Scalar(1));
    if (hardware_.pwmSteps == 0) return wanted;
    const auto steps = static_cast<Scalar>(hardware_.pwmSteps);
    const Scalar scaled = wanted * steps;
    const auto whole = static_cast<std::int32_t>(scaled < Scalar(0) ? scaled - Scalar(0.5) : scaled + Scalar(0.5));
    const Scalar made = static_cast<Scalar>(whole) / steps;
    left_ = within(wanted - made, Scalar(0.5));
    return made;
  }

  BoardHardware<Scalar> hardware_;
  ServoController<Scalar> servo_;
  BoardWatch<Scalar> watch_;
  wire::MotorCommand wanted_;
  Scalar ownLimit_A_ = 0, left_ = 0, zero_A_ = 0;
  std::int32_t count_ = 0, origin_ = 0, travelStart_ = 0;
  bool known_ = false, watched_ = false;
};

}  // namespace breakaway::board
