// The controller that the board is left with: of medium stiffness, for the motor as it is known now.
#include "commission/measured_bench.h"
#include "commission/steps.h"
#include "experiment/servo_settings.h"
#include "stability/auto_tuning.h"
#include "stability/bench_loop.h"

namespace breakaway {

namespace {

/// Of medium stiffness (autoTune()) for what is identified, within the board's present limits; noise and rounding are
/// those that the job met.
Result<ControllerSettings> mediumSettings(const Commission& done, const ControllerSettings& present) {
  Bench bench = done.bench;
  bench.controller.currentLimit_A = present.current_limit_A;
  BoardTiming timing;
  timing.tick_s = 1.0 / done.identity.loopRate_Hz;
  auto loop = loopOfBench(bench, timing);
  if (!loop) return loop.error();
  if (present.velocity_bandwidth_rad_per_s > 0.0)
    loop->board.velocityBandwidth_rad_per_s = present.velocity_bandwidth_rad_per_s;
  if (present.current_bandwidth_rad_per_s > 0.0)
    loop->board.current.bandwidth_rad_per_s = present.current_bandwidth_rad_per_s;
  // Torques are per ampere as the sensor shows it; its gain is part of the constant's doubt.
  const Estimate& trueConstant = done.motor.torqueConstant_Nm_per_A;
  const double shown = done.motor.torquePerShownAmpere_Nm();
  const Estimate constant{shown, shown * trueConstant.standardError / trueConstant.value};
  AutoTuningOptions options;
  options.noise = {roundingRms_rad(bench.count()), done.noiseRms_A};
  const auto tuning = autoTune(*loop, done.motor.inertia_kg_m2, constant, options);
  if (!tuning) return tuning.error();
  return withTuning(present, tuning->settings);
}

class TuneForUse : public Step {
 public:
  TuneForUse() : Step("tuning for use", {Known::map, Known::stribeck, Known::carefulGains}, {Known::gainsInUse}) {}

  /// Where there are no such gains, or the board takes none, it stays as it is, and a remark says so.
  Result<StepEnd> end(OnBench& on, const Result<void>&) override {
    Commission& known = on.known;
    known.bench = measuredBench(known, on.options);
    const auto medium = mediumSettings(known, known.settings);
    const auto accepted = medium ? on.drive.configure(*medium) : medium;
    known.tunedForUse = accepted.ok();
    if (accepted) {
      known.settings = *accepted;
      known.facts.remove({Known::carefulGains});
    } else {
      known.remark(message("The controller is left as it was for the measurements: {}.", accepted.error().said()));
    }
    return StepEnd::over;
  }
};

}  // namespace

StepPtr tuneForUseStep() {
  return std::make_unique<TuneForUse>();
}

}  // namespace breakaway
