// Homing to the encoder's index: one direction, one edge.
#pragma once

#include <vector>

#include "base/estimate.h"
#include "experiment/timed_procedure.h"

namespace breakaway {

struct HomingOptions {
  double searchSpeed_rad_per_s = 3.0;
  double approachSpeed_rad_per_s = 0.8;  ///< towards growing angle, always
  double backOff_rad = 0.25;
  double indexTolerance_rad = 0.02;  ///< between two sights of one edge
  size_t approaches = 3;             ///< passes over the edge that are averaged
  double mostTurns = 1.5;            ///< of the search, and from one sight of the index to the next
  double timeout_s = 60.0;
  double stall_s = 3.0;          ///< without any motion while it should move
  double countsPerRev = 0.0;     ///< of the encoder, for the result's standard error; 0: unknown
  double current_limit_A = 0.0;  ///< 0: the controller's own
};

/// Searches the index towards growing angle, turns on to see it once more after exactly a turn, backs off, and passes
/// its edge slowly from the same side a few times; one leg, so that a board may run it. Where it comes elsewhere, the
/// next one tells whether a turn has other counts. Fails in words when there is no index within mostTurns, when it
/// comes at two places, when the rotor doesn't move, or at the time-out.
class Homing : public TimedProcedure {
 public:
  explicit Homing(const HomingOptions& options = {}) : options_(options) {}

  /// The index in the board's angle, rounded down by the encoder like every angle, so that the difference of both is
  /// without bias; valid when finished.
  Estimate indexAngle_rad() const;
  /// Whether a homing that says this of itself still looks for the index, within its `mostTurns`.
  static bool searches(const Message& activity) { return activity == searching(); }
  size_t passes() const { return edges_.size(); }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  static Message searching() { return message("searching the index counter-clockwise"); }
  using Machine = HomingLeg<double>;
  Message activity() const;
  Leg plan() const;
  void follow(const Sample& sample);
  Message failureOf(LegPhase phase, double since_rad) const;
  Message seenElsewhere(double since_rad) const;
  Message notAgain() const;
  Message declared() const;
  double tolerance_rad() const;

  HomingOptions options_;
  LegPhase stage_ = notBegun;
  std::vector<double> edges_;
  std::vector<double> sights_rad_;   ///< of the index while it is verified, from the first one on
  size_t rows_ = 0, indexRows_ = 0;  ///< samples, and those that show the index
  double stageAngle_rad_ = 0.0, lastAngle_rad_ = 0.0, leastTick_s_ = 0.0;
};

}  // namespace breakaway
