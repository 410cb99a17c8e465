// The board's parameters and the dictionary that names them. Freestanding.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "control/tuning.h"
#include "firmware_link/board/board_hardware.h"
#include "firmware_link/wire/messages.h"

namespace breakaway::board {

/// A parameter's id; the names stand in parameterNames.
enum class Parameter : std::uint16_t {
  velocityKp,
  velocityKi,
  velocityKd,
  positionKp,
  positionKi,
  positionKd,
  observerCutoff,
  inertia,
  torqueConstant,
  currentLimit,
  velocityLimit,
  lease,
  velocityTrip,
  travelLimit,
  temperatureLimit,
  telemetryEvery,
  telemetryChannels,
  currentTrip,
  blockedFor,
  resistance,
  inductance,
  backEmfConstant,
  currentZero,
  velocityBandwidth,
  currentBandwidth,
  count
};
inline constexpr std::size_t parameterCount = static_cast<std::size_t>(Parameter::count);

struct ParameterForm {
  const char* name;
  wire::Format format;
  bool writable;
};
inline constexpr ParameterForm parameterForms[parameterCount] = {
    {"velocity_kp_A_s_per_rad", wire::Format::float32, true},
    {"velocity_ki_A_per_rad", wire::Format::float32, true},
    {"velocity_kd_A_s2_per_rad", wire::Format::float32, true},
    {"position_kp_A_per_rad", wire::Format::float32, true},
    {"position_ki_A_per_rad_s", wire::Format::float32, true},
    {"position_kd_A_s_per_rad", wire::Format::float32, true},
    {"observer_cutoff_rad_per_s", wire::Format::float32, true},
    {"nominal_inertia_kg_m2", wire::Format::float32, true},
    {"nominal_torque_constant_Nm_per_A", wire::Format::float32, true},
    {"current_limit_A", wire::Format::float32, true},
    {"velocity_limit_rad_per_s", wire::Format::float32, true},
    {"lease_s", wire::Format::float32, true},
    {"velocity_trip_rad_per_s", wire::Format::float32, true},
    {"travel_limit_rad", wire::Format::float32, true},        // 0: none
    {"temperature_limit_degC", wire::Format::float32, true},  // 0: none
    {"telemetry_every", wire::Format::uint32, true},          // 0: no telemetry
    {"telemetry_channels", wire::Format::uint32, true},
    {"current_trip_A", wire::Format::float32, false},
    {"blocked_for_s", wire::Format::float32, false},
    {"winding_resistance_ohm", wire::Format::float32, false},
    {"winding_inductance_H", wire::Format::float32, false},
    {"winding_back_emf_V_s_per_rad", wire::Format::float32, false},
    {"current_zero_A", wire::Format::float32, false},
    {"velocity_bandwidth_rad_per_s", wire::Format::float32, true},  // of the speed observer
    {"current_bandwidth_rad_per_s", wire::Format::float32, true},   // of the current loop
};

inline constexpr float longestLease_s = 0.25f;

/// Values within their limits, and the dictionary's entries: the parameters, then the telemetry channels.
template <typename Scalar>
class Parameters {
 public:
  static constexpr std::size_t entries = parameterCount + wire::channelCount;

  explicit Parameters(const BoardHardware<Scalar>& hardware) {
    const Scalar top = Scalar(1e9);
    for (std::size_t k = 0; k < parameterCount; ++k) most_[k] = static_cast<float>(top);
    const ServoSettings<Scalar>& s = hardware.start;
    begin(Parameter::velocityKp, s.gains.velocity_kp_A_s_per_rad);
    begin(Parameter::velocityKi, s.gains.velocity_ki_A_per_rad);
    begin(Parameter::velocityKd, s.gains.velocity_kd_A_s2_per_rad);
    begin(Parameter::positionKp, s.gains.position_kp_A_per_rad);
    begin(Parameter::positionKi, s.gains.position_ki_A_per_rad_s);
    begin(Parameter::positionKd, s.gains.position_kd_A_s_per_rad);
    begin(Parameter::observerCutoff, s.observer_cutoff_rad_per_s, Scalar(0.5) * hardware.loopRate_Hz);
    begin(Parameter::inertia, s.inertia_kg_m2);
    begin(Parameter::torqueConstant, s.torqueConstant_Nm_per_A);
    begin(Parameter::currentLimit, s.current_limit_A, hardware.mostCurrent_A);
    begin(Parameter::velocityLimit, s.gains.velocity_limit_rad_per_s, hardware.mostVelocity_rad_per_s);
    begin(Parameter::lease, Scalar(longestLease_s), Scalar(longestLease_s));
    least_[static_cast<std::size_t>(Parameter::lease)] = 0.02f;
    begin(Parameter::velocityTrip, hardware.watch.mostVelocity_rad_per_s, hardware.watch.mostVelocity_rad_per_s);
    begin(Parameter::temperatureLimit, hardware.hasTemperature ? Scalar(80) : Scalar(0), Scalar(120));
    begin(Parameter::currentTrip, hardware.watch.trip_A);
    begin(Parameter::blockedFor, hardware.watch.blockedFor_s);
    begin(Parameter::resistance, hardware.servo.current.resistance_ohm);
    begin(Parameter::inductance, hardware.servo.current.inductance_H);
    begin(Parameter::backEmfConstant, hardware.servo.current.backEmfConstant_V_s_per_rad);
    begin(Parameter::velocityBandwidth, hardware.servo.velocityBandwidth_rad_per_s,
          velocityBandwidthRange(hardware.servo.tick_s));
    begin(Parameter::currentBandwidth, hardware.servo.current.bandwidth_rad_per_s,
          currentBandwidthRange(hardware.servo.tick_s));
    beginWhole(Parameter::telemetryEvery, 0, 255);
    beginWhole(Parameter::telemetryChannels, wire::usualChannels, wire::allChannels);
    // Each channel's full range in 16 bits; what is known in whole steps is sent in whole steps.
    for (Scalar& perUnit : perUnit_) perUnit = Scalar(1);
    span(wire::Channel::current, Scalar(1.25) * hardware.sensorRange_A);
    span(wire::Channel::currentReference, Scalar(1.25) * hardware.sensorRange_A);
    span(wire::Channel::sensorCurrent, Scalar(1.25) * hardware.sensorRange_A);
    if (hardware.sensorStep_A > Scalar(0) && hardware.sensorStep_A * Scalar(32000) > hardware.sensorRange_A)
      perUnit_[static_cast<std::size_t>(wire::Channel::sensorCurrent)] = Scalar(1) / hardware.sensorStep_A;
    span(wire::Channel::temperature, Scalar(327));
    perUnit_[static_cast<std::size_t>(wire::Channel::supply)] = Scalar(16384) / hardware.supply_V;
    const bool fine = hardware.pwmSteps == 0 || hardware.pwmSteps > 32767;
    perUnit_[static_cast<std::size_t>(wire::Channel::duty)] = fine ? Scalar(32767) : Scalar(hardware.pwmSteps);
  }

  float operator[](Parameter which) const { return std::bit_cast<float>(word_[static_cast<std::size_t>(which)]); }
  std::uint32_t whole(Parameter which) const { return word_[static_cast<std::size_t>(which)]; }
  Scalar scalar(Parameter which) const { return static_cast<Scalar>((*this)[which]); }
  const Scalar (&perUnit() const)[wire::channelCount] { return perUnit_; }

  /// What would be accepted of `value`, in it. Errors: no such parameter, not a number.
  wire::Code judge(wire::ParameterValue& value) const {
    if (value.id >= parameterCount) return wire::Code::noSuch;
    const std::size_t k = value.id;
    if (!parameterForms[k].writable) {
      value.word = word_[k];
      return wire::Code::ok;
    }
    if (parameterForms[k].format == wire::Format::uint32) {
      if (value.word > static_cast<std::uint32_t>(most_[k])) value.word = static_cast<std::uint32_t>(most_[k]);
      return wire::Code::ok;
    }
    const float wanted = std::bit_cast<float>(value.word);
    if (!(wanted <= std::numeric_limits<float>::max() && wanted >= std::numeric_limits<float>::lowest()))
      return wire::Code::notAValue;
    value.word = std::bit_cast<std::uint32_t>(wanted < least_[k] ? least_[k] : wanted > most_[k] ? most_[k] : wanted);
    return wire::Code::ok;
  }
  /// Of a parameter that only the board itself changes.
  void show(Parameter which, Scalar value) {
    word_[static_cast<std::size_t>(which)] = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  }
  /// Takes what judge() left.
  void set(const wire::ParameterValue& judged) { word_[judged.id] = judged.word; }

  wire::DictionaryEntry entry(std::size_t index) const {
    wire::DictionaryEntry entry;
    const char* name = nullptr;
    if (index < parameterCount) {
      entry.kind = wire::DictionaryEntry::Kind::parameter;
      entry.format = parameterForms[index].format;
      entry.writable = parameterForms[index].writable ? 1 : 0;
      entry.id = static_cast<std::uint16_t>(index);
      entry.least = least_[index];
      entry.most = most_[index];
      name = parameterForms[index].name;
    } else {
      const std::size_t channel = index - parameterCount;
      entry.kind = wire::DictionaryEntry::Kind::channel;
      entry.format = wire::channelForms[channel].format;
      entry.id = static_cast<std::uint16_t>(channel);
      if (entry.format == wire::Format::int16) entry.scale = static_cast<float>(Scalar(1) / perUnit_[channel]);
      name = wire::channelForms[channel].name;
    }
    for (std::size_t k = 0; k < sizeof entry.name && name[k] != '\0'; ++k) entry.name[k] = name[k];
    return entry;
  }

  std::uint32_t hash() const {
    wire::Crc32c crc;
    for (std::size_t k = 0; k < entries; ++k) {
      std::uint8_t bytes[sizeof(wire::DictionaryEntry)];
      wire::Writer out(bytes);
      out(entry(k));
      crc.add(out.written());
    }
    return crc.value();
  }

  ServoSettings<Scalar> servo() const {
    ServoSettings<Scalar> s;
    s.gains = {scalar(Parameter::velocityKp),   scalar(Parameter::velocityKi), scalar(Parameter::velocityKd),
               scalar(Parameter::positionKp),   scalar(Parameter::positionKi), scalar(Parameter::positionKd),
               scalar(Parameter::velocityLimit)};
    s.observer_cutoff_rad_per_s = scalar(Parameter::observerCutoff);
    s.inertia_kg_m2 = scalar(Parameter::inertia);
    s.torqueConstant_Nm_per_A = scalar(Parameter::torqueConstant);
    s.current_limit_A = scalar(Parameter::currentLimit);
    return s;
  }

 private:
  void begin(Parameter which, Scalar value, Scalar most = Scalar(1e9)) {
    const auto k = static_cast<std::size_t>(which);
    word_[k] = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    most_[k] = static_cast<float>(most);
  }
  void begin(Parameter which, Scalar value, BandwidthRange<Scalar> range) {
    begin(which, value, range.most_rad_per_s);
    least_[static_cast<std::size_t>(which)] = static_cast<float>(range.least_rad_per_s);
  }
  void beginWhole(Parameter which, std::uint32_t value, std::uint32_t most) {
    const auto k = static_cast<std::size_t>(which);
    word_[k] = value;
    most_[k] = static_cast<float>(most);
  }
  void span(wire::Channel channel, Scalar full) { perUnit_[static_cast<std::size_t>(channel)] = Scalar(32767) / full; }

  std::uint32_t word_[parameterCount] = {};
  float least_[parameterCount] = {}, most_[parameterCount] = {};
  Scalar perUnit_[wire::channelCount] = {};
};

}  // namespace breakaway::board
