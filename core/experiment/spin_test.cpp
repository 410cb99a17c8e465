#include "experiment/spin_test.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {
constexpr double motion_rad = 0.01;  // less travel is no motion
constexpr double stallShape = 0.6;   // of the highest voltage, from where on it must move
}  // namespace

std::optional<SpinBlock> BlockMeans::add(const Sample& sample, double tick_s) {
  // The voltage of a row acts until the next one: what was measured now, the row before has brought about.
  const double acted_V = acting_V_;
  acting_V_ = sample.voltage_V;
  const double mean_A = centred_ ? 0.5 * (before_A_ + sample.current_A) : sample.current_A;
  before_A_ = sample.current_A;
  if (!(tick_s > 0.0)) return {};
  sum_.current_A += mean_A;
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
  elapsed_s_ = elapsed_s(sample) - options_.rest_s;
  if (elapsed_s_ < 0.0 || elapsed_s_ >= whole_s()) return rest(sample, elapsed_s_ > 0.0);
  if (commanded_V_ == 0.0 && blocks_.empty()) open_A_.moved(options_.mostDrift_A);
  if (const auto block = means_.add(sample, tick_s())) blocks_.push_back(*block);
  const double highest = options_.highest_V > 0.0 ? options_.highest_V : 0.5 * sample.supply_V;
  const double legs = elapsed_s_ / options_.leg_s;
  const double phase = legs - 4.0 * std::floor(legs / 4.0);
  const double shape = phase < 1.0 ? phase : phase < 3.0 ? 2.0 - phase : phase - 4.0;
  commanded_V_ = highest * shape;
  if (std::abs(shape) > stallShape) watchMotion(sample);
  return {Command::Mode::voltage, commanded_V_, options_.current_limit_A, false};
}

Command SpinTest::rest(const Sample& sample, bool last) {
  open_A_.take(sample);
  if (!last || elapsed_s_ < whole_s() + options_.rest_s) return {};
  if (const Message moved = open_A_.moved(options_.mostDrift_A); !moved.empty()) fail(moved);
  finish();
  return {};
}

void SpinTest::watchMotion(const Sample& sample) {
  const bool moved = std::abs(sample.angle_rad - movedAngle_rad_) > motion_rad;
  if (moved) movedAngle_rad_ = sample.angle_rad;
  stalled_s_ = moved ? 0.0 : stalled_s_ + tick_s();
  if (stalled_s_ <= options_.stall_s) return;
  fail(message("the rotor does not move {} at {:.1f} V; is the shaft held, or the current limit too low?",
               wayText(commanded_V_ > 0.0), std::abs(commanded_V_)));
}

}  // namespace breakaway
