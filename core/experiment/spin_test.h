// Voltage up and down both ways: what back-EMF constant, inertia and average friction are read from.
#pragma once

#include <optional>
#include <vector>

#include "experiment/open_current.h"
#include "experiment/spin_block.h"
#include "experiment/timed_procedure.h"

namespace breakaway {

struct SpinTestOptions {
  double highest_V = 0.0;  ///< 0: half the supply
  double leg_s = 1.5;      ///< from zero to the highest voltage, or back
  size_t cycles = 4;       ///< of up, down, up the other way, down
  double block_s = 0.01;
  double current_limit_A = 0.0;  ///< 0: the controller's own
  double rest_s = 0.2;           ///< with open windings before and after, to see whether the current sensor drifts
  double stall_s = 0.6;          ///< above 0.6 of the highest voltage without any motion
  double mostDrift_A = 0.1;      ///< of the current sensor's zero, from the first rest to the last
};

/// Gathers the samples of one block after the other.
class BlockMeans {
 public:
  /// `centred`: the current is the mean between samples, for tests whose currents change within a few ticks; else it is
  /// the samples' own, half a tick late.
  explicit BlockMeans(double block_s, bool centred = false) : block_s_(block_s), centred_(centred) {}
  /// The block that this sample completes, if any; `tick_s` is the time since the sample before, 0 at the first.
  std::optional<SpinBlock> add(const Sample& sample, double tick_s);

 private:
  double block_s_, acting_V_ = 0.0, before_A_ = 0.0;
  bool centred_;
  SpinBlock sum_;
  size_t count_ = 0;
};

/// Fails in words when the rotor doesn't move, and when the current sensor drifts.
class SpinTest : public TimedProcedure {
 public:
  explicit SpinTest(const SpinTestOptions& options = {}) : options_(options), means_(options.block_s) {}
  const std::vector<SpinBlock>& blocks() const { return blocks_; }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override { return timed(elapsed_s_, whole_s(), message("spinning both ways by voltage")); }

 private:
  Command rest(const Sample& sample, bool last);
  void watchMotion(const Sample& sample);
  double whole_s() const { return 4.0 * options_.leg_s * static_cast<double>(options_.cycles); }
  SpinTestOptions options_;
  std::vector<SpinBlock> blocks_;
  BlockMeans means_;
  double elapsed_s_ = 0.0, commanded_V_ = 0.0;
  double movedAngle_rad_ = 0.0, stalled_s_ = 0.0;
  OpenCurrent open_A_;
};

}  // namespace breakaway
