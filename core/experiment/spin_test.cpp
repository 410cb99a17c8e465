#include "experiment/spin_test.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

Command SpinTest::run(const Sample& sample) {
  elapsed_s_ = elapsed_s(sample);
  if (tick_s() > 0.0) {
    sum_.current_A += sample.current_A;
    sum_.voltage_V += commanded_V_;
    sum_.duration_s += tick_s();
    ++count_;
    if (sum_.duration_s >= options_.block_s - 0.5 * tick_s()) {
      const auto n = static_cast<double>(count_);
      blocks_.push_back({sample.time_s, sum_.duration_s, sample.angle_rad, sum_.current_A / n, sum_.voltage_V / n});
      sum_ = {};
      count_ = 0;
    }
  }
  if (elapsed_s_ >= whole_s()) finish();
  const double highest = options_.highest_V > 0.0 ? options_.highest_V : 0.5 * sample.supply_V;
  const double legs = elapsed_s_ / options_.leg_s;
  const double phase = legs - 4.0 * std::floor(legs / 4.0);
  const double shape = phase < 1.0 ? phase : phase < 3.0 ? 2.0 - phase : phase - 4.0;
  commanded_V_ = highest * shape;
  return {Command::Mode::voltage, commanded_V_, options_.current_limit_A, false};
}

double SpinTest::progress() const {
  return std::min(1.0, elapsed_s_ / whole_s());
}

double SpinTest::remaining_s() const {
  return std::max(0.0, whole_s() - elapsed_s_);
}

}  // namespace breakaway
