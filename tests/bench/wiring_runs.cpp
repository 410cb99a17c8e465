#include "bench/wiring_runs.h"

#include <fmt/core.h>
#include <QCoreApplication>
#include <QProcess>
#include <algorithm>
#include <cmath>

#include "commission/job.h"
#include "firmware_link/simulated_shaft.h"
#include "firmware_link/transport/open_board.h"
#include "support/temporary.h"
#include "support/wired_rig.h"

namespace breakaway::test {

namespace {

constexpr double slice_s = 0.25;
constexpr double honest = 1.05;    // of a speed: noise and overshoot of a sound loop
constexpr double overshoot = 1.5;  // of a reference, likewise, as the board's watch allows
constexpr double atRest = 0.02;    // of the fastest step's speed

struct Unit {
  std::string stop, load;
  double friction = 0.0;  ///< Nm, N
};

Unit unitOf(const std::string& preset) {
  if (preset == "linear") return {"stop_at_m", "load_N", 5.0};
  return {"stop_at_rad", "load_Nm", preset == "geared" ? 0.018 : 0.017};
}

/// Whether any of the words stands in what was said.
bool holdsAny(const std::string& said, const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& one) { return said.find(one) != std::string::npos; });
}

std::string said(const Commission& known) {
  std::string all;
  if (known.wiring) {
    for (const std::string& one :
         inWords(*known.wiring, known.sensorZero_A, known.noiseRms_A, known.identity.supply_V, known.identity.axis))
      all += one + " ";
  }
  for (const std::string& one : known.remarks) all += one + " ";
  return all;
}

/// Drives a job to its end; `each` sees the samples of a slice.
template <typename Each>
void driveTo(Job& job, Drive& drive, const Each& each) {
  std::vector<Sample> samples;
  job.begin(drive);
  while (job.running()) {
    samples.clear();
    const auto lost = drive.advance(slice_s, samples);
    if (!lost) {
      job.stop(drive, lost.error().fact);
      return;
    }
    if (!job.seeksCause()) each(samples);
    job.take(drive, slice_s, samples, *lost);
  }
}

/// Follows the shaft from the fault on.
class Astray {
 public:
  Astray(const std::vector<StepSpan>& sound, double from_s) : sound_(sound), from_s_(from_s) {}

  void step(const ShaftMotion& shaft, double reference_rad_per_s) {
    const double passed_s = shaft.time_s - before_s_;
    before_s_ = shaft.time_s;
    if (shaft.time_s < from_s_ || !shaft.driven) return;
    lastDriven_s_ = shaft.time_s;
    const double beyond = beyondOf(shaft, reference_rad_per_s);
    if (beyond <= 0.0) return;
    if (began_s_ < 0.0) began_s_ = shaft.time_s;
    travel_ += beyond * passed_s;
    fastest_ = std::max(fastest_, beyond);
  }
  void report(WiringRun& run) const {
    run.beyond_rad = travel_;
    run.beyond_rad_per_s = fastest_;
    run.tripped_s = std::max(0.0, lastDriven_s_ - (began_s_ < 0.0 ? from_s_ : began_s_));
  }

 private:
  double beyondOf(const ShaftMotion& shaft, double reference) const {
    const double speed = std::abs(shaft.velocity_rad_per_s);
    double fastest = 0.0, allowed = 0.0;
    for (const StepSpan& one : sound_) {
      fastest = std::max(fastest, one.fastest_rad_per_s);
      if (shaft.time_s >= one.begin_s - slice_s && shaft.time_s <= one.end_s + slice_s)
        allowed = std::max(allowed, one.fastest_rad_per_s);
    }
    const double aside = atRest * fastest;
    if (reference != 0.0) {
      const bool along = reference * shaft.velocity_rad_per_s > 0.0;
      return speed - (along ? overshoot * std::abs(reference) : 0.0) - aside;
    }
    return speed - honest * (allowed > 0.0 ? allowed : fastest) - aside;
  }

  const std::vector<StepSpan>& sound_;
  double from_s_, before_s_ = 0.0, lastDriven_s_ = 0.0, travel_ = 0.0, fastest_ = 0.0;
  double began_s_ = -1.0;  ///< when it went astray; before that negative
};

/// The preset's rig with that fault, as a file.
std::string fileWith(const TemporaryFolder& folder, const WiringFault& fault, const std::string& preset,
                     double from_s) {
  const std::string value = fault.value.empty() ? "" : ", \"value\": " + fault.value;
  return folder.write(preset + ".rig.json",
                      wiredRig(preset, fmt::format(R"({{"fault": "{}"{}, "from_s": {}}})", fault.name, value, from_s)));
}

WiringRun outcomeOf(Job& job, const WiringFault& fault) {
  WiringRun run;
  const bool done = job.status().state == Procedure::State::finished;
  run.status = done ? 0 : 1;
  run.words = done ? said(job.known()) : job.failure().message();
  // A cause that the wiring check has found counts alone: its symptom stands behind it.
  const std::string cause = run.words.substr(0, run.words.find("(found by a wiring check"));
  run.named = (run.status != 0 || fault.may) && holdsAny(cause, fault.words);
  return run;
}

}  // namespace

std::vector<WiringFault> wiringFaults(const std::string& preset) {
  const Unit unit = unitOf(preset);
  const auto number = [](double value) { return fmt::format("{:.3g}", value); };
  const bool linear = preset == "linear";
  std::vector<WiringFault> all{
      {"encoder_reversed", "", {"swap the encoder's A and B", "the encoder jumped"}},
      {"encoder_dead", "", {"the encoder stands", "encoder's cable"}},
      {"counts_factor", "4", {"4 times", "four edges", "0.25 times", "a turn has"}},
      {"counts_factor", "0.5", {"0.5 times", "two edges", "2 times", "a turn has"}},
      {"current_sensor_reversed", "", {"current sensor is reversed", "current sensor or the bridge is reversed"}},
      {"current_sensor_dead", "", {"current sensor is dead", "the sensor is dead", "it is dead"}},
      {"bridge_reversed", "", {"bridge is reversed", "bridge's inputs"}},
      {"lead_off", "", {"a lead of the motor is off", "a lead is off"}},
      {"supply_reading_factor", "2", {"divider"}},
      {"supply_reading_factor", "0.5", {"divider", "the supply dropped"}},
      {"index_inverted", "", {"inverted", "the index was seen", "the index came", "the index did not come"}},
      {unit.stop, linear ? "0.02" : "1", {"stop", "held", "blocked", "is something in its way"}, true, true},
      {unit.load, number(2.0 * unit.friction), {"a load pulls", "a load heavier", "constant load"}},
      {unit.load, number(0.5 * unit.friction), {"a load of about", "constant load"}, true},
  };
  if (!linear) all.push_back({"pendulum_Nm", number(0.5 * unit.friction), {"constant load", "an arm"}, true});
  return all;
}

CommissionOptions shortJob(const std::string& rigFile) {
  CommissionOptions options;
  options.rig = "rig";
  if (const auto bench = readBench(benchFileBeside(rigFile))) options.bench = *bench;
  options.sweeps.bins = 36;
  options.sweeps.turns = 1;
  options.sweeps.speedRun_s = 2.0;
  options.keepRecordings = false;
  return options;
}

std::vector<StepSpan> soundSteps(const std::string& preset, unsigned seed) {
  std::vector<StepSpan> steps;
  StepSpan now;
  const TemporaryFolder folder;
  auto drive = openWatched(
      "simulated:" + folder.write(preset + ".rig.json", wiredRig(preset, "")), seed, [&now](const ShaftMotion& shaft) {
        now.end_s = shaft.time_s;
        if (shaft.driven) now.fastest_rad_per_s = std::max(now.fastest_rad_per_s, std::abs(shaft.velocity_rad_per_s));
      });
  if (!drive) qFatal("%s", drive.error().message().c_str());
  CommissionOptions options = shortJob(*rigFileOf("simulated:" + preset));
  options.keepRecordings = true;
  options.recordingRate_Hz = 10.0;
  options.keepRecording = [&](const std::string& name, const Recording&) -> Result<void> {
    now.name = name;
    steps.push_back(now);
    now = {"", now.end_s, now.end_s, 0.0};
    return {};
  };
  Job job(options, {Known::comparison});
  driveTo(job, **drive, [](const std::vector<Sample>&) {});
  if (job.status().state != Procedure::State::finished)
    qFatal("%s: %s", preset.c_str(), job.failure().message().c_str());
  return steps;
}

WiringRun runWith(const WiringFault& fault, const std::string& preset, double from_s,
                  const std::vector<StepSpan>& sound, unsigned seed) {
  const TemporaryFolder folder;
  std::vector<ShaftMotion> motions;
  auto drive = openWatched("simulated:" + fileWith(folder, fault, preset, from_s), seed,
                           [&motions](const ShaftMotion& shaft) { motions.push_back(shaft); });
  if (!drive) qFatal("%s", drive.error().message().c_str());
  Astray astray(sound, from_s);
  Job job(shortJob(*rigFileOf("simulated:" + preset)), {Known::comparison});
  driveTo(job, **drive, [&](const std::vector<Sample>& samples) {
    for (size_t k = 0; k < std::min(samples.size(), motions.size()); ++k)
      astray.step(motions[k], samples[k].velocity_reference_rad_per_s);
    motions.clear();
  });
  WiringRun run = outcomeOf(job, fault);
  astray.report(run);
  return run;
}

WiringRun runOverTerminal(const WiringFault& fault, const std::string& preset, double from_s, unsigned seed) {
  const TemporaryFolder folder;
  QProcess board;
  board.start(QCoreApplication::applicationDirPath() + "/breakaway-board",
              {"--pace", "granted", "--seed", QString::number(seed), "--rig",
               QString::fromStdString(fileWith(folder, fault, preset, from_s))});
  if (!board.waitForStarted() || !board.waitForReadyRead(10000)) qFatal("breakaway-board does not start");
  auto drive = openBoard({.uri = QString::fromUtf8(board.readLine()).trimmed().toStdString()});
  if (!drive) qFatal("%s", drive.error().message().c_str());
  double last_s = from_s;
  Job job(shortJob(*rigFileOf("simulated:" + preset)), {Known::comparison});
  driveTo(job, **drive, [&last_s](const std::vector<Sample>& samples) {
    for (const Sample& one : samples) {
      if (one.enabled) last_s = std::max(last_s, one.time_s);
    }
  });
  WiringRun run = outcomeOf(job, fault);
  run.tripped_s = last_s - from_s;
  drive->reset();
  board.terminate();
  board.waitForFinished();
  return run;
}

}  // namespace breakaway::test
