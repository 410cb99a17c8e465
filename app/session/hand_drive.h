// Driving by hand: a voltage, a current or a speed for as long as somebody holds a button, within limits.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "experiment/drive.h"
#include "experiment/travel.h"

namespace breakaway {

enum class HandMode { voltage, current, speed };

struct HandOptions {
  HandMode mode = HandMode::speed;
  double target = 0.0;               ///< V, A, or rad/s; its sign is the way
  double mostSpeed_rad_per_s = 0.0;  ///< beyond it the motor is let go
  double most_A = 0.0;               ///< 0: the controller's own limit
  std::optional<Travel> travel;      ///< of a linear axis: nothing is driven into its margins
};

/// What the window holds, and lets go from any thread.
struct HandGrip {
  std::atomic<bool> held{true};
};

/// Commands the target while the grip is held, and opens the windings in the tick after it is let go. It fails in words
/// when the shaft gets faster than allowed, and ends at a margin of the travel.
class HandDrive : public Procedure {
 public:
  HandDrive(const HandOptions& options, std::shared_ptr<HandGrip> grip);
  Command step(const Sample& sample) override;
  Status status() const override { return status_; }
  void stop(const Saying& reason) override;

 private:
  bool intoMargin(double position_m) const;

  HandOptions options_;
  std::shared_ptr<HandGrip> grip_;
  Status status_;
};

}  // namespace breakaway
