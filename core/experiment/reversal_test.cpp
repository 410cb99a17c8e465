#include "experiment/reversal_test.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

namespace {
constexpr double standing = 0.01;  // of the speed that it is to reach
}  // namespace

ReversalTest::ReversalTest(const ReversalTestOptions& options) : options_(options), means_(options.block_s) {
  if (!(options.current_A > 0.0)) fail(message("no current is given to turn the rotor round with"));
  if (!(options.highest_rad_per_s > 0.0)) fail(message("no speed is given at which to turn round"));
}

Command ReversalTest::run(const Sample& sample) {
  now_s_ = elapsed_s(sample);
  if (const auto block = means_.add(sample, tick_s())) blocks_.push_back(*block);
  // At other speeds each time, so that the rotor turns round at other angles: position torque then averages out.
  const double golden = 0.618034 * static_cast<double>(done_), part = 0.7 + 0.3 * (golden - std::floor(golden));
  if (way_ * sample.velocity_rad_per_s >= part * options_.highest_rad_per_s) {
    way_ = -way_;
    turned_s_ = now_s_;
    if (++done_ > options_.reversals) finish();
  } else if (now_s_ - turned_s_ > options_.most_s) {
    stood_ = std::abs(sample.velocity_rad_per_s) < standing * options_.highest_rad_per_s;
    constexpr double anywhere = 1.5;  // times the breakaway current of one place
    if (stood_ && options_.current_A < anywhere * options_.breakaway_A) {
      stood_ = false;
      fail(message("{:.3g} A don't break the rotor loose everywhere, where it was tried it takes {:.3g} A",
                   options_.current_A, options_.breakaway_A));
      return {};
    }
    if (stood_)
      fail(message("the rotor does not move {} at {:.3g} A; is something in its way?", wayText(way_ > 0.0),
                   options_.current_A));
    fail(message("{:.3g} A bring the rotor to {:.3g} rad/s only, not to {:.3g}", options_.current_A,
                 std::abs(sample.velocity_rad_per_s), options_.highest_rad_per_s));
  }
  return {Command::Mode::current, way_ * options_.current_A, 0.0, false};
}

TimedProcedure::Progress ReversalTest::progress() const {
  const auto all = static_cast<double>(options_.reversals + 1), done = std::min(all, static_cast<double>(done_));
  const double each_s = done_ > 0 ? now_s_ / static_cast<double>(done_) : 0.5;
  return {done / all, each_s * (all - done), message("turning the rotor round by constant current")};
}

}  // namespace breakaway
