// Current PI controller, tuned from the winding. Freestanding; the board runs it too.
#pragma once

#include "control/magnitude.h"

namespace breakaway {

/// v = R·i_ref + Ke·ω + Kp·e + Ki·∫e with Kp = L·w, Ki = R·w: the zero cancels the winding's pole and what is left is
/// first-order with bandwidth w. The reference is also fed forward, so that w can stay low, because the sensor's noise
/// reaches the winding with an rms of about √(w·T/2) of its own. The integral holds while the voltage is at its limit.
template <typename Scalar>
class CurrentController {
 public:
  struct Settings {
    Scalar resistance_ohm = 0;
    Scalar inductance_H = 0;
    Scalar backEmfConstant_V_s_per_rad = 0;
    Scalar bandwidth_rad_per_s = 0;
  };

  void configure(const Settings& settings, Scalar tick_s) {
    settings_ = settings;
    gain_V_per_A_ = settings.inductance_H * settings.bandwidth_rad_per_s;
    growth_V_per_A_ = settings.resistance_ohm * settings.bandwidth_rad_per_s * tick_s;
  }
  void reset() { integral_V_ = 0; }

  Scalar step(Scalar reference_A, Scalar current_A, Scalar velocity_rad_per_s, Scalar limit_V) {
    const Scalar error = reference_A - current_A;
    const Scalar forward =
        settings_.resistance_ohm * reference_A + settings_.backEmfConstant_V_s_per_rad * velocity_rad_per_s;
    const Scalar wanted = forward + gain_V_per_A_ * error + integral_V_;
    const bool limited = exceeds(wanted, limit_V);
    if (!limited || isNegative(wanted) != isNegative(error)) integral_V_ += growth_V_per_A_ * error;
    return limited ? within(wanted, limit_V) : wanted;
  }

  /// The nearest voltage to `wanted_V` that keeps the current within ±limit_A.
  Scalar clampForCurrent(Scalar wanted_V, Scalar current_A, Scalar velocity_rad_per_s, Scalar limit_A) const {
    const Scalar middle = settings_.backEmfConstant_V_s_per_rad * velocity_rad_per_s - gain_V_per_A_ * current_A;
    const Scalar off = wanted_V - middle, most = (settings_.resistance_ohm + gain_V_per_A_) * limit_A;
    return exceeds(off, most) ? middle + within(off, most) : wanted_V;
  }

 private:
  Settings settings_;
  Scalar gain_V_per_A_ = 0, growth_V_per_A_ = 0, integral_V_ = 0;
};

}  // namespace breakaway
