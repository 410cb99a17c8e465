#include "session/trigger.h"

namespace breakaway {

void Trigger::take(double time_s, double value) {
  const double beyond = (options_.rising ? 1.0 : -1.0) * (value - options_.level);
  if (last_s_ && time_s <= *last_s_) *this = Trigger(options_);
  if (coming_s_ && time_s >= *coming_s_ + options_.after_s) {
    shown_s_ = coming_s_;
    coming_s_.reset();
  }
  if (!coming_s_ && !done()) {
    if (armed_ && last_s_ && beyond >= 0.0) {
      coming_s_ = *last_s_ + (time_s - *last_s_) * lastBeyond_ / (lastBeyond_ - beyond);
      armed_ = false;
    }
    if (beyond < -options_.hysteresis) armed_ = true;
  }
  last_s_ = time_s;
  lastBeyond_ = beyond;
}

}  // namespace breakaway
