// A linear axis' commissioning while it runs: what is known so far, and one function per chapter.
#pragma once

#include <array>

#include "commission/commission.h"
#include "commission/commission_steps.h"
#include "commission/travel_plan.h"

namespace breakaway {

/// What commissionLinear() does, in its order. The chapters lie in linear_motor.cpp and commission_linear.cpp.
class LinearJob {
 public:
  LinearJob(Drive& drive, const CommissionOptions& options)
      : drive_(drive), options_(options), steps_(drive, options, done_, kept_) {}
  Result<Commission> run();

 private:
  Result<void> zero();
  Result<void> findEnds();
  Result<void> identify();
  Result<void> setScale();
  void lineariseBoard();
  Result<void> tune();
  Result<void> home();
  Result<void> layBins();
  Result<void> sweepVelocity();
  Result<void> sweepBreakaway();
  Result<void> drawMap(const TravelBreakawayOptions& measured, double zeroError_A);
  Result<void> takeFriction(const TravelFriction& friction);
  Result<void> compensate();
  void joinMass(const Estimate& bySweep);
  void fillBench();
  KnownAxis known() const;

  Drive& drive_;
  const CommissionOptions& options_;
  Commission done_;
  CommissionProgress kept_;
  CommissionSteps steps_;
  Travel travel_;    ///< as the encoder counts it
  TravelBins bins_;  ///< likewise
  std::array<double, 2> expected_A_{0.0, 0.0};
  bool linearised_ = false;  ///< the board takes its voltages through the inverse of the bridge's curve
  double shownResistance_ohm_ = 0.0, zeroError_A_ = 0.0;
  TravelPace pace_;
};

}  // namespace breakaway
