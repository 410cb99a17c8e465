#include "plant/rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/json_object.h"
#include "base/numbers.h"

namespace breakaway {

namespace {

constexpr const char* schema = "breakaway.rig/1";
constexpr int highestOrder = 1000;

/// The rig file's names on one axis.
struct RigNames {
  const char *torqueConstant, *backEmfConstant, *inertia, *addedInertia, *stribeck, *position, *harmonics;
};
constexpr RigNames rotaryNames{"torque_constant_Nm_per_A",
                               "back_emf_constant_V_s_per_rad",
                               "inertia_kg_m2",
                               "added_inertia_kg_m2",
                               "stribeck_velocity_rad_per_s",
                               "position_torque",
                               "harmonics_Nm"};
constexpr RigNames linearNames{"force_constant_N_per_A",
                               "back_emf_constant_V_s_per_m",
                               "mass_kg",
                               "added_mass_kg",
                               "stribeck_velocity_m_per_s",
                               "position_force",
                               "harmonics_N"};

const RigNames& namesOf(const Rig& rig) {
  return rig.axis == Axis::rotary ? rotaryNames : linearNames;
}

std::vector<Harmonic> readHarmonics(JsonObject& object, std::string_view name) {
  std::vector<Harmonic> harmonics;
  for (const auto& row : object.rows(name, 3)) {
    if (row[0] != std::floor(row[0]) || row[0] < 0.0 || row[0] > highestOrder) {
      object.fault(name, "has the order " + std::to_string(row[0]) + ", expected a whole number from 0 to " +
                             std::to_string(highestOrder));
      return {};
    }
    harmonics.push_back({row[0], row[1], row[2]});
  }
  return harmonics;
}

/// `unit`: what the file's unit of it is on the rig's shaft.
FrictionCurve readCurve(JsonObject& friction, const std::string& name, double unit) {
  JsonObject object = friction.object(name);
  FrictionCurve curve{unit * object.number("mean", Allowed::nonNegative), readHarmonics(object, "harmonics"), 0.0, {}};
  double lowest = 0.0;
  for (int k = 0; k < 7200; ++k) lowest = std::min(lowest, curve.at(k * std::numbers::pi / 3600.0));
  if (lowest < 0.0) friction.fault(name, "falls below zero around the rotor, expected friction everywhere");
  return curve;
}

void readFriction(JsonObject friction, Rig& rig) {
  const std::array<std::string, 2> ways{"_cw", "_ccw"};
  const double unit = rig.unitPerRad();
  for (size_t way = 0; way < 2; ++way) {
    rig.staticFriction_Nm[way] = readCurve(friction, "static" + ways[way], unit);
    rig.coulomb_Nm[way] = readCurve(friction, "coulomb" + ways[way], unit);
    rig.viscous_Nm_s_per_rad[way] = readCurve(friction, "viscous" + ways[way], unit * unit);
  }
  rig.stribeckVelocity_rad_per_s = friction.number(namesOf(rig).stribeck, Allowed::positive) / unit;
  rig.scatterRms = friction.number("scatter_rms", 0.0, Allowed::nonNegative);
  if (rig.scatterRms > 0.3) friction.fault("scatter_rms", "is above 0.3, expected a small relative scatter");
}

void readCurrentSensor(JsonObject object, RigCurrentSensor& sensor) {
  sensor.sensitivity_V_per_A = object.number("sensitivity_V_per_A", sensor.sensitivity_V_per_A, Allowed::positive);
  sensor.gainError = object.number("gain_error", 0.0);
  if (std::abs(sensor.gainError) > 0.5) object.fault("gain_error", "is beyond ±0.5, expected a small relative error");
  sensor.offset_A = object.number("offset_A", 0.0);
  sensor.drift_A_per_s = object.number("drift_A_per_s", 0.0);
  sensor.noiseRms_A = object.number("noise_rms_A", 0.0, Allowed::nonNegative);
  sensor.supplyDeviation_V = object.number("supply_deviation_V", 0.0);
  sensor.offset_V_per_degC = object.number("offset_V_per_degC", 0.0);
  sensor.gain_per_degC = object.number("gain_per_degC", 0.0);
  sensor.temperatureRise_degC = object.number("temperature_rise_degC", 0.0);
  sensor.temperatureTime_s = object.number("temperature_time_s", sensor.temperatureTime_s, Allowed::positive);
  const double bits = object.number("adc_bits", sensor.adcBits, Allowed::positive);
  if (bits != std::floor(bits) || bits < 4 || bits > 24)
    object.fault("adc_bits", "expected a whole number from 4 to 24");
  sensor.adcBits = static_cast<int>(bits);
  sensor.adcRange_V = object.number("adc_range_V", sensor.adcRange_V, Allowed::positive);
  if (std::abs(sensor.supplyDeviation_V) > 0.2 * sensor.adcRange_V)
    object.fault("supply_deviation_V", "is beyond a fifth of adc_range_V, expected a small deviation");
  if (std::abs(sensor.gain_per_degC * sensor.temperatureRise_degC) > 0.5)
    object.fault("gain_per_degC", "changes the gain by more than half, expected a small drift");
}

void readEdges(JsonObject& object, RigEncoder& encoder) {
  encoder.quadratureError_counts = object.number("quadrature_error_counts", 0.0, Allowed::nonNegative);
  encoder.indexWidth_counts = object.number("index_width_counts", 0.0, Allowed::nonNegative);
  if (encoder.quadratureError_counts > 0.5)
    object.fault("quadrature_error_counts", "is above 0.5, expected less than half a count");
  if (encoder.indexWidth_counts > 4.0) object.fault("index_width_counts", "is above 4, expected at most one line");
}

void readDisc(JsonObject& object, RigEncoder& encoder) {
  encoder.countsPerRev = object.number("counts_per_rev", Allowed::positive);
  if (encoder.countsPerRev < 64.0) object.fault("counts_per_rev", "expected at least 64");
  encoder.indexAngle_rad = object.number("index_angle_rad", 0.0);
  encoder.eccentricity_rad = object.number("eccentricity_rad", 0.0, Allowed::nonNegative);
  encoder.eccentricityPhase_rad = object.number("eccentricity_phase_rad", 0.0);
  if (encoder.eccentricity_rad > 0.1) object.fault("eccentricity_rad", "is above 0.1, expected a small angle");
}

/// A scale along the travel, with or without an index.
void readScale(JsonObject& object, Rig& rig) {
  const double counts_per_m = object.number("counts_per_m", Allowed::positive);
  rig.encoder.countsPerRev = counts_per_m * rig.travel.length_m;
  if (rig.encoder.countsPerRev < 64.0) object.fault("counts_per_m", "expected at least 64 over the travel");
  const auto index_m = object.optionalNumber("index_m", Allowed::nonNegative);
  rig.encoder.hasIndex = index_m.has_value();
  if (index_m && *index_m > rig.travel.length_m)
    object.fault("index_m", "lies beyond the travel, expected a place between the stops");
  rig.encoder.indexPlace_rad = index_m.value_or(0.0) / rig.unitPerRad();
}

/// The stops swing with the moving mass slower than the plant's steps can tell.
constexpr double fastestStop_rad_per_s = 4000.0;

/// What the stops are made of once the moving mass is known, on the shaft.
void readStops(JsonObject& travel, Rig& rig) {
  const double unit = rig.unitPerRad(), mass_kg = rig.inertia_kg_m2 / (unit * unit);
  const double usual_N_per_m = mass_kg * 1e6;
  const double stiffness = travel.number("stop_stiffness_N_per_m", usual_N_per_m, Allowed::positive);
  const double natural = std::sqrt(stiffness / mass_kg);
  const double damping = travel.number("stop_damping_N_s_per_m", 0.6 * mass_kg * natural, Allowed::nonNegative);
  if (natural > fastestStop_rad_per_s)
    travel.fault("stop_stiffness_N_per_m", "is too stiff for so small a mass, expected less");
  if (damping > 2.0 * mass_kg * natural)
    travel.fault("stop_damping_N_s_per_m", "is beyond critical damping, expected less");
  rig.travel.stopStiffness_Nm_per_rad = stiffness * unit * unit;
  rig.travel.stopDamping_Nm_s_per_rad = damping * unit * unit;
}

void readTravel(JsonObject& travel, Rig& rig) {
  rig.travel.length_m = travel.number("length_m", Allowed::positive);
  if (rig.travel.length_m < 0.01 || rig.travel.length_m > 100.0) travel.fault("length_m", "expected 0.01 to 100");
  rig.travel.start_m = travel.number("start_m", 0.5 * rig.travel.length_m, Allowed::nonNegative);
  if (rig.travel.start_m > rig.travel.length_m) travel.fault("start_m", "lies beyond length_m");
}

void readBridge(JsonObject object, RigBridge& bridge) {
  bridge.supply_V = object.number("supply_V", Allowed::positive);
  bridge.deadZoneDuty = object.number("dead_zone_duty", 0.0, Allowed::nonNegative);
  if (bridge.deadZoneDuty > 0.5) object.fault("dead_zone_duty", "is above 0.5, expected a small part of the duty");
  bridge.pwmSteps = object.number("pwm_steps", 0.0, Allowed::nonNegative);
  bridge.supplyResistance_ohm = object.number("supply_resistance_ohm", 0.0, Allowed::nonNegative);
  const auto rows = object.rows("duty_curve", 2);
  if (rows.empty()) return;
  bridge.dutyCurve.points.push_back({bridge.deadZoneDuty, {}});
  for (const auto& row : rows) bridge.dutyCurve.points.push_back({row[0], {row[1], 0.0}});
  if (!bridge.dutyCurve.rises())
    object.fault("duty_curve",
                 "doesn't rise from the dead zone's end on, expected [input duty, output duty] in rising order");
}

RigEffect readEffect(JsonObject& object, Axis axis) {
  RigEffect effect{object.text("effect"), {}};
  const RigEffectKind* kind = findRigEffect(effect.effect);
  JsonObject parameters = object.object("parameters", false);
  if (!kind) {
    std::string all;
    for (const auto& one : rigEffectKinds()) all += (all.empty() ? "" : ", ") + one.effect;
    object.fault("effect", "is \"" + effect.effect + "\", expected one that a simulated rig can conceal: " + all);
    return effect;
  }
  if (axis == Axis::linear && kind->needsRotor)
    object.fault("effect", "is \"" + effect.effect + "\", which a rotor conceals, but axis is linear");
  for (const auto& [name, otherwise] : kind->parameters) {
    const bool positive = name == "time_constant_s" || name == "current_A";
    effect.parameters.emplace_back(name,
                                   parameters.number(name, otherwise, positive ? Allowed::positive : Allowed::any));
  }
  return effect;
}

Result<Rig> readRig(JsonObject root) {
  Rig rig;
  const std::string found = root.text("schema");
  if (found != schema) root.fault("schema", "is \"" + found + "\", expected \"" + schema + "\"");
  rig.name = root.text("name", "");
  rig.loopRate_Hz = root.number("loop_rate_Hz", Allowed::positive);
  if (rig.loopRate_Hz < 200.0 || rig.loopRate_Hz > 100000.0) root.fault("loop_rate_Hz", "expected 200 to 100000");
  const std::string axis = root.text("axis", "rotary");
  if (axis != "rotary" && axis != "linear") root.fault("axis", "is \"" + axis + "\", expected rotary or linear");
  rig.axis = axis == "linear" ? Axis::linear : Axis::rotary;
  const bool turns = rig.axis == Axis::rotary;
  if (turns && root.has("travel")) root.fault("travel", "belongs to a linear axis, but axis is rotary");
  JsonObject travel = root.object("travel", !turns);
  if (!turns) readTravel(travel, rig);
  const RigNames& names = namesOf(rig);
  const double unit = rig.unitPerRad();
  JsonObject motor = root.object("motor");
  rig.torqueConstant_Nm_per_A = unit * motor.number(names.torqueConstant, Allowed::positive);
  rig.backEmfConstant_V_s_per_rad = unit * motor.number(names.backEmfConstant, Allowed::positive);
  rig.resistance_ohm = motor.number("resistance_ohm", Allowed::positive);
  rig.inductance_H = motor.number("inductance_H", Allowed::positive);
  rig.inertia_kg_m2 =
      unit * unit *
      (motor.number(names.inertia, Allowed::positive) + motor.number(names.addedInertia, 0.0, Allowed::nonNegative));
  if (!turns) readStops(travel, rig);
  readFriction(root.object("friction"), rig);
  JsonObject position = root.object(names.position, false);
  rig.positionTorque_Nm = readHarmonics(position, names.harmonics);
  for (Harmonic& one : rig.positionTorque_Nm) one.amplitude *= unit;
  JsonObject encoder = root.object("encoder");
  if (turns) {
    readDisc(encoder, rig.encoder);
  } else {
    readScale(encoder, rig);
  }
  readEdges(encoder, rig.encoder);
  rig.coupling = readCoupling(root, rig.axis, unit, rig.inertia_kg_m2);
  readCurrentSensor(root.object("current_sensor", false), rig.currentSensor);
  readBridge(root.object("bridge"), rig.bridge);
  for (JsonObject& effect : root.objects("effects")) rig.effects.push_back(readEffect(effect, rig.axis));
  rig.faults = readFaults(root, rig.axis, unit);
  rig.wiring = readWiring(root, rig.axis, unit);
  if (const auto done = root.finish(); !done) return done.error();
  return rig;
}

/// The stop of a rotor swings with it as fast as that of a linear axis does by default.
constexpr double usualStop_rad_per_s = 1000.0;

/// What the wiring hangs on the shaft.
void attach(const RigWiring& wiring, PlantPhysics& physics) {
  switch (wiring.kind) {
    case WiringKind::load:
      physics.attached.push_back({wiring.from_s, wiring.value, 0.0});
      break;
    case WiringKind::pendulum:
      physics.attached.push_back({wiring.from_s, 0.0, wiring.value});
      break;
    case WiringKind::stopAt: {
      const double inertia = physics.totalInertia();
      physics.walls.push_back({wiring.from_s, physics.startAngle_rad + wiring.value, wiring.value > 0.0 ? 1.0 : -1.0,
                               inertia * usualStop_rad_per_s * usualStop_rad_per_s,
                               0.6 * inertia * usualStop_rad_per_s});
      break;
    }
    default:
      break;  // at the terminals
  }
}

}  // namespace

double Rig::unitPerRad() const {
  return axis == Axis::rotary ? 1.0 : travel.length_m / turn_rad;
}

double Rig::startAngle_rad() const {
  return axis == Axis::rotary ? -encoder.indexAngle_rad : travel.start_m / unitPerRad();
}

PlantPhysics physicsOf(const Rig& rig) {
  PlantPhysics physics;
  physics.torqueConstant = rig.torqueConstant_Nm_per_A;
  physics.backEmfConstant = rig.backEmfConstant_V_s_per_rad;
  physics.resistance_ohm = rig.resistance_ohm;
  physics.inductance_H = rig.inductance_H;
  physics.inertia = rig.inertia_kg_m2;
  physics.startAngle_rad = rig.startAngle_rad();
  physics.holding = rig.staticFriction_Nm;
  physics.coulomb = rig.coulomb_Nm;
  physics.viscous = rig.viscous_Nm_s_per_rad;
  physics.stribeckVelocity = rig.stribeckVelocity_rad_per_s;
  physics.scatterRms = rig.scatterRms;
  physics.position = rig.positionTorque_Nm;
  physics.supply_V = rig.bridge.supply_V;
  physics.coupling = rig.coupling;
  if (rig.axis == Axis::linear)
    physics.stops = {true, 0.0, turn_rad, rig.travel.stopStiffness_Nm_per_rad, rig.travel.stopDamping_Nm_s_per_rad};
  for (const RigEffect& effect : rig.effects) {
    if (const RigEffectKind* kind = findRigEffect(effect.effect); kind && kind->conceal) kind->conceal(effect, physics);
  }
  physics.supplyResistance_ohm += rig.bridge.supplyResistance_ohm;
  for (const RigWiring& wiring : rig.wiring) attach(wiring, physics);
  return physics;
}

Result<Rig> readRig(const std::string& path) {
  auto root = JsonObject::fromFile(path);
  if (!root) return root.error();
  return readRig(*root);
}

Result<Rig> readRigText(const std::string& text, const std::string& place) {
  auto root = JsonObject::fromText(text, place);
  if (!root) return root.error();
  return readRig(*root);
}

}  // namespace breakaway
