// A rotor turning to and fro slowly until something else is asked of it.
#pragma once

#include <optional>

#include "experiment/drive.h"

namespace breakaway {

/// Commands ω(t) = amplitude · sin(2π t / period) from the first sample on; it never ends by itself.
class SlowTurning : public Procedure {
 public:
  struct Options {
    double amplitude_rad_per_s = 6.0;
    double period_s = 4.0;
  };

  explicit SlowTurning(const Options& options) : options_(options) {}

  Command step(const Sample& sample) override;
  Status status() const override { return status_; }
  void stop(const std::string& reason) override;

 private:
  Options options_;
  Status status_{State::running, 0.0, 0.0, "turning slowly to and fro", ""};
  std::optional<double> start_s_;
};

}  // namespace breakaway
