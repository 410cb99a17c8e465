#include "base/json_object.h"
#include "export/gains.h"

namespace breakaway {

namespace {

constexpr const char* schema = "breakaway.tuning/1";

double estimateIn(JsonObject& motor, const char* name) {
  return motor.object(name).number("value", Allowed::positive);
}

}  // namespace

Result<TunedGains> readTuning(const std::string& path) {
  auto json = JsonObject::fromFile(path);
  if (!json) return json.error();
  // Another kind of file is said before the fields that it lacks.
  if (const std::string found = json->text("schema"); found != schema)
    json->fault("schema", "is \"" + found + "\", expected \"" + schema + "\"");
  if (auto ours = json->finishPart(); !ours) return ours.error();
  JsonObject motor = json->object("motor");
  if (motor.has("mass_kg")) motor.fault("mass_kg", "is a linear axis', expected a motor that turns");
  JsonObject velocity = json->object("controller"), position = json->object("position_controller"),
             loop = json->object("loop");
  TunedGains gains;
  gains.name = json->text("name", "");
  gains.velocityKp_A_s_per_rad = velocity.number("kp_A_s_per_rad", Allowed::positive);
  gains.velocityKi_A_per_rad = velocity.number("ki_A_per_rad");
  gains.velocityKd_A_s2_per_rad = velocity.number("kd_A_s2_per_rad");
  gains.cutoff_rad_per_s = velocity.number("observer_cutoff_rad_per_s");
  gains.currentLimit_A = velocity.number("current_limit_A");
  gains.positionKp_A_per_rad = position.number("kp_A_per_rad", Allowed::positive);
  gains.positionKi_A_per_rad_s = position.number("ki_A_per_rad_s");
  gains.positionKd_A_s_per_rad = position.number("kd_A_s_per_rad", Allowed::positive);
  gains.inertia_kg_m2 = estimateIn(motor, "inertia_kg_m2");
  gains.torqueConstant_Nm_per_A = estimateIn(motor, "torque_constant_Nm_per_A");
  gains.resistance_ohm = motor.optionalNumber("resistance_ohm", Allowed::positive);
  gains.inductance_H = motor.optionalNumber("inductance_H", Allowed::positive);
  gains.speedFilter_rad_per_s = loop.number("velocity_bandwidth_rad_per_s", Allowed::positive);
  gains.currentBandwidth_rad_per_s = loop.number("current_bandwidth_rad_per_s", Allowed::positive);
  if (auto read = json->finishPart(); !read) return read.error();
  return gains;
}

}  // namespace breakaway
