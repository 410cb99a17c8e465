// One control tick of the portable board: readings in, bridge out, limits checked whatever was asked. Freestanding, no
// heap, no unbounded loop.
#pragma once

#include <cstdint>

#include "control/board_watch.h"
#include "control/magnitude.h"
#include "control/servo_controller.h"
#include "control/turn.h"
#include "firmware_link/board/board_hardware.h"
#include "firmware_link/board/leg_tick.h"
#include "firmware_link/wire/messages.h"
#include "firmware_link/wire/nearest.h"

namespace breakaway::board {

/// Limits that the host may draw tighter; temperature 0: none.
template <typename Scalar>
struct TickLimits {
  static constexpr std::uint32_t noTravelLimit = 0xffffffffu;
  std::uint32_t travel_counts = noTravelLimit;
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
      : hardware_(hardware),
        servo_(hardware.servo),
        watch_(hardware.watch),
        halfCount_rad_(Scalar(0.5) * hardware.servo.count_rad),
        perHalfCount_(hardware.countsPerRev > 0 ? (0x80000000u + hardware.countsPerRev / 2) / hardware.countsPerRev
                                                : 0),
        steps_(static_cast<Scalar>(hardware.pwmSteps)),
        perStep_(hardware.pwmSteps > 0 ? Scalar(1) / static_cast<Scalar>(hardware.pwmSteps) : Scalar(0)) {
    configure(hardware.start);
  }

  void configure(const ServoSettings<Scalar>& settings) { servo_.configure(settings); }
  void setBandwidths(Scalar velocity_rad_per_s, Scalar current_rad_per_s) {
    servo_.setBandwidths(velocity_rad_per_s, current_rad_per_s);
  }
  /// Takes effect after as many ticks as the table has bins; it stays as it is until the next one.
  void compensate(const FrictionTable<Scalar>& friction, Scalar cutoff_rad_per_s) {
    servo_.compensateSoon(friction, cutoff_rad_per_s);
  }
  void limitVelocity(Scalar most_rad_per_s) { watch_.limitVelocity(most_rad_per_s); }
  void linearise(const DutyTable<Scalar>& bridge) { servo_.linearise(bridge); }

  void command(const wire::MotorCommand& wanted) {
    static_assert(static_cast<int>(wire::MotorCommand::Mode::position) == static_cast<int>(ServoMode::position));
    leg_.forget();
    take(wanted);
    obey();
  }

  /// From the next tick on the leg commands. One that was started already goes on as it is.
  template <typename Start>
  void start(const Start& start) {
    if (leg_.has(start.head.number)) return;
    wire::MotorCommand head;
    head.flags = start.head.flags;
    head.latch = start.head.latch;
    head.current_limit_A = start.head.current_limit_A;
    take(head);
    leg_.begin(start, {static_cast<std::int32_t>(hardware_.countsPerRev)});
    obey(leg_.ask());
  }
  bool legRuns() const { return leg_.runs(); }
  void off() {
    command({});
    left_ = 0;
  }

  TickOutcome<Scalar> step(const Readings<Scalar>& readings, const TickLimits<Scalar>& limits, std::uint32_t time_us) {
    using wire::Channel;
    count_ = readings.count;
    if (!known_) begin();
    keepAngleSmall();
    const std::int32_t halfCounts = 2 * difference(count_, origin_) + 1;
    const Scalar middle = static_cast<Scalar>(halfCounts) * halfCount_rad_;
    const Turn turn = (static_cast<Turn>(halfCounts) + firstHalfCounts_) * perHalfCount_;
    const Scalar bus = isAbove(readings.supply_V, Scalar(1e-3)) ? readings.supply_V : Scalar(1e-3);
    const ServoOutput<Scalar> out = servo_.stepAt(middle, turn, readings.current_A, bus);
    voltage_V_ = out.voltage_V;
    TickOutcome<Scalar> outcome;
    outcome.fault = judged(readings, out, middle, limits);
    const bool enabled = out.enabled && outcome.fault == wire::FaultCode::none;
    outcome.drive = {enabled, enabled ? realisable(out.duty) : Scalar(0)};
    if (leg_.runs()) obey(leg_.step({time_us, count_, readings.index, out.velocity_rad_per_s, readings.supply_V}));
    wire::Measured<Scalar>& m = outcome.measured;
    m.angle_counts = count_;
    m.flags = static_cast<std::uint8_t>((enabled ? wire::SampleFlag::enabled : 0) |
                                        (readings.index ? wire::SampleFlag::index : 0) | leg_.flags());
    m[Channel::current] = out.current_A;
    m[Channel::duty] = outcome.drive.duty;
    m[Channel::supply] = readings.supply_V;
    m[Channel::velocity] = out.velocity_rad_per_s;
    m[Channel::currentReference] = out.current_reference_A;
    m[Channel::velocityReference] = out.velocity_reference_rad_per_s;
    m[Channel::angleAhead] = out.angleAhead_rad;
    m[Channel::disturbance] = out.disturbance_estimate_Nm;
    m[Channel::sensorCurrent] = readings.current_A;
    m[Channel::temperature] = hardware_.hasTemperature ? readings.temperature_degC : Scalar(__builtin_nanf(""));
    return outcome;
  }

  wire::MotorCommand::Mode mode() const { return wanted_.mode; }
  bool acts() const { return watched_ || wanted_.mode != wire::MotorCommand::Mode::off; }
  Scalar limit_A() const { return servo_.limit_A(); }
  /// What is taken off the sensor's reading.
  Scalar zero_A() const { return servo_.zero_A(); }
  const BoardWatch<Scalar>& watch() const { return watch_; }
  /// That the last tick asked for.
  Scalar voltage_V() const { return voltage_V_; }

 private:
  void take(const wire::MotorCommand& wanted) {
    using Flag = wire::MotorCommand::Flag;
    if ((wanted.flags & Flag::fresh) != 0) {
      watch_.restart();
      travelStart_ = count_;
    }
    watched_ = (wanted.flags & Flag::watched) != 0;
    wanted_ = wanted;
  }

  void obey(const LegAsk<Scalar>& ask) {
    const auto mode = static_cast<wire::MotorCommand::Mode>(ask.mode);
    const auto target = static_cast<float>(ask.target);
    if (mode == wanted_.mode && ask.targetCounts == wanted_.targetCounts) {
      if (target == wanted_.target) return;
      wanted_.target = target;
      servo_.retarget(ask.target);
    } else {
      wanted_.mode = mode;
      wanted_.target = target;
      wanted_.targetCounts = ask.targetCounts;
      obey();
    }
  }

  void obey() {
    ServoCommand<Scalar> servo{static_cast<ServoMode>(wanted_.mode), static_cast<Scalar>(wanted_.target),
                               static_cast<Scalar>(wanted_.current_limit_A),
                               (wanted_.flags & wire::MotorCommand::zeroCurrentSensor) != 0};
    if (servo.mode == ServoMode::position) servo.target += angleOf(wanted_.targetCounts);
    servo_.command(servo);
  }

  /// The first count is the angle's zero, so that nothing jumps; the friction table knows it by its place in the turn.
  void begin() {
    known_ = true;
    origin_ = travelStart_ = count_;
    const auto turn = static_cast<std::int32_t>(hardware_.countsPerRev);
    const std::int32_t part = turn > 0 ? count_ % turn : 0;
    firstHalfCounts_ = 2u * static_cast<Turn>(part < 0 ? part + turn : part);
  }

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

  wire::FaultCode judged(const Readings<Scalar>& readings, const ServoOutput<Scalar>& out, Scalar angle_rad,
                         const TickLimits<Scalar>& limits) {
    using wire::FaultCode;
    static_assert(static_cast<int>(FaultCode::blocked) == static_cast<int>(Trip::blocked) &&
                  static_cast<int>(FaultCode::overCurrent) == static_cast<int>(Trip::overCurrent) &&
                  static_cast<int>(FaultCode::overSpeed) == static_cast<int>(Trip::overSpeed) &&
                  static_cast<int>(FaultCode::windingHeat) == static_cast<int>(Trip::windingHeat) &&
                  static_cast<int>(FaultCode::supplyHigh) == static_cast<int>(Trip::supplyHigh) &&
                  static_cast<int>(FaultCode::contradiction) == static_cast<int>(Trip::contradiction));
    const Trip trip = watch_.step(
        {angle_rad, out.current_A, out.current_reference_A, limit_A(), readings.supply_V, out.enabled, out.voltage_V,
         out.velocity_rad_per_s, wanted_.mode == wire::MotorCommand::Mode::velocity, out.velocity_reference_rad_per_s});
    if (!out.enabled && !watched_) return FaultCode::none;
    if (trip != Trip::none) return static_cast<FaultCode>(trip);
    const std::int32_t moved = difference(count_, travelStart_);
    const std::uint32_t travel = moved < 0 ? 0u - static_cast<std::uint32_t>(moved) : static_cast<std::uint32_t>(moved);
    if (travel > limits.travel_counts) return FaultCode::travel;
    const bool hot = hardware_.hasTemperature && isPositive(limits.temperature_degC) &&
                     !(readings.temperature_degC <= limits.temperature_degC);
    return hot ? FaultCode::overTemperature : FaultCode::none;
  }

  /// The duty that the timer can make; what a step leaves over goes into the next one, so that the mean is exact.
  Scalar realisable(Scalar duty) {
    if (hardware_.pwmSteps == 0) return duty;
    const Scalar wanted = within(duty * steps_ + left_, steps_);
    const auto made = static_cast<Scalar>(wire::nearest(wanted));
    left_ = wanted - made;
    return made * perStep_;
  }

  BoardHardware<Scalar> hardware_;
  ServoController<Scalar> servo_;
  BoardWatch<Scalar> watch_;
  wire::MotorCommand wanted_;
  LegTick<Scalar> leg_;
  Scalar halfCount_rad_;
  Turn perHalfCount_, firstHalfCounts_ = 0;
  Scalar voltage_V_ = 0;
  Scalar steps_, perStep_, left_ = 0;  ///< of the timer, and what the last one left over
  std::int32_t count_ = 0, origin_ = 0, travelStart_ = 0;
  bool known_ = false, watched_ = false;
};

}  // namespace breakaway::board
