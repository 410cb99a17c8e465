#include "motor/bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/json_object.h"
#include "base/made.h"
#include "base/numbers.h"
#include "recording/columns.h"

namespace breakaway {

namespace {

constexpr const char* schema = "breakaway.bench/1";

constexpr MotorNames rotaryNames{"torque_constant_Nm_per_A",
                                 "back_emf_constant_V_s_per_rad",
                                 "resistance_ohm",
                                 "inductance_H",
                                 "inertia_kg_m2",
                                 "viscous_Nm_s_per_rad",
                                 "coulomb_Nm",
                                 "counts_per_rev"};
constexpr MotorNames linearNames{"force_constant_N_per_A",
                                 "back_emf_constant_V_s_per_m",
                                 "resistance_ohm",
                                 "inductance_H",
                                 "mass_kg",
                                 "viscous_N_s_per_m",
                                 "coulomb_N",
                                 "counts_per_m"};

struct InputQuantity {
  Quantity quantity;
  DriveInput input;
};
constexpr std::array<InputQuantity, 4> inputs{{{Quantity::voltage, DriveInput::voltage},
                                               {Quantity::duty, DriveInput::duty},
                                               {Quantity::current, DriveInput::current},
                                               {Quantity::torque, DriveInput::torque}}};

struct GainNames {
  ControlMode mode;
  const char *name, *kp, *ki, *kd;
};
constexpr std::array<GainNames, 3> gainNames{
    {{ControlMode::openLoop, "open_loop", "", "", ""},
     {ControlMode::velocity, "velocity", "kp_A_s_per_rad", "ki_A_per_rad", "kd_A_s2_per_rad"},
     {ControlMode::position, "position", "kp_A_per_rad", "ki_A_per_rad_s", "kd_A_s_per_rad"}}};

void readMotor(JsonObject motor, const MotorNames& names, MotorBelief& belief) {
  belief.torqueConstant = motor.optionalNumber(names.torqueConstant, Allowed::positive);
  belief.backEmfConstant = motor.optionalNumber(names.backEmfConstant, Allowed::positive);
  belief.resistance_ohm = motor.optionalNumber(names.resistance, Allowed::positive);
  belief.inductance_H = motor.optionalNumber(names.inductance, Allowed::positive);
  belief.inertia = motor.optionalNumber(names.inertia, Allowed::positive);
  belief.viscous = motor.optionalNumber(names.viscous, Allowed::nonNegative);
  belief.coulomb = motor.optionalNumber(names.coulomb, Allowed::nonNegative);
}

constexpr const char* ofController = "controller.";

/// Which of a law's values may be trusted, as `trusted` names them.
std::vector<std::string> trustable(const ServoNames& law) {
  std::vector<std::string> names;
  for (const char* name : {law.kp, law.kd, law.limit, servoDelayName})
    names.push_back(std::string(ofController) + name);
  return names;
}

void readTrusted(JsonObject& root, const Bench& bench, std::set<std::string>& trusted) {
  const MotorNames& names = motorNames(bench.axis);
  std::vector<std::string> allowed{names.torqueConstant, names.backEmfConstant, names.resistance, names.inductance,
                                   names.inertia,        names.viscous,         names.coulomb};
  if (bench.servo) {
    for (std::string& name : trustable(servoNames(bench.input, bench.axis))) allowed.push_back(std::move(name));
  }
  for (const std::string& name : root.texts("trusted")) {
    if (std::find(allowed.begin(), allowed.end(), name) == allowed.end()) {
      const auto suggestion = nearestName(name, allowed);
      root.fault("trusted", "names \"" + name + "\", which is no motor field" +
                                (suggestion ? ", did you mean " + *suggestion + "?" : std::string()));
    }
    trusted.insert(name);
  }
}

void readController(JsonObject object, BenchController& controller) {
  const std::string mode = object.text("mode", "open_loop");
  const auto it =
      std::find_if(gainNames.begin(), gainNames.end(), [&](const GainNames& one) { return mode == one.name; });
  if (it == gainNames.end()) {
    object.fault("mode", "is \"" + mode + "\", expected open_loop, velocity or position");
    return;
  }
  controller.mode = it->mode;
  if (it->mode != ControlMode::openLoop) {
    controller.kp = object.number(it->kp, 0.0);
    controller.ki = object.number(it->ki, 0.0);
    controller.kd = object.number(it->kd, 0.0);
  } else {
    object.numbers();  // gains of an open loop mean nothing; whatever they are called, they do no harm
  }
  controller.observerCutoff_rad_per_s = object.number("observer_cutoff_rad_per_s", 0.0, Allowed::nonNegative);
  controller.nominalInertia = object.number("nominal_inertia_kg_m2", 0.0, Allowed::nonNegative);
  controller.nominalTorqueConstant = object.number("nominal_torque_constant_Nm_per_A", 0.0, Allowed::nonNegative);
  controller.currentLimit_A = object.number("current_limit_A", 0.0, Allowed::nonNegative);
}

/// A servo's law, and what it gives out by the unit of its gains or limit; torque where neither is there.
void readServo(JsonObject object, Bench& bench) {
  const std::string mode = object.text("mode", "position");
  if (mode != "position")
    object.fault("mode", "is \"" + mode + "\", expected position: " +
                             columnName(Quantity::positionReference, bench.axis) + " drives a position loop");
  ServoLaw law;
  bench.input = DriveInput::torque;
  std::string first;
  for (const ServoNames& names : servoNamesOf(bench.axis)) {
    for (const auto& [name, value] : {std::pair{names.kp, &law.kp}, {names.kd, &law.kd}, {names.limit, &law.limit}}) {
      if (!object.has(name)) continue;
      *value = object.number(name, value == &law.kd ? Allowed::nonNegative : Allowed::positive);
      if (!first.empty() && bench.input != names.output)
        object.fault(name, "counts in another quantity than " + first + ", expected one for all of the controller");
      bench.input = names.output;
      first = name;
    }
  }
  law.rate_Hz = object.optionalNumber("rate_Hz", Allowed::positive);
  law.delay_s = object.optionalNumber(servoDelayName, Allowed::any);
  bench.servo = law;
}

Result<Bench> readBench(JsonObject root) {
  Bench bench;
  const std::string found = root.text("schema");
  if (found != schema) root.fault("schema", "is \"" + found + "\", expected \"" + schema + "\"");
  bench.name = root.text("name", "");
  bench.motorSerial = root.text("motor_serial", "");
  const std::string axis = root.text("axis", "rotary");
  if (axis != "rotary" && axis != "linear") root.fault("axis", "is \"" + axis + "\", expected rotary or linear");
  bench.axis = axis == "linear" ? Axis::linear : Axis::rotary;
  const MotorNames& names = motorNames(bench.axis);
  const std::string reference = columnName(Quantity::positionReference, bench.axis);

  JsonObject encoder = root.object("encoder", false);
  bench.countsPerUnit = encoder.optionalNumber(names.counts, Allowed::positive);

  JsonObject drive = root.object("drive");
  const std::string input = drive.text("input");
  const auto known = driveInputNamed(input, bench.axis);
  if (input == reference) {
    readServo(root.object("controller", false), bench);
  } else if (!known) {
    drive.fault("input", "is \"" + input + "\", expected voltage_V, duty, current_A, " +
                             columnName(Quantity::torque, bench.axis) + " or " + reference);
  } else {
    bench.input = *known;
  }
  bench.supply_V = drive.optionalNumber("supply_V", Allowed::positive);
  bench.currentGainInterval = drive.optionalNumber("current_gain_interval", Allowed::positive);
  if (bench.currentGainInterval.value_or(0.0) > 0.5)
    drive.fault("current_gain_interval", "is above 0.5, expected a small relative half width");
  for (const auto& row : drive.rows("duty_curve", 3)) bench.dutyCurve.points.push_back({row[0], {row[1], row[2]}});
  if (!bench.dutyCurve.rises())
    drive.fault(
        "duty_curve",
        "doesn't rise, expected [input duty, output duty, standard error] from an output of 0 on, in rising order");

  JsonObject motor = root.object("motor", false);
  readMotor(motor, names, bench.motor);
  bench.polePairs = motor.optionalNumber("pole_pairs", Allowed::positive);
  if (bench.polePairs && *bench.polePairs != std::floor(*bench.polePairs))
    motor.fault("pole_pairs", "is no whole number");
  readTrusted(root, bench, bench.trusted);
  if (root.has("load")) {
    JsonObject load = root.object("load");
    if (load.has("pendulum")) {
      JsonObject pendulum = load.object("pendulum");
      if (bench.axis == Axis::linear) load.fault("pendulum", "hangs on a rotary axis only, but axis is linear");
      bench.pendulum =
          Pendulum{pendulum.number("mass_kg", Allowed::nonNegative), pendulum.number("length_m", Allowed::positive),
                   pendulum.number("arm_mass_kg", 0.0, Allowed::nonNegative), pendulum.number("down_angle_rad", 0.0)};
    }
  }
  if (root.has("controller") && !bench.servo) readController(root.object("controller"), bench.controller);
  bench.remarks = root.texts("remarks");
  if (const auto done = root.finish(); !done) return done.error();
  return bench;
}

}  // namespace

const MotorNames& motorNames(Axis axis) {
  return axis == Axis::rotary ? rotaryNames : linearNames;
}

std::optional<DriveInput> driveInputNamed(const std::string& name, Axis axis) {
  for (const InputQuantity& one : inputs) {
    if (name == columnName(one.quantity, axis)) return one.input;
  }
  return std::nullopt;
}

double Bench::count() const {
  if (!countsPerUnit) return 0.0;
  return (axis == Axis::rotary ? turn_rad : 1.0) / *countsPerUnit;
}

std::string Bench::positionChannel() const {
  return columnName(Quantity::position, axis);
}

std::string Bench::torqueChannel() const {
  return columnName(Quantity::torque, axis);
}

std::string Bench::velocityChannel() const {
  return columnName(Quantity::velocity, axis);
}

std::string Bench::inputChannel() const {
  if (servo) return columnName(Quantity::positionReference, axis);
  for (const InputQuantity& one : inputs) {
    if (one.input == input) return columnName(one.quantity, axis);
  }
  return {};
}

Result<Bench> readBench(const std::string& path) {
  auto root = JsonObject::fromFile(path);
  if (!root) return root.error();
  return readBench(*root);
}

Result<Bench> readBenchText(const std::string& text, const std::string& place) {
  auto root = JsonObject::fromText(text, place);
  if (!root) return root.error();
  return readBench(*root);
}

Result<void> writeBench(const Bench& bench, const std::string& path) {
  using Json = nlohmann::ordered_json;
  const MotorNames& names = motorNames(bench.axis);
  Json json{{"schema", schema}, {"name", bench.name}};
  if (!bench.motorSerial.empty()) json["motor_serial"] = bench.motorSerial;
  json["axis"] = bench.axis == Axis::rotary ? "rotary" : "linear";
  if (bench.countsPerUnit) json["encoder"][names.counts] = *bench.countsPerUnit;
  json["drive"]["input"] = bench.inputChannel();
  if (bench.supply_V) json["drive"]["supply_V"] = *bench.supply_V;
  if (bench.currentGainInterval) json["drive"]["current_gain_interval"] = *bench.currentGainInterval;
  for (const DutyPoint& point : bench.dutyCurve.points)
    json["drive"]["duty_curve"].push_back({point.input, point.output.value, point.output.standardError});
  const auto put = [&json](const char* name, const std::optional<double>& value) {
    if (value) json["motor"][name] = *value;
  };
  json["motor"] = Json::object();
  put(names.torqueConstant, bench.motor.torqueConstant);
  put(names.backEmfConstant, bench.motor.backEmfConstant);
  put(names.resistance, bench.motor.resistance_ohm);
  put(names.inductance, bench.motor.inductance_H);
  put(names.inertia, bench.motor.inertia);
  put(names.viscous, bench.motor.viscous);
  put(names.coulomb, bench.motor.coulomb);
  put("pole_pairs", bench.polePairs);
  json["trusted"] = bench.trusted;
  if (bench.pendulum) {
    json["load"]["pendulum"] = Json{{"mass_kg", bench.pendulum->mass_kg},
                                    {"length_m", bench.pendulum->length_m},
                                    {"arm_mass_kg", bench.pendulum->armMass_kg},
                                    {"down_angle_rad", bench.pendulum->downAngle_rad}};
  }
  if (bench.servo) {
    const ServoNames& law = servoNames(bench.input, bench.axis);
    const auto add = [&json](const char* name, const std::optional<double>& value) {
      if (value) json["controller"][name] = *value;
    };
    json["controller"]["mode"] = "position";
    add(law.kp, bench.servo->kp);
    add(law.kd, bench.servo->kd);
    add(law.limit, bench.servo->limit);
    add("rate_Hz", bench.servo->rate_Hz);
    add(servoDelayName, bench.servo->delay_s);
  }
  const BenchController& controller = bench.controller;
  for (const GainNames& one : gainNames) {
    if (one.mode != controller.mode || controller.mode == ControlMode::openLoop) continue;
    json["controller"] = Json{{"mode", one.name},
                              {one.kp, controller.kp},
                              {one.ki, controller.ki},
                              {one.kd, controller.kd},
                              {"observer_cutoff_rad_per_s", controller.observerCutoff_rad_per_s},
                              {"nominal_inertia_kg_m2", controller.nominalInertia},
                              {"nominal_torque_constant_Nm_per_A", controller.nominalTorqueConstant},
                              {"current_limit_A", controller.currentLimit_A}};
  }
  if (!bench.remarks.empty()) json["remarks"] = bench.remarks;
  return writeFile(path, withMade(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"));
}

}  // namespace breakaway
