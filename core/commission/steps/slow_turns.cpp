// What a rotor's friction does between standing and moving. Where that can't be seen, a compensation goes without it.
#include <algorithm>

#include "base/numbers.h"
#include "commission/steps.h"
#include "commission/sweep_layout.h"
#include "experiment/slow_turns.h"
#include "identify/stribeck_velocity.h"

namespace breakaway {

namespace {

constexpr double longestTurn_runs = 5.0;  // of the velocity sweep, that a slow turn may take

class Slow : public Step {
 public:
  Slow() : Step("slow turns", {Known::map, Known::straight, Known::carefulGains}, {Known::stribeck}) {}
  double expected_s(const SweepSettings&) const override { return 50.0; }

  Result<StepRun> begin(OnBench& on) override {
    SlowTurnsOptions options;
    // In a short job the slowest turn is a little faster.
    const double slowest = std::max(0.5, turn_rad / (longestTurn_runs * on.known.sweeps.speedRun_s));
    options.speeds_rad_per_s = {4.0, 2.0, 1.0, std::min(slowest, 0.8)};
    options.zeroing_s = sensorZeroing_s(on.known);
    slow_ = std::make_shared<SlowTurns>(options);
    return StepRun{"07-slow-turns", slow_};
  }

  Result<StepEnd> end(OnBench& on, const Result<void>& ran) override {
    Commission& known = on.known;
    if (ran)
      known.map.stribeckVelocity_rad_per_s = stribeckVelocity(slow_->turns(), known.map, known.torquePerAmpere_Nm());
    if (!(known.map.stribeckVelocity_rad_per_s.value > 0.0))
      known.remark(message(
          "Slow turns don't show over which speed friction falls from static to Coulomb; compensation goes without "
          "static friction."));
    return StepEnd::over;
  }

 private:
  std::shared_ptr<SlowTurns> slow_;
};

}  // namespace

StepPtr slowTurnsStep() {
  return std::make_unique<Slow>();
}

}  // namespace breakaway
