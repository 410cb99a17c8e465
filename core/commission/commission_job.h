// A commissioning while it runs: what is known so far, and one function per chapter of the job.
#pragma once

#include <array>
#include <optional>

#include "commission/commission.h"
#include "commission/commission_steps.h"
#include "experiment/spin_test.h"
#include "friction/measurements.h"
#include "identify/bridge_fit.h"
#include "identify/map_estimation.h"
#include "motor/winding_line.h"

namespace breakaway {

/// What commission() does, in its order. The chapters lie in commission_motor.cpp and commission_friction.cpp.
class CommissionJob {
 public:
  CommissionJob(Drive& drive, const CommissionOptions& options)
      : drive_(drive), options_(options), steps_(drive, options, done_, kept_) {}
  Result<Commission> run();

 private:
  std::optional<double> trustedTorqueConstant() const;
  Result<void> begin();
  Result<void> identify();
  Result<void> tune();
  Result<void> reverse();
  void fitWindings();
  void lineariseBoard();
  WindingLine rampLine() const;
  Result<void> setScale();
  Result<void> home();
  Result<void> sweepVelocity();
  Result<void> sweepBreakaway();
  Result<void> turnSlowly();
  Result<void> refitMoving(const std::vector<BreakawayEvent>& events, const MapOptions& options);
  void fillBench();
  VelocityFrictionOptions frictionOptions() const;
  double zeroing_s() const;

  Drive& drive_;
  const CommissionOptions& options_;
  Commission done_;
  std::array<double, 2> expected_A_{0.0, 0.0};
  CommissionProgress kept_;
  CommissionSteps steps_;
  BridgeTests bridgeTests_;
  Estimate timeConstant_s_;
  bool linearised_ = false;           ///< the board takes its voltages through the inverse of the bridge's curve
  double shownResistance_ohm_ = 0.0;  ///< with the current as the sensor shows it
  double zeroError_A_ = 0.0;          ///< over the velocity sweep
};

}  // namespace breakaway
