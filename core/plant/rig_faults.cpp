#include "plant/rig_faults.h"

#include <algorithm>
#include <utility>

#include "base/json_object.h"

namespace breakaway {

namespace {

constexpr std::pair<const char*, FaultKind> kinds[] = {
    {"link_loss", FaultKind::linkLoss},     {"over_current", FaultKind::overCurrent},
    {"blocked", FaultKind::blocked},        {"encoder_jump", FaultKind::encoderJump},
    {"index_lost", FaultKind::indexLost},   {"false_index", FaultKind::falseIndex},
    {"supply_drop", FaultKind::supplyDrop}, {"temperature_drift", FaultKind::temperatureDrift},
};

void readParameters(JsonObject& object, Axis axis, double unitPerRad, RigFault& fault) {
  const char* place = axis == Axis::rotary ? "angle_rad" : "position_m";
  switch (fault.kind) {
    case FaultKind::overCurrent:
      fault.current_A = object.number("current_A", 50.0);
      break;
    case FaultKind::blocked:
      fault.angle_rad = object.number(place, fault.angle_rad) / unitPerRad;
      break;
    case FaultKind::encoderJump:
      fault.counts = object.number("counts", 1000.0);
      break;
    case FaultKind::falseIndex:
      fault.angle_rad = object.number(place, unitPerRad) / unitPerRad;
      break;
    case FaultKind::supplyDrop:
      fault.part = object.number("part", 0.5, Allowed::nonNegative);
      if (fault.part > 1.0) object.fault("part", "is above 1, expected the part of the supply that is left");
      break;
    case FaultKind::temperatureDrift:
      fault.offset_A_per_s = object.number("offset_A_per_s", 0.0);
      fault.resistance_per_s = object.number("resistance_per_s", 0.0, Allowed::nonNegative);
      break;
    case FaultKind::linkLoss:
    case FaultKind::indexLost:
      break;
  }
}

RigFault readFault(JsonObject& object, Axis axis, double unitPerRad) {
  RigFault fault;
  const std::string name = object.text("fault");
  const auto* kind =
      std::find_if(std::begin(kinds), std::end(kinds), [&](const auto& one) { return one.first == name; });
  if (kind == std::end(kinds)) {
    std::string all;
    for (const auto& one : kinds) all += (all.empty() ? "" : ", ") + std::string(one.first);
    object.fault("fault", "is \"" + name + "\", expected one of: " + all);
    return fault;
  }
  fault.kind = kind->second;
  fault.start_s = object.number("start_s", 0.0, Allowed::nonNegative);
  fault.duration_s = object.number("duration_s", fault.duration_s, Allowed::positive);
  readParameters(object, axis, unitPerRad, fault);
  return fault;
}

}  // namespace

std::vector<RigFault> readFaults(JsonObject& root, Axis axis, double unitPerRad) {
  std::vector<RigFault> faults;
  for (JsonObject& object : root.objects("faults")) faults.push_back(readFault(object, axis, unitPerRad));
  return faults;
}

}  // namespace breakaway
