// Constant current to and fro: the rotor is braked, turned round and sped up again by the same current.
#pragma once

#include <vector>

#include "experiment/spin_test.h"
#include "experiment/timed_procedure.h"

namespace breakaway {

struct ReversalTestOptions {
  double current_A = 0.0;          ///< of either sign in turn
  double breakaway_A = 0.0;        ///< that it took where it was tried; elsewhere it may take half as much again
  double highest_rad_per_s = 0.0;  ///< the current is turned round at 70 to 100 % of it
  size_t reversals = 20;
  double block_s = 0.005;
  double most_s = 4.0;  ///< from one reversal to the next
};

/// Turns the current round whenever the speed is reached. Fails in words when it isn't reached in time.
class ReversalTest : public TimedProcedure {
 public:
  explicit ReversalTest(const ReversalTestOptions& options);
  const std::vector<SpinBlock>& blocks() const { return blocks_; }
  /// Whether it failed because the rotor stood though the current breaks it loose anywhere.
  bool stood() const { return stood_; }

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override;

 private:
  ReversalTestOptions options_;
  std::vector<SpinBlock> blocks_;
  BlockMeans means_;
  bool stood_ = false;
  size_t done_ = 0;
  double turned_s_ = 0.0, way_ = 1.0, now_s_ = 0.0;
};

}  // namespace breakaway
