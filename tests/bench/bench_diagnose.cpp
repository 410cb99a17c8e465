// How long a diagnosis takes on one core with the whole catalogue: of each effect alone in 60 s at 1 kHz, and how time
// and memory grow from 10 s to 10 min.
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "base/statistics.h"
#include "diagnose/diagnosis.h"
#include "diagnose/effects/catalogue.h"
#include "score/scored_trial.h"
#include "support/driven_recording.h"
#include "support/processor_time.h"
#include "trial/sealed_trial.h"

using namespace breakaway;
using namespace breakaway::test;

namespace {

constexpr double count = 2.0 * std::numbers::pi / 4096.0;
constexpr double namedTarget_s = 1.0, elapsedTarget_s = 5.0;  ///< at 60 s
constexpr std::uint64_t trialSeed = 9001;
constexpr double memoryTarget_MB = 500.0;  ///< at 600 s

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

/// Seconds of processor time by what the diagnosis was at.
class Stages {
 public:
  explicit Stages(DiagnoseOptions& options) {
    options.progress = [this](double, const std::string& activity) {
      if (stages_.empty() || stages_.back().activity != activity) stages_.push_back({time_.elapsed_s(), activity});
    };
  }
  double elapsed_s() const { return time_.elapsed_s(); }
  void print() const {
    const double end_s = elapsed_s();
    for (size_t k = 0; k < stages_.size(); ++k) {
      const double end = k + 1 < stages_.size() ? stages_[k + 1].at_s : end_s;
      std::printf("        %5.2f s %s\n", end - stages_[k].at_s, stages_[k].activity.c_str());
    }
  }

 private:
  struct Stage {
    double at_s;
    std::string activity;
  };
  ProcessorTime time_;
  std::vector<Stage> stages_;
};

std::string namesOf(const Diagnosis& diagnosis) {
  std::string names;
  for (const Finding& finding : diagnosis.findings) names += " " + finding.effect;
  return names;
}

double diagnosed(double seconds) {
  const Recording recording = recorded(seconds);
  DiagnoseOptions options;
  const Stages stages(options);
  const auto diagnosis = diagnose(bench(), {recording}, {}, options);
  if (!diagnosis) {
    std::printf("%.0f s: %s\n", seconds, diagnosis.error().message().c_str());
    return 0.0;
  }
  const double cpu_s = stages.elapsed_s();
  std::printf("%4.0f s: named after %.2f s, all after %.2f s, %.2f s of processor time, %.0f MB at most;%s\n", seconds,
              diagnosis->named_s, diagnosis->elapsed_s, cpu_s, peakMemory_MB(), namesOf(*diagnosis).c_str());
  stages.print();
  return cpu_s;
}

/// Every effect alone, and a rig that lacks nothing, as sealed trials of 60 s at 1 kHz.
void diagnoseEffects() {
  std::vector<std::string> families{"clean"};
  for (const Effect* effect : catalogue()) families.emplace_back(effect->name());
  std::vector<double> named_s, elapsed_s;
  size_t agreeing = 0;
  for (const std::string& family : families) {
    SealedTrial trial = makeTrial(family, trialSeed, {.duration_s = 60.0, .row_s = 1e-3});
    trial.recordings.erase(trial.recordings.begin() + 1, trial.recordings.end());
    const ProcessorTime time;
    const auto diagnosis = diagnose(trial.bench, trial.recordings, {}, {});
    const double cpu_s = time.elapsed_s();
    if (!diagnosis) {
      std::printf("%-28s %s\n", family.c_str(), diagnosis.error().message().c_str());
      continue;
    }
    const ScoredTrial scored = judge(trial, diagnosis);
    named_s.push_back(diagnosis->named_s);
    elapsed_s.push_back(cpu_s);
    agreeing += scored.agrees ? 1 : 0;
    std::printf("%-28s named after %5.2f s, all after %5.2f s of processor time;%s\n", family.c_str(),
                diagnosis->named_s, cpu_s, namesOf(*diagnosis).c_str());
  }
  std::printf(
      "median: named after %.2f s, all after %.2f s of processor time; target: %.0f s, %.0f s; first names final in "
      "%zu of %zu\n",
      quantile(named_s, 0.5), quantile(elapsed_s, 0.5), namedTarget_s, elapsedTarget_s, agreeing, named_s.size());
}

}  // namespace

int main() {
  diagnoseEffects();
  const double shortest = diagnosed(10.0);
  diagnosed(60.0);
  const double longest = diagnosed(600.0);
  std::printf("60 times the data took %.0f times as long; target at most 60, and %.0f MB\n", longest / shortest,
              memoryTarget_MB);
  return 0;
}
