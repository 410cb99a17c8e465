#include "commission/sweep_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/numbers.h"
#include "experiment/angle_cells.h"
#include "experiment/velocity_sweep.h"
#include "identify/friction_drift.h"
#include "identify/shaft_load.h"

namespace breakaway {

double sensorZeroing_s(const Commission& known) {
  const double friction_A = known.motor.coulomb_Nm.value / known.torquePerAmpere_Nm();
  const double aim_A = 0.003 * std::max(1e-6, friction_A);
  return std::clamp(known.noiseRms_A * known.noiseRms_A / (aim_A * aim_A) / known.identity.loopRate_Hz, 0.4, 4.0);
}

std::vector<double> speedParts(std::span<const double> own, size_t speeds, double slowest) {
  if (speeds == 0 || speeds == own.size()) return {own.begin(), own.end()};
  constexpr double golden = 0.6180339887;
  std::vector<size_t> order(speeds);
  std::iota(order.begin(), order.end(), size_t{0});
  const auto turn = [](size_t k) { return std::fmod(golden * static_cast<double>(k + 1), 1.0); };
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return turn(a) < turn(b); });
  std::vector<double> parts;
  for (const size_t k : order) {
    const double up = speeds < 2 ? 1.0 : static_cast<double>(k) / static_cast<double>(speeds - 1);
    parts.push_back(std::pow(slowest, 1.0 - up));
  }
  return parts;
}

double torqueScaleError(const Commission& known) {
  const Estimate& Kt = known.motor.torqueConstant_Nm_per_A;
  return Kt.value > 0.0 ? Kt.standardError / Kt.value : 0.0;
}

double windingTime_s(const Commission& known) {
  const double resistance_ohm = known.motor.resistance_ohm.value;
  return resistance_ohm > 0.0 ? std::max(0.0, known.motor.inductance_H.value / resistance_ohm) : 0.0;
}

VelocityFrictionOptions frictionOptions(const Commission& known) {
  VelocityFrictionOptions options;
  options.torqueConstant_Nm_per_A = known.torquePerAmpere_Nm();
  options.inertia_kg_m2 = known.motor.inertia_kg_m2.value;
  options.inertiaError_kg_m2 = known.motor.inertia_kg_m2.standardError;
  options.scaleError = torqueScaleError(known);
  options.noiseRms_A = known.noiseRms_A;
  options.tick_s =
      known.identity.can.everyTick && known.identity.loopRate_Hz > 0.0 ? 1.0 / known.identity.loopRate_Hz : 0.0;
  options.windingTime_s = windingTime_s(known);
  options.zeroError_A = known.runsZeroError_A;
  options.angleError_rad = known.indexAngle_rad.standardError;
  if (!known.runs.empty()) {
    const size_t bins = known.runs.front().bins.size();
    options.beyondBins_rad = beyondBins_rad(known.identity.countsPerRev, bins, known.indexAngle_rad.value);
    options.evenBins = known.identity.countsPerRev > 0.0 && bins > 0 &&
                       std::fmod(known.identity.countsPerRev, countsPerLine * static_cast<double>(bins)) == 0.0;
  }
  options.bins = known.sweeps.bins;
  return options;
}

size_t binsOfWholeCounts(double countsPerRev, size_t wanted) {
  const auto counts = static_cast<size_t>(std::max(0.0, countsPerRev));
  const auto off = [wanted](size_t bins) {
    return std::abs(std::log(static_cast<double>(bins) / static_cast<double>(wanted)));
  };
  if (counts > 0 && counts < wanted) return counts;
  for (const size_t each : {static_cast<size_t>(countsPerLine), size_t{1}}) {
    size_t best = 0;
    for (size_t bins = wanted / 2; bins <= std::min(2 * wanted, counts); ++bins) {
      if (counts % (each * bins) == 0 && (best == 0 || off(bins) < off(best))) best = bins;
    }
    if (best > 0) return best;
  }
  return wanted;
}

MapOptions mapOptions(const Commission& known, const std::string& rig) {
  MapOptions options;
  options.rig = rig;
  options.bins = known.sweeps.bins;
  options.turns = known.sweeps.turns;
  options.torqueConstant_Nm_per_A = known.torquePerAmpere_Nm();
  options.noiseRms_A = known.noiseRms_A;
  options.zeroError_A = known.eventsZeroError_A;
  options.scaleError = torqueScaleError(known);
  // A position loop leaves the rotor at the same place of its count turn after turn.
  const double counts = known.identity.countsPerRev;
  const double count_rad = counts > 0.0 ? turn_rad / counts : 0.0;
  options.angleError_rad = std::hypot(known.indexAngle_rad.standardError, count_rad / std::sqrt(12.0));
  return options;
}

void remarkMissed(Commission& known) {
  if (known.missed == 0) return;
  known.remark(message("{} breakaways could not be measured; their bins rest on their neighbours.", known.missed));
}

void remarkMap(Commission& known) {
  known.map.remarks.assign(known.contradictions.begin(), known.contradictions.end());
  const double zero_Nm = known.torquePerAmpere_Nm() * known.eventsZeroError_A;
  const double scale = known.motor.currentGain.standardError / known.motor.currentGain.value;
  for (const Message& words : wordsOf(shaftLoad(known.map, zero_Nm, scale), known.map.axis)) {
    known.remark(words);
    known.map.remarks.push_back(words);
  }
  const auto drift = frictionDrift(known.events);
  const auto words = drift ? wordsOf(*drift) : std::nullopt;
  if (!words) return;
  known.remark(*words);
  known.map.remarks.push_back(*words);
}

void takeAverages(Commission& known) {
  const double doubt = known.motor.currentGain.standardError / known.motor.currentGain.value;
  known.motor.coulomb_Nm = known.map.coulombAverage_Nm;
  known.motor.viscous_Nm_s_per_rad = known.map.viscousAverage_Nm_s_per_rad;
  for (Estimate* one : {&known.motor.coulomb_Nm, &known.motor.viscous_Nm_s_per_rad})
    one->standardError = std::hypot(one->standardError, doubt * one->value);
}

}  // namespace breakaway
