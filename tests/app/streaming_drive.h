// A drive that does nothing but deliver samples at a rate, dated by the machine's own clock.
#pragma once

#include <chrono>
#include <cmath>

#include "experiment/drive.h"

namespace breakaway::test {

/// One clock for all processes.
inline double steadyNow_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class StreamingDrive : public Drive {
 public:
  explicit StreamingDrive(double rate_Hz) : next_s_(steadyNow_s()) {
    identity_ = {"streaming drive", "test 1.0", true, rate_Hz, 4096.0, 24.0, true};
  }

  const Identity& identity() const override { return identity_; }
  ControllerSettings settings() const override { return {}; }
  Result<ControllerSettings> configure(const ControllerSettings& wanted) override { return wanted; }
  void command(const Command&) override {}
  void start(std::shared_ptr<Procedure>) override {}
  void stop(const Saying&) override {}
  Result<size_t> advance(double, std::vector<Sample>& samples) override {
    for (const double until_s = steadyNow_s(); next_s_ < until_s; next_s_ += 1.0 / identity_.loopRate_Hz)
      samples.push_back(at(next_s_));
    return size_t{0};
  }

  static Sample at(double time_s) {
    Sample sample;
    sample.time_s = time_s;
    sample.angle_rad = 3.0 * std::sin(2.0 * time_s);
    sample.velocity_rad_per_s = 6.0 * std::cos(2.0 * time_s) + 0.1 * std::sin(977.0 * time_s);
    sample.current_A = 0.2 + 0.05 * std::sin(631.0 * time_s);
    sample.disturbance_estimate_Nm = 0.01 * std::sin(0.7 * time_s);
    sample.supply_V = 24.0;
    return sample;
  }

 private:
  Identity identity_;
  double next_s_;
};

}  // namespace breakaway::test
