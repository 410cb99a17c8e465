// Current PI controller, tuned from the winding. Freestanding; the board runs it too.
#pragma once

namespace breakaway {

/// Holds a value within ±limit.
template <typename Scalar>
constexpr Scalar within(Scalar value, Scalar limit) {
  return value > limit ? limit : value < -limit ? -limit : value;
}

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
    tick_s_ = tick_s;
  }
  void reset() { integral_V_ = 0; }

  Scalar step(Scalar reference_A, Scalar current_A, Scalar velocity_rad_per_s, Scalar limit_V) {
    const Scalar error = reference_A - current_A;
    const Scalar forward =
        settings_.resistance_ohm * reference_A + settings_.backEmfConstant_V_s_per_rad * velocity_rad_per_s;
    const Scalar wanted = forward + settings_.inductance_H * settings_.bandwidth_rad_per_s * error + integral_V_;
    const Scalar voltage = within(wanted, limit_V);
    if (voltage == wanted || (wanted - voltage) * error < Scalar(0)) {
      integral_V_ += settings_.resistance_ohm * settings_.bandwidth_rad_per_s * tick_s_ * error;
    }
    return voltage;
  }

  /// The nearest voltage to `wanted_V` that keeps the current within ±limit_A.
  Scalar clampForCurrent(Scalar wanted_V, Scalar current_A, Scalar velocity_rad_per_s, Scalar limit_A) const {
    const Scalar middle = settings_.backEmfConstant_V_s_per_rad * velocity_rad_per_s;
    const Scalar gain = settings_.inductance_H * settings_.bandwidth_rad_per_s;
    const Scalar high = middle + settings_.resistance_ohm * limit_A + gain * (limit_A - current_A);
    const Scalar low = middle - settings_.resistance_ohm * limit_A - gain * (limit_A + current_A);
    return wanted_V > high ? high : wanted_V < low ? low : wanted_V;
  }

 private:
  Settings settings_;
  Scalar tick_s_ = 0, integral_V_ = 0;
};

}  // namespace breakaway
