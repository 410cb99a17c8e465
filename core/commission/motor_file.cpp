#include "commission/motor_file.h"

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/json_object.h"
#include "base/made.h"

namespace breakaway {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* motorSchema = "breakaway.motor/1";

struct MotorField {
  const char* name;
  Estimate IdentifiedMotor::*estimate;
};
constexpr MotorField motorFields[] = {
    {"torque_constant_Nm_per_A", &IdentifiedMotor::torqueConstant_Nm_per_A},
    {"back_emf_constant_V_s_per_rad", &IdentifiedMotor::backEmfConstant_V_s_per_rad},
    {"resistance_ohm", &IdentifiedMotor::resistance_ohm},
    {"inductance_H", &IdentifiedMotor::inductance_H},
    {"dead_zone_V", &IdentifiedMotor::deadZone_V},
    {"inertia_kg_m2", &IdentifiedMotor::inertia_kg_m2},
    {"shown_inertia_kg_m2", &IdentifiedMotor::shownInertia_kg_m2},
    {"ramp_inertia_kg_m2", &IdentifiedMotor::rampInertia_kg_m2},
    {"reversal_inertia_kg_m2", &IdentifiedMotor::reversalInertia_kg_m2},
    {"current_gain", &IdentifiedMotor::currentGain},
    {"coulomb_Nm", &IdentifiedMotor::coulomb_Nm},
    {"viscous_Nm_s_per_rad", &IdentifiedMotor::viscous_Nm_s_per_rad},
};

Json pair(const Estimate& estimate) {
  return {{"value", estimate.value}, {"std", estimate.standardError}};
}

Estimate pairIn(JsonObject object) {
  return {object.number("value"), object.number("std", Allowed::nonNegative)};
}

Json motorJson(const IdentifiedMotor& motor, Axis axis) {
  Json json{{"torque_constant_trusted", motor.torqueConstantTrusted}};
  for (const MotorField& field : motorFields) json[nameOn(axis, field.name)] = pair(motor.*field.estimate);
  json["duty_curve"] = Json::array();
  for (const DutyPoint& point : motor.dutyCurve.points)
    json["duty_curve"].push_back({point.input, point.output.value, point.output.standardError});
  json["gauge"] = motor.gauge;
  return json;
}

}  // namespace

std::string motorText(const IdentifiedMotor& motor) {
  return motorJson(motor, Axis::rotary).dump();
}

IdentifiedMotor motorIn(JsonObject& object, Axis axis) {
  IdentifiedMotor motor;
  motor.torqueConstantTrusted = object.flag("torque_constant_trusted", false);
  for (const MotorField& field : motorFields) motor.*field.estimate = pairIn(object.object(nameOn(axis, field.name)));
  for (const auto& row : object.rows("duty_curve", 3)) motor.dutyCurve.points.push_back({row[0], {row[1], row[2]}});
  if (!motor.dutyCurve.rises()) object.fault("duty_curve", "doesn't rise, expected a rising one");
  motor.gauge = Message(object.text("gauge", ""));
  return motor;
}

Result<void> writeMotor(const MotorRecord& record, const std::string& path) {
  Json json{{"schema", motorSchema}, {"device", record.device}};
  if (record.axis == Axis::linear) json["axis"] = "linear";
  json[nameOn(record.axis, "added_inertia_kg_m2")] = pair(record.addedInertia_kg_m2);
  json["motor"] = motorJson(record.motor, record.axis);
  return writeFile(path, withMade(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"));
}

Result<MotorRecord> readMotor(const std::string& path) {
  auto root = JsonObject::fromFile(path);
  if (!root) return root.error();
  const std::string found = root->text("schema");
  if (found != motorSchema) root->fault("schema", "is \"" + found + "\", expected \"" + motorSchema + "\"");
  MotorRecord record;
  record.device = root->text("device");
  const std::string axis = root->text("axis", "rotary");
  if (axis != "rotary" && axis != "linear") root->fault("axis", "is \"" + axis + "\", expected rotary or linear");
  record.axis = axis == "linear" ? Axis::linear : Axis::rotary;
  record.addedInertia_kg_m2 = pairIn(root->object(nameOn(record.axis, "added_inertia_kg_m2")));
  JsonObject motor = root->object("motor");
  record.motor = motorIn(motor, record.axis);
  if (const auto done = root->finish(); !done) return done.error();
  return record;
}

}  // namespace breakaway
