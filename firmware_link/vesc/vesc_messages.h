// What is said to a VESC and what it answers; big-endian, numbers scaled to integers. Payloads here, without frames.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/message.h"

namespace breakaway {

using VescPayload = std::vector<std::uint8_t>;

enum class VescMessage : std::uint8_t {
  firmwareVersion = 0,
  values = 4,
  setDuty = 5,
  setCurrent = 6,
  setCurrentBrake = 7,
  setSpeed = 8,
  setPosition = 9,
  alive = 30,
  selectedValues = 50
};

VescPayload vescRequest(VescMessage message);
/// Values that don't fit the wire are held at its end; one that isn't finite becomes 0, which releases the motor.
VescPayload vescSetDuty(double duty);
VescPayload vescSetCurrent(double current_A);
VescPayload vescSetSpeed(double electricalSpeed_rpm);
VescPayload vescSetPosition(double angle_deg);

struct VescVersion {
  int major = 0, minor = 0;
  std::string hardware;                     ///< printable part of its name
  std::array<std::uint8_t, 12> identity{};  ///< of the processor; zeros when it says none
};

/// The values that this house asks for, by their bit in the mask of selectedValues.
namespace vescField {
constexpr std::uint32_t bridgeTemperature = 1u << 0, motorTemperature = 1u << 1, motorCurrent = 1u << 2, iq = 1u << 5,
                        duty = 1u << 6, speed = 1u << 7, supply = 1u << 8, tachometer = 1u << 13, fault = 1u << 15,
                        position = 1u << 16;
constexpr std::uint32_t wanted =
    bridgeTemperature | motorTemperature | iq | duty | speed | supply | tachometer | fault | position;
}  // namespace vescField

VescPayload vescSelectValues(std::uint32_t fields);

struct VescValues {
  std::uint32_t fields = 0;  ///< which of them came, as in vescField
  double bridge_degC = 0.0, motor_degC = 0.0;
  double motorCurrent_A = 0.0;  ///< magnitude along the drive, mean since the last reading
  double iq_A = 0.0;            ///< makes torque, positive towards growing angle, mean since the last reading
  double duty = 0.0;
  double electricalSpeed_rpm = 0.0;
  double supply_V = 0.0;
  std::int32_t tachometer = 0;  ///< six steps per electrical turn
  int fault = 0;
  double position_deg = 0.0;  ///< of the encoder, 0 to 360

  bool has(std::uint32_t all) const { return (fields & all) == all; }
};

/// Nothing when the payload is another message or too short.
std::optional<VescVersion> readVescVersion(std::span<const std::uint8_t> payload);
/// Answers to `values` and to `selectedValues`. The former may end early: what came is in `fields`.
std::optional<VescValues> readVescValues(std::span<const std::uint8_t> payload);

/// A fault code in words; empty for 0, no fault.
Message vescFaultWords(int fault);

}  // namespace breakaway
