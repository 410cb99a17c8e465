#include "commission/sweep_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

VelocityFrictionOptions frictionOptions(const Commission& known) {
  VelocityFrictionOptions options;
  options.torqueConstant_Nm_per_A = known.torquePerAmpere_Nm();
  options.inertia_kg_m2 = known.motor.inertia_kg_m2.value;
  const Estimate& Kt = known.motor.torqueConstant_Nm_per_A;
  options.scaleError = Kt.value > 0.0 ? Kt.standardError / Kt.value : 0.0;
  options.noiseRms_A = known.noiseRms_A;
  options.zeroError_A = known.runsZeroError_A;
  options.bins = known.sweeps.bins;
  return options;
}

MapOptions mapOptions(const Commission& known, const std::string& rig) {
  MapOptions options;
  options.rig = rig;
  options.bins = known.sweeps.bins;
  options.turns = known.sweeps.turns;
  options.torqueConstant_Nm_per_A = known.torquePerAmpere_Nm();
  options.noiseRms_A = known.noiseRms_A;
  options.zeroError_A = known.eventsZeroError_A;
  return options;
}

void remarkMissed(Commission& known) {
  if (known.missed == 0) return;
  known.remark(std::to_string(known.missed) +
               " breakaways could not be measured; their bins rest on their neighbours.");
}

void takeAverages(Commission& known) {
  const double doubt = known.motor.currentGain.standardError / known.motor.currentGain.value;
  known.motor.coulomb_Nm = known.map.coulombAverage_Nm;
  known.motor.viscous_Nm_s_per_rad = known.map.viscousAverage_Nm_s_per_rad;
  for (Estimate* one : {&known.motor.coulomb_Nm, &known.motor.viscous_Nm_s_per_rad})
    one->standardError = std::hypot(one->standardError, doubt * one->value);
}

}  // namespace breakaway
