// A linear axis going to a place and stopping there.
#pragma once

#include "experiment/timed_procedure.h"
#include "experiment/travel.h"

namespace breakaway {

/// Glides to `target_m`; ends there, and in words when it doesn't arrive in time.
class TravelTo : public TimedProcedure {
 public:
  TravelTo(double target_m, double tolerance_m, const Glide& glide)
      : target_m_(target_m), tolerance_m_(tolerance_m), glide_(glide) {}

 protected:
  Command run(const Sample& sample) override;
  Progress progress() const override {
    return {start_m_ > 0.0 ? 1.0 - std::min(1.0, left_m_ / start_m_) : 1.0, left_m_ / glide_.speed_m_per_s(),
            "going to where it begins"};
  }

 private:
  double target_m_, tolerance_m_;
  Glide glide_;
  double start_m_ = 0.0, left_m_ = 0.0, allowed_s_ = 0.0;
};

}  // namespace breakaway
