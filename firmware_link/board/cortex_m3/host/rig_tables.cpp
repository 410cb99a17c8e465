#include "firmware_link/board/cortex_m3/host/rig_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <utility>

#include "base/numbers.h"
#include "firmware_link/simulated_rig.h"
#include "plant/plant_propagator.h"

namespace breakaway {

namespace {

constexpr double coarsestSubstep_s = 50e-6;
constexpr int cellBits = 12;

EmulatedMotion motionOf(const Propagator& p) {
  EmulatedMotion motion{};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      motion.change[i][j] = static_cast<float>(p.phi[i][j] - (i == j ? 1.0 : 0.0));
      motion.gamma[i][j] = static_cast<float>(p.gamma[i][j]);
    }
  }
  return motion;
}

Result<void> carried(const Rig& rig) {
  for (const RigEffect& effect : rig.effects) {
    if (const auto* kind = findRigEffect(effect.effect); kind && !kind->ofAngleAlone)
      return Error{"field effects", "names " + effect.effect + ", which the emulated plant doesn't have"};
  }
  if (rig.axis != Axis::rotary) return Error{"field axis", "is linear, the emulated plant is a rotor"};
  if (rig.coupling.present()) return Error{"field coupling", "is there, the emulated plant has a stiff shaft"};
  if (!rig.faults.empty()) return Error{"field faults", "isn't empty, the emulated plant has none"};
  if (!rig.wiring.empty()) return Error{"field wiring", "isn't empty, the emulated plant is wired as it should be"};
  if (rig.encoder.countsPerRev != std::floor(rig.encoder.countsPerRev))
    return Error{"field encoder.counts_per_rev", "is no whole number, expected one"};
  if (highestOrder(physicsOf(rig)) > 32)
    return Error{"field friction", "has a harmonic above order 32, too fine for the emulated plant's grid"};
  return {};
}

std::string number(float value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.9e", static_cast<double>(value));
  return std::string(text.data()) + "f";
}

std::string numbers(const float* values, size_t count) {
  std::string text = "{";
  for (size_t k = 0; k < count; ++k) text += (k > 0 ? ", " : "") + number(values[k]);
  return text + "}";
}

std::string motionText(const EmulatedMotion& motion) {
  return "{{" + numbers(motion.change[0], 2) + ", " + numbers(motion.change[1], 2) + "}, {" +
         numbers(motion.gamma[0], 2) + ", " + numbers(motion.gamma[1], 2) + "}}";
}

std::string cellText(const EmulatedCell& cell) {
  return "{" + numbers(cell.static_Nm, 2) + ", " + numbers(cell.coulomb_Nm, 2) + ", " +
         numbers(cell.viscous_Nm_s_per_rad, 2) + ", " + number(cell.position_Nm) + "}";
}

using Field = std::pair<const char*, std::string>;

std::string fields(std::initializer_list<Field> all) {
  std::string text = "{";
  for (const auto& [name, value] : all) text += (text.size() > 1 ? ", ." : ".") + std::string(name) + " = " + value;
  return text + "}";
}

/// The same numbers as the board has that runs on the host.
std::string hardwareText(const Rig& rig, const std::string& name) {
  const board::BoardHardware<float> h = hardwareOf<float>(rig);
  const auto& current = h.servo.current;
  const auto& gains = h.start.gains;
  const std::string loop = fields({{"resistance_ohm", number(current.resistance_ohm)},
                                   {"inductance_H", number(current.inductance_H)},
                                   {"backEmfConstant_V_s_per_rad", number(current.backEmfConstant_V_s_per_rad)},
                                   {"bandwidth_rad_per_s", number(current.bandwidth_rad_per_s)}});
  const std::string servo = fields({{"tick_s", number(h.servo.tick_s)},
                                    {"count_rad", number(h.servo.count_rad)},
                                    {"current", loop},
                                    {"velocityBandwidth_rad_per_s", number(h.servo.velocityBandwidth_rad_per_s)}});
  const std::string watch = fields({{"tick_s", number(h.watch.tick_s)},
                                    {"count_rad", number(h.watch.count_rad)},
                                    {"trip_A", number(h.watch.trip_A)},
                                    {"supply_V", number(h.watch.supply_V)},
                                    {"mostAcceleration_rad_per_s2", number(h.watch.mostAcceleration_rad_per_s2)},
                                    {"resistance_ohm", number(h.watch.resistance_ohm)},
                                    {"backEmf_V_s_per_rad", number(h.watch.backEmf_V_s_per_rad)},
                                    {"inductance_H", number(h.watch.inductance_H)},
                                    {"mostVelocity_rad_per_s", number(h.watch.mostVelocity_rad_per_s)},
                                    {"continuous_A", number(h.watch.continuous_A)}});
  const std::string motion = fields({{"velocity_kp_A_s_per_rad", number(gains.velocity_kp_A_s_per_rad)},
                                     {"velocity_ki_A_per_rad", number(gains.velocity_ki_A_per_rad)},
                                     {"velocity_kd_A_s2_per_rad", number(gains.velocity_kd_A_s2_per_rad)},
                                     {"position_kp_A_per_rad", number(gains.position_kp_A_per_rad)},
                                     {"position_ki_A_per_rad_s", number(gains.position_ki_A_per_rad_s)},
                                     {"position_kd_A_s_per_rad", number(gains.position_kd_A_s_per_rad)},
                                     {"velocity_limit_rad_per_s", number(gains.velocity_limit_rad_per_s)}});
  const std::string start = fields({{"gains", motion},
                                    {"observer_cutoff_rad_per_s", number(h.start.observer_cutoff_rad_per_s)},
                                    {"inertia_kg_m2", number(h.start.inertia_kg_m2)},
                                    {"torqueConstant_Nm_per_A", number(h.start.torqueConstant_Nm_per_A)},
                                    {"current_limit_A", number(h.start.current_limit_A)}});
  return fields({{"simulated", "true"},
                 {"device", "\"emulated Cortex-M3, rig " + name + "\""},
                 {"firmware", "\"reference 0.1.0\""},
                 {"loopRate_Hz", number(h.loopRate_Hz)},
                 {"countsPerRev", std::to_string(h.countsPerRev)},
                 {"supply_V", number(h.supply_V)},
                 {"sensorRange_A", number(h.sensorRange_A)},
                 {"pwmSteps", std::to_string(h.pwmSteps)},
                 {"servo", servo},
                 {"watch", watch},
                 {"start", start},
                 {"mostCurrent_A", number(h.mostCurrent_A)},
                 {"mostVelocity_rad_per_s", number(h.mostVelocity_rad_per_s)}});
}

/// The rig's name as it may stand in a comment and in a string.
std::string plainName(std::string name) {
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' ||
                       c == '.' || c == '-' || c == '_';
    if (!plain) c = '_';
  }
  return name;
}

}  // namespace

Result<RigTables> rigTables(const Rig& rig) {
  if (auto fits = carried(rig); !fits) return fits.error();
  RigTables tables;
  EmulatedRig& out = tables.rig;
  const double tick_s = 1.0 / rig.loopRate_Hz;
  out.substeps = static_cast<int>(std::ceil(tick_s / coarsestSubstep_s - 1e-9));
  const double substep_s = tick_s / out.substeps;
  out.tick_s = static_cast<float>(tick_s);
  out.substep_s = static_cast<float>(substep_s);
  const size_t count = size_t{1} << cellBits;
  const PlantPhysics physics = physicsOf(rig);
  std::array<double, 2> viscousMean{};
  for (size_t k = 0; k <= count; ++k) {
    const AngleTorques at = torquesAt(physics, turn_rad * static_cast<double>(k) / static_cast<double>(count));
    EmulatedCell cell{};
    for (size_t way = 0; way < 2; ++way) {
      cell.static_Nm[way] = static_cast<float>(at.static_Nm[way]);
      cell.coulomb_Nm[way] = static_cast<float>(at.coulomb_Nm[way]);
      cell.viscous_Nm_s_per_rad[way] = static_cast<float>(at.viscous_Nm_s_per_rad[way]);
      if (k < count) viscousMean[way] += at.viscous_Nm_s_per_rad[way] / static_cast<double>(count);
    }
    cell.position_Nm = static_cast<float>(at.position_Nm);
    tables.cells.push_back(cell);
  }
  for (size_t way = 0; way < 2; ++way) {
    const LinearMotor motor{rig.torqueConstant_Nm_per_A, rig.backEmfConstant_V_s_per_rad,
                            rig.resistance_ohm,          rig.inductance_H,
                            rig.inertia_kg_m2,           viscousMean[way]};
    out.closed[way] = motionOf(closedWindings(motor, substep_s));
    out.opened[way] = motionOf(openWindings(motor, substep_s));
    out.viscousMean_Nm_s_per_rad[way] = static_cast<float>(viscousMean[way]);
  }
  out.torqueConstant_Nm_per_A = static_cast<float>(rig.torqueConstant_Nm_per_A);
  out.backEmfConstant_V_s_per_rad = static_cast<float>(rig.backEmfConstant_V_s_per_rad);
  out.resistance_ohm = static_cast<float>(rig.resistance_ohm);
  out.inductance_H = static_cast<float>(rig.inductance_H);
  out.inertia_kg_m2 = static_cast<float>(rig.inertia_kg_m2);
  out.stribeckVelocity_rad_per_s = static_cast<float>(rig.stribeckVelocity_rad_per_s);
  out.scatterRms = static_cast<float>(rig.scatterRms);
  out.cells = tables.cells.data();
  out.cellBits = cellBits;
  out.start_q36 = std::llround(-rig.encoder.indexAngle_rad / turn_rad * 0x1p36);
  out.countsPerRev = static_cast<std::int32_t>(rig.encoder.countsPerRev);
  const RigCurrentSensor& sensor = rig.currentSensor;
  out.sensitivity_V_per_A = static_cast<float>(sensor.sensitivity_V_per_A);
  out.gain = static_cast<float>(1.0 + sensor.gainError);
  out.offset_A = static_cast<float>(sensor.offset_A);
  out.drift_A_per_s = static_cast<float>(sensor.drift_A_per_s);
  out.noiseRms_A = static_cast<float>(sensor.noiseRms_A);
  out.adcRange_V = static_cast<float>(sensor.adcRange_V);
  out.adcSteps = 1 << sensor.adcBits;
  out.supply_V = static_cast<float>(rig.bridge.supply_V);
  out.deadZoneDuty = static_cast<float>(rig.bridge.deadZoneDuty);
  return tables;
}

std::string rigHeader(const RigTables& tables, const Rig& rig) {
  const EmulatedRig& r = tables.rig;
  const auto field = [](const char* name, const std::string& value) {
    return "    ." + std::string(name) + " = " + value + ",\n";
  };
  const std::string name = plainName(rig.name);
  std::string text = "// Written from the rig " + name +
                     " when the image was built.\n#pragma once\n\n"
                     "#include \"firmware_link/board/board_hardware.h\"\n"
                     "#include \"firmware_link/board/cortex_m3/emulated_rig.h\"\n\nnamespace breakaway {\n\n"
                     "inline constexpr EmulatedCell emulatedCells[] = {\n";
  for (const EmulatedCell& cell : tables.cells) text += "    " + cellText(cell) + ",\n";
  text += "};\n\ninline constexpr EmulatedRig emulatedRig{\n";
  text += field("tick_s", number(r.tick_s)) + field("substep_s", number(r.substep_s));
  text += field("substeps", std::to_string(r.substeps));
  text += field("torqueConstant_Nm_per_A", number(r.torqueConstant_Nm_per_A));
  text += field("backEmfConstant_V_s_per_rad", number(r.backEmfConstant_V_s_per_rad));
  text += field("resistance_ohm", number(r.resistance_ohm)) + field("inductance_H", number(r.inductance_H));
  text += field("inertia_kg_m2", number(r.inertia_kg_m2));
  text += field("viscousMean_Nm_s_per_rad", numbers(r.viscousMean_Nm_s_per_rad, 2));
  text += field("closed", "{" + motionText(r.closed[0]) + ", " + motionText(r.closed[1]) + "}");
  text += field("opened", "{" + motionText(r.opened[0]) + ", " + motionText(r.opened[1]) + "}");
  text += field("stribeckVelocity_rad_per_s", number(r.stribeckVelocity_rad_per_s));
  text += field("scatterRms", number(r.scatterRms));
  text += field("cells", "emulatedCells") + field("cellBits", std::to_string(r.cellBits));
  text += field("start_q36", std::to_string(r.start_q36)) + field("countsPerRev", std::to_string(r.countsPerRev));
  text += field("sensitivity_V_per_A", number(r.sensitivity_V_per_A)) + field("gain", number(r.gain));
  text += field("offset_A", number(r.offset_A)) + field("drift_A_per_s", number(r.drift_A_per_s));
  text += field("noiseRms_A", number(r.noiseRms_A)) + field("adcRange_V", number(r.adcRange_V));
  text += field("adcSteps", std::to_string(r.adcSteps)) + field("supply_V", number(r.supply_V));
  text += field("deadZoneDuty", number(r.deadZoneDuty));
  text += "};\n\ninline constexpr board::BoardHardware<float> emulatedHardware" + hardwareText(rig, name) + ";\n\n";
  return text + "}  // namespace breakaway\n";
}

}  // namespace breakaway
