#include "experiment/dead_sensor.h"

#include <algorithm>

namespace breakaway {

namespace {

constexpr double longEnough_s = 5.0;  // with the windings energised
constexpr double widely_V = 0.3;      // moves any motor's current by more than a converter's step

}  // namespace

Message DeadSensor::step(const Sample& sample) {
  const double passed_s = begun_ ? sample.time_s - before_s_ : 0.0;
  before_s_ = sample.time_s;
  if (!begun_ || sample.current_A != shown_A_) {
    begun_ = true;
    shown_A_ = sample.current_A;
    energised_s_ = 0.0;
    low_V_ = high_V_ = sample.voltage_V;
    return {};
  }
  if (!sample.enabled) return {};
  energised_s_ += passed_s;
  low_V_ = std::min(low_V_, sample.voltage_V);
  high_V_ = std::max(high_V_, sample.voltage_V);
  if (energised_s_ < longEnough_s || high_V_ - low_V_ < widely_V) return {};
  return message(
      "the current sensor is dead, or too coarse for this motor: it reads exactly {:.3g} A from {:.2f} V to {:.2f} V; "
      "check its supply and its wire",
      shown_A_, low_V_, high_V_);
}

}  // namespace breakaway
