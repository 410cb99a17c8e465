// Strokes to and fro by voltage: what back-EMF constant, mass and average friction are read from.
#pragma once

#include <vector>

#include "experiment/open_current.h"
#include "experiment/spin_test.h"
#include "experiment/timed_procedure.h"
#include "experiment/travel.h"

namespace breakaway {

struct TravelStrokesOptions {
  Travel travel;
  std::vector<double> voltages_V;  ///< of the strokes, one after the other
  double least_V = 0.0;            ///< that keeps it moving
  double stretch = 0.15;           ///< part of the travel in which a stroke's voltage falls by `depth` and rises again
  double depth = 0.6;              ///< part of the voltage, but not below least_V
  size_t strokes = 8;              ///< at each voltage
  double highest_m_per_s = 0.0;    ///< at which the voltage turns at the latest; 0: nowhere but by the place
  double rise_s = 0.02;            ///< from zero to the whole voltage
  double block_s = 0.002;
  double rest_s = 0.3;  ///< with open windings before and after, to see whether the current sensor drifts
  double stall_s = 0.6;
  double mostDrift_A = 0.1;
};

/// The axis is driven one way by a voltage and braked by the same voltage reversed, early enough to turn before the
/// margin. Meanwhile the voltage goes down and up again, each stroke at other places, so that each place is passed both
/// speeding up and slowing down: mass and friction can be told apart then. How much it needs to stop is learnt from
/// stroke to stroke, beginning with as much as it took to speed up. Fails in words when it doesn't move, and when the
/// current sensor drifts.
class TravelStrokes : public TimedProcedure {
 public:
  explicit TravelStrokes(TravelStrokesOptions options);
  /// Means over equal times, as a spin test leaves them.
  const std::vector<SpinBlock>& blocks() const { return blocks_; }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  Command rest(const Sample& sample);
  Command stroke(const Sample& sample);
  Command towards(double wanted_V);
  void turnRound(const Sample& sample);
  size_t all() const { return options_.strokes * options_.voltages_V.size(); }
  double voltage_V() const {
    return options_.voltages_V[std::min(done_ / options_.strokes, options_.voltages_V.size() - 1)];
  }

  TravelStrokesOptions options_;
  std::vector<SpinBlock> blocks_;
  BlockMeans means_;
  OpenCurrent open_A_;
  double way_ = 1.0, start_m_ = 0.0, switch_m_ = 0.0, furthest_m_ = 0.0, stopShare_ = 1.0;
  double now_V_ = 0.0;
  double moved_m_ = 0.0, moved_s_ = 0.0, phase_s_ = 0.0;
  size_t done_ = 0;
  bool braking_ = false, resting_ = true;
};

}  // namespace breakaway
