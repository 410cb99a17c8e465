#include "plant/rig_wiring.h"

#include <fmt/ranges.h>
#include <algorithm>

#include "base/json_object.h"

namespace breakaway {

namespace {

enum class Value { none, factor, place, torque };

struct KindName {
  const char* rotary;
  const char* linear;  ///< null: on a rotor only
  WiringKind kind;
  Value value;
};

constexpr KindName wiringKinds[] = {
    {"encoder_reversed", "encoder_reversed", WiringKind::encoderReversed, Value::none},
    {"encoder_dead", "encoder_dead", WiringKind::encoderDead, Value::none},
    {"counts_factor", "counts_factor", WiringKind::countsFactor, Value::factor},
    {"current_sensor_reversed", "current_sensor_reversed", WiringKind::currentSensorReversed, Value::none},
    {"current_sensor_dead", "current_sensor_dead", WiringKind::currentSensorDead, Value::none},
    {"bridge_reversed", "bridge_reversed", WiringKind::bridgeReversed, Value::none},
    {"lead_off", "lead_off", WiringKind::leadOff, Value::none},
    {"supply_reading_factor", "supply_reading_factor", WiringKind::supplyReadingFactor, Value::factor},
    {"index_inverted", "index_inverted", WiringKind::indexInverted, Value::none},
    {"stop_at_rad", "stop_at_m", WiringKind::stopAt, Value::place},
    {"load_Nm", "load_N", WiringKind::load, Value::torque},
    {"pendulum_Nm", nullptr, WiringKind::pendulum, Value::torque},
};

const char* nameOn(const KindName& kind, Axis axis) {
  return axis == Axis::rotary ? kind.rotary : kind.linear;
}

RigWiring readOne(JsonObject& object, Axis axis, double unitPerRad) {
  RigWiring wiring;
  const std::string name = object.text("fault");
  const auto* kind = std::find_if(std::begin(wiringKinds), std::end(wiringKinds), [&](const KindName& one) {
    return nameOn(one, axis) != nullptr && nameOn(one, axis) == name;
  });
  if (kind == std::end(wiringKinds)) {
    object.fault("fault", fmt::format("is \"{}\", expected one of: {}", name, fmt::join(wiringNames(axis), ", ")));
    return wiring;
  }
  wiring.kind = kind->kind;
  wiring.from_s = object.number("from_s", 0.0, Allowed::nonNegative);
  if (kind->value == Value::none) return wiring;
  wiring.value = object.number("value", kind->value == Value::factor ? Allowed::positive : Allowed::any);
  if (kind->value == Value::place) wiring.value /= unitPerRad;
  if (kind->value == Value::torque) wiring.value *= unitPerRad;
  return wiring;
}

}  // namespace

std::vector<RigWiring> readWiring(JsonObject& root, Axis axis, double unitPerRad) {
  std::vector<RigWiring> wiring;
  for (JsonObject& object : root.objects("wiring")) wiring.push_back(readOne(object, axis, unitPerRad));
  return wiring;
}

std::vector<std::string> wiringNames(Axis axis) {
  std::vector<std::string> names;
  for (const KindName& kind : wiringKinds) {
    if (const char* name = nameOn(kind, axis)) names.emplace_back(name);
  }
  return names;
}

}  // namespace breakaway
