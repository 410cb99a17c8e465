// How long a diagnosis takes, and how much memory, from 10 s to 10 min at 1 kHz with the whole catalogue on one core.
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "base/statistics.h"
#include "diagnose/diagnosis.h"
#include "support/driven_recording.h"

using namespace breakaway;

namespace {

constexpr double count = 2.0 * std::numbers::pi / 4096.0;
constexpr double namedTarget_s = 1.0, elapsedTarget_s = 5.0;  ///< at 60 s
constexpr double memoryTarget_MB = 500.0;                     ///< at 600 s

/// A servo driven by voltage, its current recorded, that conceals a Stribeck excess and cogging.
Model servo() {
  const auto fixed = [](const char* name, double value) { return Parameter{name, value, value, value}; };
  Model model;
  model.input = DriveInput::voltage;
  model.count = count;
  model.base = {fixed("torque_constant_Nm_per_A", 0.07),
                fixed("back_emf_constant_V_s_per_rad", 0.07),
                fixed("resistance_ohm", 1.2),
                fixed("inductance_H", 0.0011),
                fixed("inertia_kg_m2", 6e-5),
                fixed("viscous_Nm_s_per_rad", 2e-5),
                fixed("coulomb_Nm", 0.012)};
  model.effects = {{"stribeck", {fixed("excess_Nm", 0.005), fixed("velocity_rad_per_s", 2.0), fixed("exponent", 2.0)}},
                   {"cogging", {fixed("amplitude_Nm", 0.003), fixed("phase_rad", 0.7), fixed("order", 12.0)}}};
  return model;
}

Bench bench() {
  Bench out;
  out.input = DriveInput::voltage;
  out.countsPerUnit = 4096.0;
  out.motor.torqueConstant = out.motor.backEmfConstant = 0.07;
  out.motor.resistance_ohm = 1.3;
  out.motor.inductance_H = 0.001;
  out.motor.inertia = 7e-5;
  out.trusted = {"torque_constant_Nm_per_A"};
  return out;
}

Recording recorded(double seconds) {
  const Recording exact = test::drivenRecording(servo(), {.seconds = seconds, .size = 3.0});
  Random random(1);
  std::vector<Channel> channels;
  for (const char* name : {"time_s", "angle_rad", "voltage_V", "current_A"}) {
    const auto values = exact.channel(name);
    channels.push_back({name, {values.begin(), values.end()}});
  }
  for (double& angle : channels[1].values) angle = count * std::floor(angle / count);
  for (double& current : channels[3].values) current += 0.01 * random.normal();
  return *Recording::seal("bench.csv", channels);
}

double peakMemory_MB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

struct Stage {
  double at_s;
  std::string activity;
};

double diagnosed(double seconds) {
  const Recording recording = recorded(seconds);
  const auto start = std::chrono::steady_clock::now();
  const auto since = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  std::vector<Stage> stages;
  DiagnoseOptions options;
  options.progress = [&](double, const std::string& activity) {
    if (stages.empty() || stages.back().activity != activity) stages.push_back({since(), activity});
  };
  const auto diagnosis = diagnose(bench(), {recording}, {}, options);
  if (!diagnosis) {
    std::printf("%.0f s: %s\n", seconds, diagnosis.error().message().c_str());
    return 0.0;
  }
  std::string names;
  for (const Finding& finding : diagnosis->findings) names += " " + finding.effect;
  std::printf("%4.0f s: named after %.2f s, all after %.2f s, %.0f MB at most;%s\n", seconds, diagnosis->named_s,
              diagnosis->elapsed_s, peakMemory_MB(), names.c_str());
  for (size_t k = 0; k < stages.size(); ++k) {
    const double end = k + 1 < stages.size() ? stages[k + 1].at_s : diagnosis->elapsed_s;
    std::printf("        %5.2f s %s\n", end - stages[k].at_s, stages[k].activity.c_str());
  }
  if (seconds == 60.0)
    std::printf("        target: %.0f s to the names, %.0f s in all\n", namedTarget_s, elapsedTarget_s);
  return diagnosis->elapsed_s;
}

}  // namespace

int main() {
  const double shortest = diagnosed(10.0);
  diagnosed(60.0);
  const double longest = diagnosed(600.0);
  std::printf("60 times the data took %.0f times as long; target at most 60, and %.0f MB\n", longest / shortest,
              memoryTarget_MB);
  return 0;
}
