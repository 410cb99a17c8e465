// The reference firmware, apart from the hardware: bytes in, readings in, bridge out, bytes out. Freestanding, no heap;
// what a tick does is bounded.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware_link/board/board_hardware.h"
#include "firmware_link/board/burst.h"
#include "firmware_link/board/compensation_store.h"
#include "firmware_link/board/control_tick.h"
#include "firmware_link/board/outbox.h"
#include "firmware_link/board/parameters.h"
#include "firmware_link/board/sample_batch.h"
#include "firmware_link/wire/frame.h"
#include "firmware_link/wire/leg_messages.h"
#include "firmware_link/wire/messages.h"

namespace breakaway::board {

/// A port calls tick() once per control tick with what it measured, and does what comes back; between ticks it hands
/// over what came in with receive(), and sends what transmit() gives. All from one context, or one after the other.
/// With Pace::granted it calls tick() only while mayTick(). `outboxBytes` is what waits to be sent, `burstBytes` a
/// capture's room.
///
/// After power-up the motor is off. A STOP, a fault, a lease that ran out: windings open in that tick, and the latch
/// changes, so that only a command sent in the knowledge of it moves the motor again.
template <typename Scalar, std::size_t outboxBytes = 4096, std::size_t burstBytes = 8192>
class ReferenceBoard {
 public:
  explicit ReferenceBoard(const BoardHardware<Scalar>& hardware)
      : hardware_(hardware), parameters_(hardware), control_(hardware), latch_(hardware.boot) {
    period_ns_ = static_cast<std::uint32_t>(Scalar(1e9) / hardware.loopRate_Hz + Scalar(0.5));
    oldestTicks_ = ticksOf(Scalar(0.01));
    obeyParameters();
    hash_ = parameters_.hash();
  }

  void receive(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      if (decoder_.take(byte)) obey(decoder_.frame());
    }
  }

  bool mayTick() const { return hardware_.pace == Pace::real || ahead(untilTick_, tick_) > 0; }

  Drive<Scalar> tick(const Readings<Scalar>& readings) {
    if (hardware_.pace == Pace::real && control_.acts() && ++silentTicks_ > leaseTicks_)
      trip(wire::FaultCode::leaseExpired, {});
    const bool legRan = control_.legRuns();
    TickOutcome<Scalar> outcome = control_.step(readings, limits_, time_us_);
    if (outcome.fault != wire::FaultCode::none) trip(outcome.fault, outcome.measured);
    if (fault_.code != wire::FaultCode::none) outcome.measured.flags |= wire::SampleFlag::latched;
    keep(outcome.measured);
    advanceClock();
    // Whoever grants time has something else to say when a leg has ended.
    if (hardware_.pace == Pace::granted && legRan && !control_.legRuns()) untilTick_ = tick_;
    if (hardware_.pace == Pace::granted && !mayTick()) flush();
    return outcome.drive;
  }

  /// Moves what waits to be sent into `room`; returns how many bytes that were.
  std::size_t transmit(std::span<std::uint8_t> room) { return outbox_.take(room); }

  const wire::FrameCounts& received() const { return decoder_.counts(); }
  std::uint32_t ticks() const { return tick_; }
  bool acts() const { return control_.acts(); }

 private:
  using Body = std::span<const std::uint8_t>;
  static constexpr std::size_t spareForAnswers = 2 * wire::mostFrame;

  static std::int32_t ahead(std::uint32_t a, std::uint32_t b) { return static_cast<std::int32_t>(a - b); }
  std::uint32_t ticksOf(Scalar duration_s) const {
    return static_cast<std::uint32_t>(duration_s * hardware_.loopRate_Hz);
  }

  void advanceClock() {
    ++tick_;
    time_us_ += period_ns_ / 1000u;
    restTime_ns_ += period_ns_ % 1000u;
    if (restTime_ns_ >= 1000u) {
      restTime_ns_ -= 1000u;
      ++time_us_;
    }
  }

  void keep(const wire::Measured<Scalar>& measured) {
    const bool sampled = every_ > 0 && untilSample_ == 0;
    const std::uint16_t burst = burst_.wants(), channels = sampled ? batch_.schema() : std::uint16_t(0);
    wire::WireSample sample;
    wire::convertSample(measured, static_cast<std::uint16_t>(burst | channels), parameters_.perUnit(), sample);
    burst_.add(sample, tick_, time_us_);
    if (every_ == 0) return;
    untilSample_ = sampled ? every_ - 1 : untilSample_ - 1;
    if (!sampled) return;
    if (batch_.samples() == 0) {
      batch_.add(sample, {tick_, time_us_, dropped_, samplesToCome(), unasked_++});
    } else {
      batch_.add(sample, {});
    }
    if (batch_.full()) flush();
  }

  /// With this one, before a batch would be too old or the granted time is over.
  std::uint32_t samplesToCome() const {
    std::uint32_t ticks = oldestTicks_;
    if (hardware_.pace == Pace::granted && untilTick_ - tick_ - 1 < ticks) ticks = untilTick_ - tick_ - 1;
    return ticks / every_ + 1;
  }

  void flush() {
    const std::uint8_t samples = batch_.samples();
    if (samples > 0 && !outbox_.put(batch_.finish(), spareForAnswers)) dropped_ += samples;
  }

  void halt() {
    control_.off();
    ++latch_;
  }

  void trip(wire::FaultCode code, const wire::Measured<Scalar>& seen) {
    fault_.code = code;
    fault_.tick = tick_;
    fault_.current_A = static_cast<float>(seen[wire::Channel::current]);
    fault_.limit_A = static_cast<float>(control_.limit_A());
    fault_.supply_V = static_cast<float>(seen[wire::Channel::supply]);
    fault_.jump_rad = static_cast<float>(control_.watch().jumped_rad());
    fault_.voltage_V = static_cast<float>(control_.voltage_V());
    fault_.meanVelocity_rad_per_s = static_cast<float>(control_.watch().motor().velocity_rad_per_s);
    fault_.resistance_ohm = static_cast<float>(control_.watch().limits().resistance_ohm);
    fault_.backEmf_V_s_per_rad = static_cast<float>(control_.watch().limits().backEmf_V_s_per_rad);
    fault_.velocity_rad_per_s = static_cast<float>(seen[wire::Channel::velocity]);
    fault_.temperature_degC = static_cast<float>(seen[wire::Channel::temperature]);
    halt();
    fault_.latch = latch_;
    wire::Writer out(body_);
    out(fault_);
    outbox_.put(static_cast<std::uint8_t>(wire::Type::faultHappened), unasked_++, out.written());
  }

  static bool changes(wire::Type type) {
    using wire::Type;
    return type == Type::writeParameters || type == Type::command || type == Type::heartbeat ||
           type == Type::writeFriction || type == Type::useFriction || type == Type::startCapture ||
           type == Type::writeBridge || type == Type::useStatic || type == Type::startHoming ||
           type == Type::startBreakaway || type == Type::startSpeed;
  }

  /// What changes something obeys the order in which it was asked, whatever order it comes in.
  bool outOfDate(const wire::Frame& frame) {
    const auto newer = static_cast<std::int16_t>(static_cast<std::uint16_t>(frame.sequence - newest_));
    if (newer >= 0) newest_ = frame.sequence;
    return newer < 0;
  }

  void obey(const wire::Frame& frame) {
    if (frame.type >= wire::beyondRequests) return;  // an echo, or another board
    wire::Writer out(body_);
    out(wire::Code::ok);
    const bool late = changes(static_cast<wire::Type>(frame.type)) && outOfDate(frame);
    const wire::Code code = late ? wire::Code::outdated : answer(frame, out);
    body_[0] = static_cast<std::uint8_t>(code);
    const Body body = code == wire::Code::ok ? Body(out.written()) : Body(body_).first(1);
    outbox_.put(frame.type | wire::answerBit, frame.sequence, body);
  }

  wire::Code answer(const wire::Frame& frame, wire::Writer& out) {
    using wire::Code, wire::Type;
    switch (static_cast<Type>(frame.type)) {
      case Type::hello:
        newest_ = frame.sequence;
        out(hello());
        return Code::ok;
      case Type::serialNumber:
        return tellSerialNumber(out);
      case Type::stop:
        // One that comes twice is one; whoever sent it knows the latch that it led to.
        if (frame.sequence != stop_ || control_.acts()) halt();
        stop_ = frame.sequence;
        out(alive());
        return Code::ok;
      case Type::fault:
        out(fault_);
        return Code::ok;
      case Type::frictionUsed:
        out(compensation_.used());
        return Code::ok;
      case Type::staticUsed:
        out(compensation_.staticUsed());
        return Code::ok;
      case Type::readBridge:
        out(compensation_.bridgeUsed());
        return Code::ok;
      case Type::dictionary:
        return asked<wire::DictionaryAsked>(frame, [&](const auto& page) { return dictionary(page.first, out); });
      case Type::readParameters:
        return asked<wire::ParameterList>(frame, [&](auto& list) { return read(list, out); });
      case Type::readFriction:
        return asked<wire::FrictionChunk>(frame,
                                          [&](auto& chunk) { return told(compensation_.read(chunk), chunk, out); });
      case Type::readCapture:
        return asked<wire::CaptureAsked>(frame, [&](const auto& page) {
          return burst_.write(page.first, period_ns_, out) ? Code::ok : Code::noSuch;
        });
      default:
        return change(frame, out);
    }
  }

  wire::Code change(const wire::Frame& frame, wire::Writer& out) {
    using wire::Code, wire::Type;
    switch (static_cast<Type>(frame.type)) {
      case Type::writeParameters:
        return asked<wire::ParameterList>(frame, [&](auto& list) { return write(list, out); });
      case Type::command:
        return asked<wire::MotorCommand>(frame, [&](auto& wanted) { return command(wanted, out); });
      case Type::heartbeat:
        return asked<wire::Heartbeat>(frame, [&](const auto& beat) { return heard(beat, out); });
      case Type::writeFriction:
        return asked<wire::FrictionChunk>(
            frame, [&](const auto& chunk) { return told(compensation_.write(chunk), chunk, out); });
      case Type::useFriction:
        return asked<wire::FrictionUse>(frame,
                                        [&](const auto& use) { return compensate(use, use.cutoff_rad_per_s, out); });
      case Type::useStatic:
        return asked<wire::StaticFrictionUse>(
            frame, [&](const auto& use) { return compensate(use, use.table.cutoff_rad_per_s, out); });
      case Type::writeBridge:
        return asked<wire::BridgeCurve>(frame, [&](const auto& curve) {
          const wire::Code code = compensation_.use(curve);
          if (code == Code::ok) control_.linearise(compensation_.bridge());
          return told(code, curve, out);
        });
      case Type::startHoming:
        return asked<wire::StartHoming>(frame, [&](auto& leg) { return start(leg, out); });
      case Type::startBreakaway:
        return asked<wire::StartBreakaway>(frame, [&](auto& leg) { return start(leg, out); });
      case Type::startSpeed:
        return asked<wire::StartSpeed>(frame, [&](auto& leg) { return start(leg, out); });
      case Type::startCapture:
        return asked<wire::Capture>(frame, [&](const auto& wanted) {
          out(burst_.start(wanted));
          return Code::ok;
        });
      default:
        return Code::unknown;
    }
  }

  template <typename Message, typename Do>
  wire::Code asked(const wire::Frame& frame, Do&& act) {
    Message message;
    return wire::readMessage(frame.body, message) ? act(message) : wire::Code::malformed;
  }

  wire::Hello hello() const {
    using Ability = wire::Hello::Ability;
    wire::Hello hello;
    const auto can = [&hello](bool really, Ability what) {
      if (really) hello.abilities = static_cast<std::uint16_t>(hello.abilities | what);
    };
    can(hardware_.hasIndex, Ability::hasIndex);
    can(hardware_.simulated, Ability::simulated);
    can(hardware_.pace == Pace::granted, Ability::grantedPace);
    can(hardware_.hasTemperature, Ability::temperature);
    can(true, Ability::capture);
    can(true, Ability::friction);
    can(true, Ability::staticFriction);
    can(true, Ability::bridgeCurve);
    can(true, Ability::legs);
    can(hardware_.serialNumber[0] != '\0', Ability::serialNumber);
    hello.boot = hardware_.boot;
    hello.latch = latch_;
    hello.loopRate_Hz = static_cast<float>(hardware_.loopRate_Hz);
    hello.supply_V = static_cast<float>(hardware_.supply_V);
    hello.countsPerRev = hardware_.countsPerRev;
    hello.entries = Parameters<Scalar>::entries;
    hello.dictionaryHash = hash_;
    hello.frictionBins = FrictionTable<Scalar>::mostBins;
    copyText(hardware_.device, hello.device);
    copyText(hardware_.firmware, hello.firmware);
    return hello;
  }

  template <std::size_t size>
  static void copyText(const char* text, char (&room)[size]) {
    for (std::size_t k = 0; k < size && text[k] != '\0'; ++k) room[k] = text[k];
  }

  wire::Code tellSerialNumber(wire::Writer& out) const {
    if (hardware_.serialNumber[0] == '\0') return wire::Code::noSuch;
    wire::SerialNumber serial;
    copyText(hardware_.serialNumber, serial.text);
    out(serial);
    return wire::Code::ok;
  }

  wire::Alive alive() const {
    wire::Alive alive;
    alive.boot = hardware_.boot;
    alive.latch = latch_;
    alive.mode = control_.mode();
    alive.fault = fault_.code;
    alive.tick = tick_;
    alive.time_us = time_us_;
    alive.untilTick = untilTick_;
    alive.dropped = dropped_;
    return alive;
  }

  wire::Code dictionary(std::uint16_t first, wire::Writer& out) const {
    if (first >= Parameters<Scalar>::entries) return wire::Code::noSuch;
    wire::DictionaryPage page;
    page.first = first;
    for (std::size_t k = first; k < Parameters<Scalar>::entries && page.count < page.mostEntries; ++k)
      page.entry[page.count++] = parameters_.entry(k);
    out(page);
    return wire::Code::ok;
  }

  wire::Code read(wire::ParameterList& list, wire::Writer& out) {
    parameters_.show(Parameter::currentZero, control_.zero_A());
    for (std::size_t k = 0; k < list.count; ++k) {
      if (list.value[k].id >= parameterCount) return wire::Code::noSuch;
      list.value[k].word = parameters_.whole(static_cast<Parameter>(list.value[k].id));
    }
    out(list);
    return wire::Code::ok;
  }

  /// All of them or none.
  wire::Code write(wire::ParameterList& list, wire::Writer& out) {
    for (std::size_t k = 0; k < list.count; ++k) {
      const wire::Code code = parameters_.judge(list.value[k]);
      if (code != wire::Code::ok) return code;
    }
    const ServoSettings<Scalar> before = parameters_.servo();
    const std::uint32_t velocityBefore = parameters_.whole(Parameter::velocityBandwidth);
    const std::uint32_t currentBefore = parameters_.whole(Parameter::currentBandwidth);
    for (std::size_t k = 0; k < list.count; ++k) parameters_.set(list.value[k]);
    if (!(parameters_.servo() == before)) control_.configure(parameters_.servo());
    if (parameters_.whole(Parameter::velocityBandwidth) != velocityBefore ||
        parameters_.whole(Parameter::currentBandwidth) != currentBefore) {
      control_.setBandwidths(parameters_.scalar(Parameter::velocityBandwidth),
                             parameters_.scalar(Parameter::currentBandwidth));
    }
    obeyParameters();
    out(list);
    return wire::Code::ok;
  }

  /// What a tick needs of the parameters.
  void obeyParameters() {
    leaseTicks_ = ticksOf(parameters_.scalar(Parameter::lease));
    const Scalar travel = parameters_.scalar(Parameter::travelLimit) / hardware_.servo.count_rad;
    control_.limitVelocity(parameters_.scalar(Parameter::velocityTrip));
    const bool free = !(travel > Scalar(0) && travel < Scalar(2e9));
    limits_.travel_counts = free ? TickLimits<Scalar>::noTravelLimit : static_cast<std::uint32_t>(travel);
    limits_.temperature_degC = parameters_.scalar(Parameter::temperatureLimit);
    const std::uint32_t every = parameters_.whole(Parameter::telemetryEvery);
    const auto schema = static_cast<std::uint16_t>(parameters_.whole(Parameter::telemetryChannels));
    if (every == every_ && schema == batch_.schema()) return;
    flush();
    every_ = every;
    untilSample_ = every > 0 ? (every - tick_ % every) % every : 0;
    batch_.begin(schema, static_cast<std::uint8_t>(every), period_ns_ * every);
  }

  wire::Code command(wire::MotorCommand& wanted, wire::Writer& out) {
    using Mode = wire::MotorCommand::Mode;
    const bool known = static_cast<std::uint8_t>(wanted.mode) <= static_cast<std::uint8_t>(Mode::position);
    if (!known || !wire::isFinite(wanted.target) || !wire::isFinite(wanted.current_limit_A))
      return wire::Code::notAValue;
    const bool acts = wanted.mode != Mode::off || (wanted.flags & wire::MotorCommand::watched) != 0;
    if (acts && wanted.latch != latch_) return wire::Code::latched;
    begin(wanted, acts);
    control_.command(wanted);
    burst_.commandCame();
    wanted.latch = latch_;
    out(wanted);
    return wire::Code::ok;
  }

  template <typename Start>
  wire::Code start(Start& leg, wire::Writer& out) {
    if (!wire::allFinite(leg)) return wire::Code::notAValue;
    if (leg.head.latch != latch_) return wire::Code::latched;
    begin(leg.head, true);
    control_.start(leg);
    burst_.commandCame();
    out(leg);
    return wire::Code::ok;
  }

  /// What a command and a leg's start have in common.
  template <typename Head>
  void begin(Head& head, bool acts) {
    if (head.current_limit_A < 0.0f) head.current_limit_A = 0.0f;
    if ((head.flags & wire::MotorCommand::fresh) != 0) fault_.code = wire::FaultCode::none;
    if (acts && !control_.acts()) silentTicks_ = 0;
  }

  wire::Code heard(const wire::Heartbeat& beat, wire::Writer& out) {
    silentTicks_ = 0;
    const std::int32_t most = static_cast<std::int32_t>(ticksOf(Scalar(0.2)));
    if (hardware_.pace == Pace::granted && ahead(beat.untilTick, untilTick_) > 0)
      untilTick_ = ahead(beat.untilTick, tick_) > most ? tick_ + static_cast<std::uint32_t>(most) : beat.untilTick;
    out(alive());
    return wire::Code::ok;
  }

  template <typename Use>
  wire::Code compensate(const Use& use, float cutoff_rad_per_s, wire::Writer& out) {
    const wire::Code code = compensation_.use(use);
    if (code == wire::Code::ok) control_.compensate(compensation_.friction(), static_cast<Scalar>(cutoff_rad_per_s));
    return told(code, use, out);
  }

  /// Answers with the message where the code is ok.
  template <typename Message>
  static wire::Code told(wire::Code code, const Message& message, wire::Writer& out) {
    if (code == wire::Code::ok) out(message);
    return code;
  }

  BoardHardware<Scalar> hardware_;
  Parameters<Scalar> parameters_;
  ControlTick<Scalar> control_;
  wire::FrameDecoder decoder_;
  Outbox<outboxBytes> outbox_;
  TickLimits<Scalar> limits_;
  SampleBatch batch_;
  Burst<burstBytes> burst_;
  CompensationStore<Scalar> compensation_;
  wire::Fault fault_;
  std::uint8_t body_[wire::mostBody] = {};
  std::uint32_t tick_ = 0, untilTick_ = 0, time_us_ = 0, restTime_ns_ = 0, period_ns_ = 0;
  std::uint32_t every_ = 0, untilSample_ = 0, oldestTicks_ = 0;  ///< ticks: telemetry's, to its next one, in a batch
  std::uint32_t silentTicks_ = 0, leaseTicks_ = 0, dropped_ = 0, hash_ = 0;
  std::uint16_t latch_ = 0, unasked_ = 0, newest_ = 0, stop_ = 0;
};

}  // namespace breakaway::board
