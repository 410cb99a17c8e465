#include "report/tuning_report.h"

#include <fmt/core.h>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/atomic_file.h"
#include "base/made.h"
#include "control/tuning.h"
#include "draw/html_report.h"
#include "report/inner_loop_tables.h"
#include "report/tuning_figures.h"

namespace breakaway {

namespace {

using Json = nlohmann::ordered_json;
constexpr double perRadian = 180.0 / std::numbers::pi;
constexpr int square_px = 620;

/// A margin without a bound is written as null.
Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json optional(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json estimateJson(const Estimate& estimate) {
  return {{"value", estimate.value}, {"ci95", {estimate.low95(), estimate.high95()}}};
}

Json marginsJson(const LoopMargins& found) {
  return {{"stable", found.stable},
          {"gain_margin", finite(found.gainMargin)},
          {"gain_reduction", found.gainReduction},
          {"phase_margin_rad", finite(found.phaseMargin_rad)},
          {"delay_margin_s", finite(found.delayMargin_s)},
          {"gain_crossover_rad_per_s", found.gainCrossover_rad_per_s},
          {"phase_crossover_rad_per_s", found.phaseCrossover_rad_per_s},
          {"peak_sensitivity", found.peakSensitivity},
          {"peak_complementary", found.peakComplementary},
          {"damping", found.damping}};
}

Json noiseJson(const TuningStudy& study) {
  const LoopNoise& noise = study.tuning.noise;
  const auto called = [&study](const char* name) { return nameOn(study.axis, name); };
  return {{study.axis == Axis::linear ? "position_rms_m" : "angle_rms_rad", study.sensors.angle_rms_rad},
          {"current_rms_A", study.sensors.current_rms_A},
          {called("disturbance_estimate_rms_Nm"), noise.estimate_Nm},
          {called("disturbance_estimate_by_encoder_rms_Nm"), noise.estimateByEncoder_Nm},
          {"current_reference_rms_A", noise.currentReference_A},
          {called("velocity_rms_rad_per_s"), noise.velocity_rad_per_s},
          {"voltage_rms_V", noise.voltage_V}};
}

Json cutoffJson(const TuningStudy& study) {
  const CutoffBounds& bounds = study.bounds;
  return {{"chosen_rad_per_s", study.tuning.settings.observer_cutoff_rad_per_s},
          {"alpha_g_T", study.loop.alphaGT()},
          {"rule_of_thumb_rad_per_s", bounds.ruleOfThumb_rad_per_s},
          {"filter_rule_rad_per_s", optional(bounds.filterRule_rad_per_s)},
          {"unstable_from_rad_per_s", optional(bounds.unstable_rad_per_s)},
          {"damping_below_0_707_from_rad_per_s", optional(bounds.lessDamped_rad_per_s)},
          {"searched_to_rad_per_s", bounds.searched_rad_per_s}};
}

Json loopJson(const ServoLoop& loop) {
  return {{"tick_s", loop.board.tick_s},
          {"delay_ticks", loop.delay_ticks},
          {"velocity_bandwidth_rad_per_s", loop.board.velocityBandwidth_rad_per_s},
          {"current_path", loop.current == CurrentPath::winding ? "winding" : "ideal"},
          {"current_bandwidth_rad_per_s", loop.board.current.bandwidth_rad_per_s}};
}

Json choiceJson(const BandwidthChoice& choice, double board_rad_per_s) {
  Json json{{"bandwidth_rad_per_s", choice.bandwidth_rad_per_s}, {"source", nameOf(choice.source)}};
  if (!choice.heldBy.empty()) json["held_by"] = choice.heldBy;
  json["board_rad_per_s"] = board_rad_per_s;
  return json;
}

Json controllersJson(const Tuning& tuning) {
  const BenchController velocity = controllerOf(tuning);
  const auto& gains = tuning.settings.gains;
  const auto complete = [&velocity](Json json) {
    json["observer_cutoff_rad_per_s"] = velocity.observerCutoff_rad_per_s;
    json["nominal_inertia_kg_m2"] = velocity.nominalInertia;
    json["nominal_torque_constant_Nm_per_A"] = velocity.nominalTorqueConstant;
    json["current_limit_A"] = velocity.currentLimit_A;
    return json;
  };
  return {{"controller", complete({{"mode", "velocity"},
                                   {"kp_A_s_per_rad", velocity.kp},
                                   {"ki_A_per_rad", velocity.ki},
                                   {"kd_A_s2_per_rad", velocity.kd}})},
          {"position_controller", complete({{"mode", "position"},
                                            {"kp_A_per_rad", gains.position_kp_A_per_rad},
                                            {"ki_A_per_rad_s", gains.position_ki_A_per_rad_s},
                                            {"kd_A_s_per_rad", gains.position_kd_A_s_per_rad}})}};
}

std::string locusTable(const RootLocus& locus) {
  std::string table = "cutoff_rad_per_s";
  for (size_t b = 0; b < locus.branches.size(); ++b)
    table += ",real_" + std::to_string(b + 1) + ",imaginary_" + std::to_string(b + 1);
  table += "\n";
  for (size_t k = 0; k < locus.cutoff_rad_per_s.size(); ++k) {
    std::vector<double> values{locus.cutoff_rad_per_s[k]};
    for (const auto& branch : locus.branches) values.insert(values.end(), {branch[k].real(), branch[k].imag()});
    table += numberRow(values);
  }
  return table;
}

std::string responseTable(const TuningStudy& study) {
  std::string table = "frequency_rad_per_s";
  for (const char* loop : {"velocity", "position"}) {
    for (const char* what : {"loop_gain", "loop_phase_rad", "sensitivity", "complementary", "following",
                             "yielding_rad_per_s_per_Nm", "observing"})
      table += "," + std::string(loop) + "_" + nameOn(study.axis, what);
  }
  table += "\n";
  for (size_t k = 0; k < study.velocity.frequency_rad_per_s.size(); ++k) {
    std::vector<double> values{study.velocity.frequency_rad_per_s[k]};
    const std::pair<const LoopResponse*, const ClosedResponse*> loops[] = {{&study.velocity, &study.velocityClosed},
                                                                           {&study.position, &study.positionClosed}};
    for (const auto& [cut, closed] : loops) {
      values.insert(values.end(), {std::abs(cut->loop[k]), std::arg(cut->loop[k]), std::abs(cut->sensitivity[k]),
                                   std::abs(cut->complementary[k]), std::abs(closed->following[k]),
                                   std::abs(closed->yielding[k]), std::abs(closed->observing[k])});
    }
    table += numberRow(values);
  }
  return table;
}

std::string noiseTable(const TuningStudy& study) {
  std::string table = "cutoff_rad_per_s";
  for (const char* what : {"disturbance_estimate_rms_Nm", "disturbance_estimate_by_encoder_rms_Nm",
                           "current_reference_rms_A", "velocity_rms_rad_per_s", "voltage_rms_V"})
    table += "," + nameOn(study.axis, what);
  table += "\n";
  for (size_t k = 0; k < study.noise.size(); ++k) {
    const LoopNoise& one = study.noise[k];
    table += numberRow({study.cutoffs_rad_per_s[k], one.estimate_Nm, one.estimateByEncoder_Nm, one.currentReference_A,
                        one.velocity_rad_per_s, one.voltage_V});
  }
  return table;
}

std::string percent(const Estimate& estimate) {
  return numberText(100.0 * (estimate.high95() - estimate.value) / estimate.value, 2) + " %";
}

std::string marginWords(const LoopMargins& found) {
  return "gain margin " + numberText(found.gainMargin, 3) + " (" + numberText(20.0 * std::log10(found.gainMargin), 3) +
         " dB), phase margin " + numberText(perRadian * found.phaseMargin_rad, 3) + "°, peak of the sensitivity " +
         numberText(found.peakSensitivity, 3) + ", delay margin " + numberText(1e3 * found.delayMargin_s, 3) + " ms";
}

std::string boundWords(const TuningStudy& study) {
  const CutoffBounds& bounds = study.bounds;
  const auto upTo = [&bounds](bool below, const std::optional<double>& bound, const std::string& what) {
    if (!below) return "at no cutoff " + what;
    return what + " up to " + numberText(bound.value_or(bounds.searched_rad_per_s), 3) + " rad/s" +
           (bound ? "" : " and beyond");
  };
  return "αgT is " + numberText(study.loop.alphaGT(), 2) + "; the rule αgT ≤ 0.3 would allow " +
         numberText(bounds.ruleOfThumb_rad_per_s, 3) + " rad/s. With these gains the loop really is " +
         upTo(bounds.stableBelow, bounds.unstable_rad_per_s, "stable") + ", and " +
         upTo(bounds.dampedBelow, bounds.lessDamped_rad_per_s, "damped by 0.707 or more") + ".";
}

}  // namespace

BenchController controllerOf(const Tuning& tuning) {
  const ServoSettings<double>& s = tuning.settings;
  return {ControlMode::velocity,         s.gains.velocity_kp_A_s_per_rad,
          s.gains.velocity_ki_A_per_rad, s.gains.velocity_kd_A_s2_per_rad,
          s.observer_cutoff_rad_per_s,   s.inertia_kg_m2,
          s.torqueConstant_Nm_per_A,     s.current_limit_A};
}

std::string tuningJson(const TuningStudy& study, const std::string& name) {
  const Tuning& tuning = study.tuning;
  const std::string inertia = nameOn(study.axis, "inertia_kg_m2"),
                    constant = nameOn(study.axis, "torque_constant_Nm_per_A");
  Json json{{"schema", "breakaway.tuning/1"}, {"name", name}, {"stiffness", nameOf(tuning.stiffness)}};
  json.update(controllersJson(tuning));
  json["velocity_bandwidth_rad_per_s"] = tuning.velocityBandwidth_rad_per_s;
  json["position_bandwidth_rad_per_s"] = tuning.positionBandwidth_rad_per_s;
  json["held_by"] = tuning.heldBy;
  json["motor"] = {{inertia, estimateJson(study.inertia_kg_m2)},
                   {constant, estimateJson(study.torqueConstant_Nm_per_A)}};
  if (study.loop.current == CurrentPath::winding) {
    json["motor"]["resistance_ohm"] = study.loop.motor.resistance_ohm;
    json["motor"]["inductance_H"] = study.loop.motor.inductance_H;
  }
  json["loop"] = loopJson(study.loop);
  const double T = study.loop.board.tick_s;
  json["speed_observer"] = choiceJson(study.inner.observer, boardVelocityBandwidth_rad_per_s(T));
  json["current_loop"] = choiceJson(study.inner.current, boardCurrentBandwidth_rad_per_s(T));
  json["wanted"] = {{"gain_margin", tuning.wanted.gainMargin},
                    {"phase_margin_rad", tuning.wanted.phaseMargin_rad},
                    {"peak_sensitivity", tuning.wanted.peakSensitivity},
                    {"noise_per_current_limit", tuning.wanted.noiseShare}};
  json["velocity"] = {{"nominal", marginsJson(tuning.nominal.velocity)}, {"worst", marginsJson(tuning.worstVelocity)}};
  json["position"] = {{"nominal", marginsJson(tuning.nominal.position)}, {"worst", marginsJson(tuning.worstPosition)}};
  for (const TuningCorner& corner : tuning.corners) {
    json["corners"].push_back({{inertia, corner.inertia_kg_m2},
                               {constant, corner.torqueConstant_Nm_per_A},
                               {"velocity", marginsJson(corner.velocity)},
                               {"position", marginsJson(corner.position)}});
  }
  json["cutoff"] = cutoffJson(study);
  json["noise"] = noiseJson(study);
  return json.dump(2) + "\n";
}

Result<void> writeTuning(const TuningStudy& study, const Bench& bench, const std::string& folder) {
  if (auto made = makeFolder(folder + "/figures"); !made) return made;
  Bench tuned = bench;
  tuned.controller = controllerOf(study.tuning);
  const std::pair<const char*, std::string> texts[] = {{"tuning.json", withMade(tuningJson(study, bench.name))},
                                                       {"root_locus.csv", locusTable(study.locus)},
                                                       {"response.csv", responseTable(study)},
                                                       {"noise.csv", noiseTable(study)},
                                                       {"speed_observer.csv", speedObserverTable(study)},
                                                       {"current_loop.csv", currentLoopTable(study)}};
  for (const auto& [name, text] : texts) {
    if (auto done = writeFile(folder + "/" + name, text); !done) return done;
  }
  const std::pair<const char*, Figure> squares[] = {{"root_locus", rootLocusFigure(study.loop, study.locus)},
                                                    {"root_locus_s", slowPolesFigure(study.loop, study.locus)}};
  for (const auto& [name, figure] : squares) {
    if (auto done = writeSvg(figure, folder + "/figures/" + name + ".svg", square_px, square_px); !done) return done;
  }
  const std::pair<const char*, Figure> wide[] = {
      {"loop_gain", gainFigure(study)},
      {"loop_phase", phaseFigure(study)},
      {"sensitivity", sensitivityFigure(study)},
      {"load", loadFigure(study)},
      {"noise", noiseFigure(study)},
      {"speed_observer", speedObserverFigure(study.inner, study.axis == Axis::linear)}};
  for (const auto& [name, figure] : wide) {
    if (auto done = writeSvg(figure, folder + "/figures/" + name + ".svg"); !done) return done;
  }
  if (!study.inner.currentRows.empty()) {
    if (auto done = writeSvg(currentLoopFigure(study.inner), folder + "/figures/current_loop.svg"); !done) return done;
  }
  return writeBench(tuned, folder + "/bench.json");
}

std::string inWords(const TuningStudy& study) {
  const Tuning& tuning = study.tuning;
  const auto& gains = tuning.settings.gains;
  const bool linear = study.axis == Axis::linear;
  const std::string perSpeed = linear ? " A s/m" : " A s/rad", perPlace = linear ? " A/m" : " A/rad";
  std::string words = "Tuned " + std::string(nameOf(tuning.stiffness)) + ": velocity Kp " +
                      numberText(gains.velocity_kp_A_s_per_rad) + perSpeed + ", observer cutoff " +
                      numberText(tuning.settings.observer_cutoff_rad_per_s, 3) + " rad/s; position Kp " +
                      numberText(gains.position_kp_A_per_rad) + perPlace + ", Kd " +
                      numberText(gains.position_kd_A_s_per_rad) + perSpeed + ".\n";
  if (!tuning.heldBy.empty()) words += "What would be lost first with higher gains: " + tuning.heldBy + ".\n";
  words += "At the worst corner of " + std::string(linear ? "mass" : "inertia") + " ±" + percent(study.inertia_kg_m2) +
           " and " + (linear ? "force" : "torque") + " constant ±" + percent(study.torqueConstant_Nm_per_A) +
           ", velocity: " + marginWords(tuning.worstVelocity) + "; position: " + marginWords(tuning.worstPosition) +
           ".\n";
  words += boundWords(study) + "\n";
  words += "Noise: " + numberText(1e3 * tuning.noise.estimate_Nm, 3) +
           (linear ? " mN rms in the force estimate, " : " mNm rms in the torque estimate, ") +
           numberText(1e3 * tuning.noise.currentReference_A, 3) + " mA in the current.";
  words += "\n" + innerLoopWords(study);
  if (study.loop.current == CurrentPath::ideal)
    words += "\nThe current loop was taken as ideal: resistance or inductance is missing.";
  return words;
}

}  // namespace breakaway
