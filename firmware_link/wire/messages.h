// The messages: what a frame's body holds, by the frame's type. Freestanding.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware_link/wire/bytes.h"
#include "firmware_link/wire/compensation_messages.h"
#include "firmware_link/wire/telemetry.h"

namespace breakaway::wire {

/// The host asks with a type below 0x40. The board answers with the type + 0x80 and the same sequence; the answer's
/// body is a Code and then, if that is ok, what the struct says. From 0xC0 on the board speaks unasked. A type that one
/// doesn't know is skipped; to a request the board answers Code::unknown.
enum class Type : std::uint8_t {
  hello = 0x01,            ///< nothing → Hello
  dictionary = 0x02,       ///< DictionaryAsked → DictionaryPage
  readParameters = 0x03,   ///< ParameterList, values ignored → ParameterList
  writeParameters = 0x04,  ///< ParameterList → the same with the accepted values; all take effect together
  command = 0x05,          ///< MotorCommand → the same as accepted
  heartbeat = 0x06,        ///< Heartbeat → Alive
  stop = 0x07,             ///< nothing → Alive; windings open at once, latched
  fault = 0x08,            ///< nothing → Fault, the last one
  writeFriction = 0x09,    ///< FrictionChunk → the same; fills a table that isn't used yet
  readFriction = 0x0A,     ///< FrictionChunk, values ignored → the same with the values
  useFriction = 0x0B,      ///< FrictionUse → the same; the table that was written takes effect
  startCapture = 0x0C,     ///< Capture → the same as accepted
  readCapture = 0x0D,      ///< CaptureAsked → CapturePage
  startHoming = 0x0E,      ///< StartHoming → the same; the board runs this leg by itself
  startBreakaway = 0x0F,   ///< StartBreakaway → the same
  startSpeed = 0x10,       ///< StartSpeed → the same
  frictionUsed = 0x11,     ///< nothing → FrictionUse, of the table that is used
  writeBridge = 0x12,      ///< BridgeCurve → the same; takes effect at once
  readBridge = 0x13,       ///< nothing → BridgeCurve
  useStatic = 0x14,        ///< StaticFrictionUse → the same; as useFriction, with static friction
  staticUsed = 0x15,       ///< nothing → StaticFrictionUse, of the table that is used
  serialNumber = 0x16,     ///< nothing → SerialNumber
  telemetry = 0xC0,        ///< BatchHeader, then the samples
  faultHappened = 0xC1     ///< Fault
};
inline constexpr std::uint8_t beyondRequests = 0x40;
inline constexpr std::uint8_t answerBit = 0x80;
inline constexpr std::uint8_t unasked = 0xC0;

enum class Code : std::uint8_t {
  ok = 0,
  unknown = 1,    ///< the request's type
  malformed = 2,  ///< the body is too short, or a list too long
  notAValue = 3,  ///< not finite, or nothing of its kind
  latched = 4,    ///< something stopped the motor since; the command's latch is not the board's
  notPossible = 5,
  noSuch = 6,   ///< parameter, curve, place
  outdated = 7  ///< a newer request that changes something came before it
};

/// Who the board is, and of which powering up.
struct Hello {
  static constexpr std::size_t deviceLength = 64, firmwareLength = 24;
  enum Ability : std::uint16_t {
    hasIndex = 1,
    simulated = 2,
    grantedPace = 4,  ///< its clock runs only as far as heartbeats grant
    capture = 8,
    friction = 16,
    legs = 32,  ///< runs them by itself; see leg_messages.h
    temperature = 64,
    staticFriction = 128,
    bridgeCurve = 256,
    serialNumber = 512  ///< can be asked for it
  };
  std::uint16_t abilities = 0;
  std::uint16_t boot = 0;   ///< another number after each powering up
  std::uint16_t latch = 0;  ///< see MotorCommand
  float loopRate_Hz = 0;
  float supply_V = 0;
  std::uint32_t countsPerRev = 0;
  std::uint16_t entries = 0;         ///< of the dictionary
  std::uint32_t dictionaryHash = 0;  ///< CRC-32C over the bytes of all entries in order
  std::uint16_t frictionBins = 0;    ///< most that a table can have
  char device[deviceLength] = {};    ///< UTF-8, filled up with zeros
  char firmware[firmwareLength] = {};

  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.abilities), io(s.boot), io(s.latch), io(s.loopRate_Hz), io(s.supply_V), io(s.countsPerRev), io(s.entries);
    io(s.dictionaryHash), io(s.frictionBins), io(s.device), io(s.firmware);
  }
};

/// Which one of its model the board is, by whatever it is known by: of its processor, of its maker.
struct SerialNumber {
  static constexpr std::size_t length = 40;
  char text[length] = {};  ///< UTF-8, filled up with zeros

  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.text);
  }
};

struct DictionaryAsked {
  std::uint16_t first = 0;
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.first);
  }
};

/// A parameter, or a telemetry channel.
struct DictionaryEntry {
  static constexpr std::size_t nameLength = 36;
  enum class Kind : std::uint8_t { parameter = 1, channel = 2 };
  Kind kind = Kind::parameter;
  Format format = Format::float32;
  std::uint8_t writable = 0;
  std::uint16_t id = 0;        ///< of a channel: its bit in the schema
  float scale = 1;             ///< of a channel of format int16
  float least = 0, most = 0;   ///< that is accepted; what lies beyond is held there
  char name[nameLength] = {};  ///< with its unit at the end, filled up with zeros

  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.kind), io(s.format), io(s.writable), io(s.id), io(s.scale), io(s.least), io(s.most), io(s.name);
  }
};

struct DictionaryPage {
  static constexpr std::size_t mostEntries = 9;
  std::uint16_t first = 0;
  std::uint8_t count = 0;
  DictionaryEntry entry[mostEntries];
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.first), io.list(s.count, s.entry);
  }
};

/// A parameter's value: a float's bits, or a whole number, as the dictionary says.
struct ParameterValue {
  std::uint16_t id = 0;
  std::uint32_t word = 0;
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.id), io(s.word);
  }
};

struct ParameterList {
  static constexpr std::size_t mostValues = 64;
  std::uint8_t count = 0;
  ParameterValue value[mostValues];
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io.list(s.count, s.value);
  }
};

/// Holds until the next one. A mode other than off is refused (Code::latched) unless `latch` is the board's, which
/// changes whenever something stops the motor, a STOP, a fault, a lease that ran out or a new powering up: what was
/// sent before the host knew of it can't start the motor again, and neither can a connection made anew.
struct MotorCommand {
  enum class Mode : std::uint8_t { off = 0, voltage = 1, current = 2, velocity = 3, position = 4 };
  enum Flag : std::uint8_t {
    zeroCurrentSensor = 1,  ///< with mode off: average the sensor while this is set, take the mean as its zero
    watched = 2,            ///< part of a procedure: faults latch with open windings too
    fresh = 4               ///< begins something new: the last fault is done with, and travel is counted from here
  };
  Mode mode = Mode::off;
  std::uint8_t flags = 0;
  std::uint16_t latch = 0;
  float target = 0;               ///< V, A, rad/s; a position is targetCounts, and this many rad further
  std::int32_t targetCounts = 0;  ///< whole counts of a position
  float current_limit_A = 0;      ///< 0: the parameter's own

  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.mode), io(s.flags), io(s.latch), io(s.target), io(s.targetCounts), io(s.current_limit_A);
  }
  bool operator==(const MotorCommand&) const = default;
};

/// Renews the lease; without one for that long the board stops the motor. Where the pace is granted it names the tick
/// up to which the clock may run, at most 200 ms ahead, and the clock stops there: the lease can't run out meanwhile.
struct Heartbeat {
  std::uint32_t untilTick = 0;
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.untilTick);
  }
};

enum class FaultCode : std::uint8_t {
  none = 0,
  overCurrent = 1,
  openSensor = 2,
  supplyLow = 3,
  encoderJump = 4,
  blocked = 5,
  overSpeed = 6,
  travel = 7,
  overTemperature = 8,
  leaseExpired = 9,
  supplyHigh = 10,
  contradiction = 11,
  windingHeat = 12
};

struct Alive {
  std::uint16_t boot = 0;
  std::uint16_t latch = 0;
  MotorCommand::Mode mode = MotorCommand::Mode::off;
  FaultCode fault = FaultCode::none;  ///< the last one that no fresh command has followed
  std::uint32_t tick = 0;             ///< the next one to be run
  std::uint32_t time_us = 0;
  std::uint32_t untilTick = 0;  ///< accepted
  std::uint32_t dropped = 0;    ///< as in BatchHeader

  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.boot), io(s.latch), io(s.mode), io(s.fault), io(s.tick), io(s.time_us), io(s.untilTick), io(s.dropped);
  }
};

/// Why the board opened the windings, with the figures of that tick.
struct Fault {
  FaultCode code = FaultCode::none;
  std::uint16_t latch = 0;  ///< that it led to
  std::uint32_t tick = 0;
  float current_A = 0, limit_A = 0, supply_V = 0, jump_rad = 0, velocity_rad_per_s = 0, temperature_degC = 0;
  float voltage_V = 0, meanVelocity_rad_per_s = 0;    ///< on the winding; over the last 20 ms
  float resistance_ohm = 0, backEmf_V_s_per_rad = 0;  ///< that the board believes; 0: it foretells nothing

  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.code), io(s.latch), io(s.tick), io(s.current_A), io(s.limit_A), io(s.supply_V), io(s.jump_rad);
    io(s.velocity_rad_per_s), io(s.temperature_degC);
    io(s.voltage_V), io(s.meanVelocity_rad_per_s), io(s.resistance_ohm), io(s.backEmf_V_s_per_rad);
  }
};

/// Records on the board at full rate, to be read afterwards.
struct Capture {
  enum class Trigger : std::uint8_t { now = 0, nextCommand = 1 };
  Trigger trigger = Trigger::now;
  std::uint8_t every = 1;
  std::uint16_t schema = 0;
  std::uint16_t samples = 0;  ///< accepted: as many as there is room for
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.trigger), io(s.every), io(s.schema), io(s.samples);
  }
};

struct CaptureAsked {
  std::uint16_t first = 0;
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.first);
  }
};

/// Followed by a batch (BatchHeader and samples) from `first` on. `taken` tells how far the capture has come.
struct CapturePage {
  std::uint16_t taken = 0, samples = 0, first = 0;
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.taken), io(s.samples), io(s.first);
  }
};

/// Whether the body holds all of the message; what follows it belongs to a later version and is skipped.
template <typename Message>
bool readMessage(std::span<const std::uint8_t> body, Message& message) {
  Reader in(body);
  in(message);
  return in.ok();
}

}  // namespace breakaway::wire
