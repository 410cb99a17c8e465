// A linear axis going to and fro slowly around the middle of its travel, until something else is asked.
#pragma once

#include "experiment/drive.h"
#include "experiment/travel.h"

namespace breakaway {

/// Glides between two places at a quarter and three quarters of the travel between the margins; it never ends by
/// itself.
class SlowStrokes : public Procedure {
 public:
  /// `travel`: as the encoder counts it; `tick_s`: of the board's control loop.
  SlowStrokes(const Travel& travel, double tick_s);

  Command step(const Sample& sample) override;
  Status status() const override { return status_; }
  void stop(const std::string& reason) override;

 private:
  Travel travel_;
  double tick_s_;
  Glide glide_;
  double way_ = 1.0;
  Status status_{State::running, 0.0, 0.0, "going to and fro slowly", ""};
};

}  // namespace breakaway
