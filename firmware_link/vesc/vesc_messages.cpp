#include "firmware_link/vesc/vesc_messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/marked_text.h"

namespace breakaway {

namespace {

void put(VescPayload& payload, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) payload.push_back(static_cast<std::uint8_t>(value >> shift & 0xff));
}

VescPayload scaled(VescMessage message, double value, double scale) {
  VescPayload payload = vescRequest(message);
  const double most = std::numeric_limits<std::int32_t>::max();
  const double held = std::isfinite(value) ? std::clamp(std::round(value * scale), -most, most) : 0.0;
  put(payload, static_cast<std::uint32_t>(static_cast<std::int32_t>(held)));
  return payload;
}

/// Takes numbers off the front of a payload; after its end `good` is false and all is zero.
class Taker {
 public:
  explicit Taker(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool good() const { return good_; }
  bool enough(size_t count) const { return bytes_.size() >= count; }
  std::uint32_t unsignedOf(size_t count) {
    std::uint32_t value = 0;
    if (!enough(count)) {
      good_ = false;
      return 0;
    }
    for (size_t k = 0; k < count; ++k) value = value << 8 | bytes_[k];
    bytes_ = bytes_.subspan(count);
    return value;
  }
  std::span<const std::uint8_t> rest() const { return bytes_; }

 private:
  std::span<const std::uint8_t> bytes_;
  bool good_ = true;
};

/// A field's bytes; where its value goes, and what of it the wire holds one of. Null: it is passed over.
struct Field {
  std::uint8_t bytes;
  double VescValues::*value = nullptr;
  double perUnit = 1.0;
};

/// In the order of the mask's bits.
constexpr std::array<Field, 22> fieldsInOrder{{{2, &VescValues::bridge_degC, 10.0},
                                               {2, &VescValues::motor_degC, 10.0},
                                               {4, &VescValues::motorCurrent_A, 100.0},
                                               {4},
                                               {4},
                                               {4, &VescValues::iq_A, 100.0},
                                               {2, &VescValues::duty, 1000.0},
                                               {4, &VescValues::electricalSpeed_rpm},
                                               {2, &VescValues::supply_V, 10.0},
                                               {4},
                                               {4},
                                               {4},
                                               {4},
                                               {4},
                                               {4},
                                               {1},
                                               {4, &VescValues::position_deg, 1e6},
                                               {1},
                                               {6},
                                               {4},
                                               {4},
                                               {1}}};

void takeField(std::uint32_t mask, const Field& field, std::uint32_t raw, VescValues& values) {
  const auto number = field.bytes == 2 ? static_cast<std::int16_t>(raw) : static_cast<std::int32_t>(raw);
  if (field.value != nullptr) values.*field.value = number / field.perUnit;
  if (mask == vescField::tachometer) values.tachometer = number;
  if (mask == vescField::fault) values.fault = number;
  values.fields |= mask;
}

}  // namespace

VescPayload vescRequest(VescMessage message) {
  return {static_cast<std::uint8_t>(message)};
}

VescPayload vescSetDuty(double duty) {
  return scaled(VescMessage::setDuty, duty, 1e5);
}

VescPayload vescSetCurrent(double current_A) {
  return scaled(VescMessage::setCurrent, current_A, 1e3);
}

VescPayload vescSetSpeed(double electricalSpeed_rpm) {
  return scaled(VescMessage::setSpeed, electricalSpeed_rpm, 1.0);
}

VescPayload vescSetPosition(double angle_deg) {
  return scaled(VescMessage::setPosition, angle_deg, 1e6);
}

VescPayload vescSelectValues(std::uint32_t fields) {
  VescPayload payload = vescRequest(VescMessage::selectedValues);
  put(payload, fields);
  return payload;
}

std::optional<VescVersion> readVescVersion(std::span<const std::uint8_t> payload) {
  Taker taker(payload);
  const bool right = taker.unsignedOf(1) == static_cast<std::uint32_t>(VescMessage::firmwareVersion);
  VescVersion version;
  version.major = static_cast<int>(taker.unsignedOf(1));
  version.minor = static_cast<int>(taker.unsignedOf(1));
  if (!taker.good() || !right) return {};
  std::span<const std::uint8_t> rest = taker.rest();
  const auto nameEnd = std::find(rest.begin(), rest.end(), 0);
  for (auto it = rest.begin(); it != nameEnd; ++it) {
    if (*it >= 0x20 && *it < 0x7f) version.hardware.push_back(static_cast<char>(*it));
  }
  rest = rest.subspan(static_cast<size_t>(nameEnd - rest.begin()));
  if (rest.size() > version.identity.size())
    std::copy_n(rest.begin() + 1, version.identity.size(), version.identity.begin());
  return version;
}

std::optional<VescValues> readVescValues(std::span<const std::uint8_t> payload) {
  Taker taker(payload);
  const auto message = static_cast<VescMessage>(taker.unsignedOf(1));
  const bool selected = message == VescMessage::selectedValues;
  if (!taker.good() || (!selected && message != VescMessage::values)) return {};
  const std::uint32_t coming = selected ? taker.unsignedOf(4) : (1u << fieldsInOrder.size()) - 1;
  if (coming >> fieldsInOrder.size() != 0) return {};  // fields of a length that isn't known here
  VescValues values;
  for (size_t bit = 0; bit < fieldsInOrder.size(); ++bit) {
    const Field& field = fieldsInOrder[bit];
    if ((coming & 1u << bit) == 0) continue;
    if (!taker.enough(field.bytes)) {
      if (selected) return {};
      break;
    }
    takeField(1u << bit, field, taker.unsignedOf(field.bytes), values);
  }
  return taker.good() ? std::optional(values) : std::nullopt;
}

Message vescFaultWords(int fault) {
  static constexpr std::array<MessageText<0>, 34> words{
      "",
      marked("the supply voltage is too high; a braking motor may feed it, check the supply"),
      marked("the supply voltage is too low; check the supply and its current limit"),
      marked("the gate driver objects; check the bridge for a short"),
      marked("over-current; check motor leads and bridge for a short, and the motor's current limit"),
      marked("the bridge is too hot; let it cool"),
      marked("the motor is too hot; let it cool"),
      marked("the gate driver's supply is too high"),
      marked("the gate driver's supply is too low"),
      marked("the processor's supply is too low"),
      marked("its watchdog has restarted it"),
      marked("the encoder's SPI bus is disturbed; check encoder cable and shield"),
      marked("the encoder's sine and cosine are too weak"),
      marked("the encoder's sine and cosine are too strong"),
      marked("its flash memory is damaged"),
      marked("the first current sensor's offset is too large"),
      marked("the second current sensor's offset is too large"),
      marked("the third current sensor's offset is too large"),
      marked("the phase currents don't add up to zero; check the current sensors"),
      marked("the brake resistor is too hot or fails"),
      marked("the resolver has lost track"),
      marked("the resolver's signal is weak"),
      marked("the resolver has lost its signal"),
      marked("its flash memory holds a damaged application's settings"),
      marked("its flash memory holds a damaged motor's settings"),
      marked("the encoder's magnet is missing"),
      marked("the encoder's magnet is too strong"),
      marked("the phase filter fails"),
      marked("the encoder fails"),
      marked("its low-voltage output fails; check what it feeds for a short"),
      marked(
          "the encoder slips: its angle has left the one that the windings' voltage tells; check coupling and magnet"),
      marked("the motor turns forwards faster than its speed limit"),
      marked("the motor turns backwards faster than its speed limit"),
      marked("the motor turns faster than the higher of its two speed limits")};
  if (fault == 0) return {};
  if (fault > 0 && fault < static_cast<int>(words.size())) return message(words[static_cast<size_t>(fault)]);
  return message("fault {}, which is not known here; its maker's tool names it", fault);
}

}  // namespace breakaway
