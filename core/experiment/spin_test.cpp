#include "experiment/spin_test.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

std::optional<SpinBlock> BlockMeans::add(const Sample& sample, double tick_s) {
  // The voltage of a row acts until the next one: what was measured now, the row before has brought about.
  const double acted_V = acting_V_;
  acting_V_ = sample.voltage_V;
  if (!(tick_s > 0.0)) return {};
  sum_.current_A += sample.current_A;
  sum_.voltage_V += acted_V;
  sum_.duration_s += tick_s;
  ++count_;
  if (sum_.duration_s < block_s_ - 0.5 * tick_s) return {};
  const auto n = static_cast<double>(count_);
  const SpinBlock block{sample.time_s, sum_.duration_s, sample.angle_rad, sum_.current_A / n, sum_.voltage_V / n};
  sum_ = {};
  count_ = 0;
  return block;
}

Command SpinTest::run(const Sample& sample) {
  elapsed_s_ = elapsed_s(sample);
  if (const auto block = means_.add(sample, tick_s())) blocks_.push_back(*block);
  if (elapsed_s_ >= whole_s()) finish();
  const double highest = options_.highest_V > 0.0 ? options_.highest_V : 0.5 * sample.supply_V;
  const double legs = elapsed_s_ / options_.leg_s;
  const double phase = legs - 4.0 * std::floor(legs / 4.0);
  const double shape = phase < 1.0 ? phase : phase < 3.0 ? 2.0 - phase : phase - 4.0;
  return {Command::Mode::voltage, highest * shape, options_.current_limit_A, false};
}

double SpinTest::progress() const {
  return std::min(1.0, elapsed_s_ / whole_s());
}

double SpinTest::remaining_s() const {
  return std::max(0.0, whole_s() - elapsed_s_);
}

}  // namespace breakaway
