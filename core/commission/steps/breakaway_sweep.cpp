// What starts a rotor from standstill, angle by angle, both ways.
#include <algorithm>

#include "commission/steps.h"
#include "commission/sweep_layout.h"
#include "experiment/breakaway_sweep.h"

namespace breakaway {

namespace {

/// The line from command to current that breakaway ramps follow: what the board doesn't straighten, as a tangent.
WindingLine rampLine(const Commission& known) {
  WindingLine line;
  line.resistance_ohm.value = known.shownResistance_ohm;
  if (known.linearised) return line;
  line.deadZone_V = known.motor.deadZone_V;
  const DutyCurve& curve = known.motor.dutyCurve;
  if (!curve.known()) return line;
  const double supply_V = known.identity.supply_V;
  const double near_A = std::max({known.expected_A[0], known.expected_A[1], 1e-3});
  const auto volts = [&](double current_A) {
    return supply_V * curve.input(known.shownResistance_ohm * current_A / supply_V);
  };
  line.resistance_ohm.value = (volts(1.2 * near_A) - volts(0.8 * near_A)) / (0.4 * near_A);
  line.deadZone_V.value = volts(near_A) - line.resistance_ohm.value * near_A;
  return line;
}

std::vector<std::pair<std::string, double>> settingsOf(const BreakawaySweepOptions& options, size_t missed) {
  return {{"torque_constant_Nm_per_A", options.torqueConstant_Nm_per_A},
          {"resistance_ohm", options.resistance_ohm},
          {"dead_zone_V", options.deadZone_V},
          {"inertia_kg_m2", options.inertia_kg_m2},
          {"dwell_s", options.dwell_s},
          {"settle_s", options.settle_s},
          {"ramp_s", options.ramp_s},
          {"motion_velocity_rad_per_s", options.motionVelocity_rad_per_s},
          {"motion_counts", static_cast<double>(options.motionCounts)},
          {"index_angle_rad", options.indexAngle_rad},
          {"missed", static_cast<double>(missed)}};
}

class Breakaways : public Step {
 public:
  Breakaways()
      : Step("breakaway sweep",
             {Known::sensorZero, Known::motor, Known::straight, Known::carefulGains, Known::index, Known::runs},
             {Known::breakaways}) {}
  double expected_s(const SweepSettings& sweeps) const override {
    return 1.1 * static_cast<double>(2 * sweeps.bins * sweeps.turns);
  }

  Result<StepRun> begin(OnBench& on) override {
    Commission& known = on.known;
    const IdentifiedMotor& motor = known.motor;
    const WindingLine line = rampLine(known);
    options_.bins = known.sweeps.bins;
    options_.turns = known.sweeps.turns;
    options_.indexAngle_rad = known.indexAngle_rad.value;
    options_.torqueConstant_Nm_per_A = known.torquePerAmpere_Nm();
    options_.resistance_ohm = line.resistance_ohm.value;
    options_.deadZone_V = line.deadZone_V.value;
    options_.inertia_kg_m2 = motor.inertia_kg_m2.value;
    options_.backEmfConstant_V_s_per_rad = motor.backEmfConstant_V_s_per_rad.value;
    options_.expected_A = known.expected_A;
    for (const Way way : {Way::cw, Way::ccw})
      options_.moving_A[static_cast<size_t>(way)] = movingCurrent_A(known.runs, way, frictionOptions(known));
    options_.countsPerRev = known.identity.countsPerRev;
    options_.zeroing_s = sensorZeroing_s(known);
    options_.indexTolerance_rad = indexTolerance_rad(options_.countsPerRev);
    options_.zeroEvery_s = 20.0 * std::max(0.5, options_.zeroing_s);
    options_.current_limit_A = known.settings.current_limit_A;
    sweep_ = std::make_shared<BreakawaySweep>(options_, known.breakaways);
    before_ = sweep_->events().size();
    return StepRun{"06-breakaway-sweep", sweep_};
  }

  bool gather(Commission& known) override {
    const bool more = known.breakaways.size() != sweep_->events().size();
    known.breakaways = sweep_->events();
    known.missed = sweep_->missed();
    countFresh(sweep_->zeros(), known.noiseRms_A, before_, known.breakaways);
    return more;
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    Commission& known = on.known;
    const auto& events = known.breakaways;
    const ZeroTrack zeros(sweep_->zeros(), known.noiseRms_A);
    known.eventsZeroError_A = events.empty() ? 0.0 : zeros.at(events[events.size() / 2].time_s).standardError;
    known.zeroing_s = options_.zeroing_s;
    known.zeroings = sweep_->zeros().size();
    known.howMeasured = settingsOf(options_, known.missed);
    remarkMissed(known);
    return StepEnd::over;
  }

 private:
  BreakawaySweepOptions options_;
  std::shared_ptr<BreakawaySweep> sweep_;
  size_t before_ = 0;
};

}  // namespace

StepPtr breakawaySweepStep() {
  return std::make_unique<Breakaways>();
}

}  // namespace breakaway
