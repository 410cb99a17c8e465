// A rotor at constant speeds both ways: Coulomb and viscous friction.
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "commission/steps.h"
#include "commission/sweep_layout.h"
#include "experiment/velocity_sweep.h"

namespace breakaway {

namespace {

// In an order in which speed and time have nothing to do with each other: a zero that drifts is no viscous friction.
constexpr double sweepParts[] = {0.2, 0.6, 0.1, 1.0, 0.05, 0.35};
constexpr double leastCounts_per_s = 300.0;

/// From V = V0 + R·i + Ke·ω with friction's current and a third more, and 0.6 of it to leave room for control.
double highestSpeed(const Commission& known) {
  const IdentifiedMotor& motor = known.motor;
  const double friction_A = motor.coulomb_Nm.value / motor.torquePerShownAmpere_Nm();
  const double supply_V = known.identity.supply_V;
  const double lost_V =
      motor.dutyCurve.known() ? supply_V * (1.0 - motor.dutyCurve.output(1.0)) : motor.deadZone_V.value;
  const double perAmp_V = 1.33 * known.shownResistance_ohm;
  const double slope_A = std::max(0.0, motor.viscous_Nm_s_per_rad.value) / motor.torquePerShownAmpere_Nm();
  const double usable_V = supply_V - lost_V - perAmp_V * friction_A;
  return std::max(1.0, 0.6 * usable_V / (motor.backEmfConstant_V_s_per_rad.value + perAmp_V * slope_A));
}

/// Parts of the highest speed, whose slowest passes counts often enough to be controlled by them.
std::vector<double> partsFor(const Commission& known, double highest) {
  const double counts = known.identity.countsPerRev;
  const double slowest = counts > 0.0 ? std::min(0.4, leastCounts_per_s * turn_rad / counts / highest) : 0.0;
  if (slowest <= *std::min_element(std::begin(sweepParts), std::end(sweepParts)))
    return speedParts(sweepParts, known.sweeps.speeds, 0.06);
  return speedParts({}, known.sweeps.speeds > 0 ? known.sweeps.speeds : std::size(sweepParts), slowest);
}

class Velocities : public Step {
 public:
  Velocities()
      : Step("velocity sweep", {Known::sensorZero, Known::motor, Known::straight, Known::carefulGains, Known::index},
             {Known::runs}) {}
  double expected_s(const SweepSettings& sweeps) const override {
    const size_t speeds = sweeps.speeds > 0 ? sweeps.speeds : std::size(sweepParts);
    return 2.0 * static_cast<double>(speeds) * (sweeps.speedRun_s + 2.0);
  }

  Result<StepRun> begin(OnBench& on) override {
    Commission& known = on.known;
    const double asked = known.sweeps.highest_rad_per_s, highest = asked > 0.0 ? asked : highestSpeed(known);
    VelocitySweepOptions options;
    for (const double part : partsFor(known, highest)) options.speeds_rad_per_s.push_back(part * highest);
    options.indexAngle_rad = known.indexAngle_rad.value;
    options.countsPerRev = known.identity.countsPerRev;
    options.indexTolerance_rad = indexTolerance_rad(options.countsPerRev);
    options.bins = binsOfWholeCounts(options.countsPerRev, options.bins);
    options.run_s = known.sweeps.speedRun_s;
    options.zeroing_s = sensorZeroing_s(known);
    sweep_ = std::make_shared<VelocitySweep>(options, known.runs);
    before_ = sweep_->runs().size();
    return StepRun{"05-velocity-sweep", sweep_};
  }

  bool gather(Commission& known) override {
    std::vector<VelocityRun> runs = sweep_->runs();
    if (const VelocityRun* now = sweep_->underWay()) runs.push_back(*now);
    const bool more =
        known.runs.size() != runs.size() || (!runs.empty() && known.runs.back().duration_s != runs.back().duration_s);
    known.runs = std::move(runs);
    countFresh(sweep_->zeros(), known.noiseRms_A, before_, known.runs);
    return more;
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    if (!ran) return ran.error();
    Commission& known = on.known;
    for (const double speed : sweep_->leftOut_rad_per_s())
      known.remark(message("At {:.3g} rad/s {} the rotor sticks and slips; that speed was left out.", std::abs(speed),
                           wayText(speed > 0.0)));
    const ZeroTrack zeros(sweep_->zeros(), known.noiseRms_A);
    if (!known.runs.empty()) known.runsZeroError_A = zeros.at(known.runs[known.runs.size() / 2].middle_s).standardError;
    VelocityFrictionOptions friction = frictionOptions(known);
    friction.disc = fitDisc(known.runs, friction);
    auto moving = fitMovingFriction(known.runs, friction);
    if (!moving) return moving.error();
    known.moving = std::move(*moving);
    return StepEnd::over;
  }

 private:
  std::shared_ptr<VelocitySweep> sweep_;
  size_t before_ = 0;
};

}  // namespace

StepPtr velocitySweepStep() {
  return std::make_unique<Velocities>();
}

}  // namespace breakaway
