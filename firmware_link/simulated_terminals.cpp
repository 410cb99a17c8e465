#include "firmware_link/simulated_terminals.h"

#include <algorithm>
#include <cmath>

namespace breakaway {

void SimulatedTerminals::at(double time_s) {
  time_s_ = time_s;
}

int64_t SimulatedTerminals::count(int64_t encoder) {
  if (!begun_) counter_ = static_cast<double>(encoder);
  const auto moved = static_cast<double>(begun_ ? encoder - encoder_ : 0);
  begun_ = true;
  encoder_ = encoder;
  if (!has(WiringKind::encoderDead))
    counter_ += moved * factor(WiringKind::countsFactor) * (has(WiringKind::encoderReversed) ? -1.0 : 1.0);
  return static_cast<int64_t>(std::floor(counter_));
}

bool SimulatedTerminals::index(bool seen) const {
  if (has(WiringKind::encoderDead)) return false;
  return has(WiringKind::indexInverted) ? !seen : seen;
}

bool SimulatedTerminals::has(WiringKind kind) const {
  return std::any_of(wiring_.begin(), wiring_.end(),
                     [=, this](const RigWiring& one) { return one.kind == kind && one.acts(time_s_); });
}

double SimulatedTerminals::factor(WiringKind kind) const {
  double factor = 1.0;
  for (const RigWiring& one : wiring_) {
    if (one.kind == kind && one.acts(time_s_)) factor *= one.value;
  }
  return factor;
}

}  // namespace breakaway
