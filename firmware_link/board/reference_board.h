// The reference firmware, apart from the hardware: bytes in, readings in, bridge out, bytes out. Freestanding, no heap;
// what a tick does is bounded.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware_link/board/board_hardware.h"
#include "firmware_link/board/burst.h"
#include "firmware_link/board/control_tick.h"
#include "firmware_link/board/outbox.h"
#include "firmware_link/board/parameters.h"
#include "firmware_link/board/sample_batch.h"
#include "firmware_link/wire/frame.h"
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
    leaseTicks_ = ticksOf(parameters_.scalar(Parameter::lease));
    period_ns_ = static_cast<std::uint32_t>(Scalar(1e9) / hardware.loopRate_Hz + Scalar(0.5));
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
    const TickLimits<Scalar> limits{parameters_.scalar(Parameter::velocityTrip),
                                    parameters_.scalar(Parameter::travelLimit),
                                    parameters_.scalar(Parameter::temperatureLimit)};
    TickOutcome<Scalar> outcome = control_.step(readings, limits);
    if (outcome.fault != wire::FaultCode::none) trip(outcome.fault, outcome.measured);
    if (fault_.code != wire::FaultCode::none) outcome.measured.flags |= wire::SampleFlag::latched;
    keep(outcome.measured);
    advanceClock();
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
    burst_.add(measured, tick_, time_us_, parameters_.perUnit());
    const std::uint32_t every = parameters_.whole(Parameter::telemetryEvery);
    if (every == 0) return;
    if (tick_ % every == 0) batch_.add(measured, tick_, time_us_, parameters_.perUnit());
    const std::uint32_t oldest = ticksOf(Scalar(0.01));
    if (batch_.full() || (batch_.samples() > 0 && tick_ - batch_.firstTick() >= oldest)) flush();
  }

  void flush() {
    const std::uint8_t samples = batch_.samples();
    if (samples == 0) return;
    const Body body = batch_.finish(dropped_);
    if (!outbox_.put(static_cast<std::uint8_t>(wire::Type::telemetry), unasked_++, body, spareForAnswers))
      dropped_ += samples;
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
    fault_.jump_rad = static_cast<float>(control_.jumped_rad());
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
           type == Type::writeFriction || type == Type::useFriction || type == Type::startCapture;
  }

  /// What changes something obeys the order in which it was asked, whatever order it comes in.
  bool outOfDate(const wire::Frame& frame) {
    const auto newer = static_cast<std::int16_t>(static_cast<std::uint16_t>(frame.sequence - newest_));
    if (newer >= 0) newest_ = frame.sequence;
    return newer < 0;
  }

  void obey(const wire::Frame& frame) {
    if ((frame.type & wire::answerBit) != 0) return;  // an echo, or another board
    wire::Writer out(body_);
    out(wire::Code::ok);
    if (changes(static_cast<wire::Type>(frame.type)) && outOfDate(frame)) return;
    const wire::Code code = answer(frame, out);
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
        out(used_);
        return Code::ok;
      case Type::dictionary:
        return asked<wire::DictionaryAsked>(frame, [&](const auto& page) { return dictionary(page.first, out); });
      case Type::readParameters:
        return asked<wire::ParameterList>(frame, [&](auto& list) { return read(list, out); });
      case Type::readFriction:
        return asked<wire::FrictionChunk>(frame, [&](auto& chunk) { return readFriction(chunk, out); });
      case Type::readCapture:
        return asked<wire::CaptureAsked>(frame, [&](const auto& page) {
          return burst_.write(page.first, period_ns_, out) ? Code::ok : Code::noSuch;
        });
      case Type::startProcedure:
      case Type::stopProcedure:
      case Type::procedureStatus:
        return Code::notPossible;
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
        return asked<wire::FrictionChunk>(frame, [&](const auto& chunk) { return writeFriction(chunk, out); });
      case Type::useFriction:
        return asked<wire::FrictionUse>(frame, [&](const auto& use) { return useFriction(use, out); });
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
    const std::uint32_t every = parameters_.whole(Parameter::telemetryEvery);
    const std::uint32_t schema = parameters_.whole(Parameter::telemetryChannels);
    for (std::size_t k = 0; k < list.count; ++k) parameters_.set(list.value[k]);
    if (!(parameters_.servo() == before)) control_.configure(parameters_.servo());
    leaseTicks_ = ticksOf(parameters_.scalar(Parameter::lease));
    if (parameters_.whole(Parameter::telemetryEvery) != every ||
        parameters_.whole(Parameter::telemetryChannels) != schema)
      beginBatch();
    out(list);
    return wire::Code::ok;
  }

  void beginBatch() {
    flush();
    const auto every = static_cast<std::uint8_t>(parameters_.whole(Parameter::telemetryEvery));
    batch_.begin(static_cast<std::uint16_t>(parameters_.whole(Parameter::telemetryChannels)), every,
                 period_ns_ * every);
  }

  static bool finite(float value) { return value - value == 0.0f; }

  wire::Code command(wire::MotorCommand& wanted, wire::Writer& out) {
    using Mode = wire::MotorCommand::Mode;
    const bool known = static_cast<std::uint8_t>(wanted.mode) <= static_cast<std::uint8_t>(Mode::position);
    if (!known || !finite(wanted.target) || !finite(wanted.current_limit_A)) return wire::Code::notAValue;
    const bool acts = wanted.mode != Mode::off || (wanted.flags & wire::MotorCommand::watched) != 0;
    if (acts && wanted.latch != latch_) return wire::Code::latched;
    if (wanted.current_limit_A < 0.0f) wanted.current_limit_A = 0.0f;
    if ((wanted.flags & wire::MotorCommand::fresh) != 0) fault_.code = wire::FaultCode::none;
    if (acts && !control_.acts()) silentTicks_ = 0;
    control_.command(wanted);
    burst_.commandCame();
    wanted.latch = latch_;
    out(wanted);
    return wire::Code::ok;
  }

  wire::Code heard(const wire::Heartbeat& beat, wire::Writer& out) {
    silentTicks_ = 0;
    const std::int32_t most = static_cast<std::int32_t>(ticksOf(Scalar(0.2)));
    if (hardware_.pace == Pace::granted && ahead(beat.untilTick, untilTick_) > 0)
      untilTick_ = ahead(beat.untilTick, tick_) > most ? tick_ + static_cast<std::uint32_t>(most) : beat.untilTick;
    out(alive());
    return wire::Code::ok;
  }

  Scalar* curve(wire::FrictionCurve which) {
    const auto k = static_cast<std::uint8_t>(which);
    if (k > 3) return nullptr;
    return k < 2 ? written_.coulomb_Nm[k] : written_.viscous_Nm_s_per_rad[k - 2];
  }

  wire::Code writeFriction(const wire::FrictionChunk& chunk, wire::Writer& out) {
    Scalar* values = curve(chunk.curve);
    if (values == nullptr || std::size_t(chunk.first) + chunk.count > FrictionTable<Scalar>::mostBins)
      return wire::Code::noSuch;
    for (std::size_t k = 0; k < chunk.count; ++k) {
      if (!finite(chunk.value[k])) return wire::Code::notAValue;
    }
    for (std::size_t k = 0; k < chunk.count; ++k) values[chunk.first + k] = static_cast<Scalar>(chunk.value[k]);
    out(chunk);
    return wire::Code::ok;
  }

  wire::Code readFriction(wire::FrictionChunk& chunk, wire::Writer& out) {
    const Scalar* values = curve(chunk.curve);
    if (values == nullptr || std::size_t(chunk.first) + chunk.count > FrictionTable<Scalar>::mostBins)
      return wire::Code::noSuch;
    for (std::size_t k = 0; k < chunk.count; ++k) chunk.value[k] = static_cast<float>(values[chunk.first + k]);
    out(chunk);
    return wire::Code::ok;
  }

  wire::Code useFriction(const wire::FrictionUse& use, wire::Writer& out) {
    if (use.bins > FrictionTable<Scalar>::mostBins) return wire::Code::noSuch;
    const bool fine = finite(use.index_rad) && finite(use.blend_rad_per_s) && finite(use.cutoff_rad_per_s) &&
                      use.blend_rad_per_s >= 0.0f && use.cutoff_rad_per_s >= 0.0f;
    if (!fine || tableSum(use.bins) != use.checksum) return wire::Code::notAValue;
    written_.bins = use.bins;
    written_.index_rad = static_cast<Scalar>(use.index_rad);
    written_.blend_rad_per_s = static_cast<Scalar>(use.blend_rad_per_s);
    control_.compensate(written_, static_cast<Scalar>(use.cutoff_rad_per_s));
    used_ = use;
    out(use);
    return wire::Code::ok;
  }

  std::uint32_t tableSum(std::size_t bins) {
    wire::Crc32c crc;
    for (std::uint8_t k = 0; k < 4; ++k) {
      const Scalar* values = curve(static_cast<wire::FrictionCurve>(k));
      for (std::size_t bin = 0; bin < bins; ++bin) {
        std::uint8_t bytes[4];
        wire::Writer out(bytes);
        out(static_cast<float>(values[bin]));
        crc.add(out.written());
      }
    }
    return crc.value();
  }

  BoardHardware<Scalar> hardware_;
  Parameters<Scalar> parameters_;
  ControlTick<Scalar> control_;
  wire::FrameDecoder decoder_;
  Outbox<outboxBytes> outbox_;
  SampleBatch<Scalar> batch_;
  Burst<Scalar, burstBytes> burst_;
  FrictionTable<Scalar> written_;
  wire::FrictionUse used_;
  wire::Fault fault_;
  std::uint8_t body_[wire::mostBody] = {};
  std::uint32_t tick_ = 0, untilTick_ = 0, time_us_ = 0, restTime_ns_ = 0, period_ns_ = 0;
  std::uint32_t silentTicks_ = 0, leaseTicks_ = 0, dropped_ = 0, hash_ = 0;
  std::uint16_t latch_ = 0, unasked_ = 0, newest_ = 0, stop_ = 0;
};

}  // namespace breakaway::board
