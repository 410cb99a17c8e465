// What the loop can stand: its transfer over frequency, gain, phase and delay margin, sensitivity.
#pragma once

#include <complex>
#include <vector>

#include "stability/servo_loop.h"

namespace breakaway {

/// The loop cut at the encoder (openLoop()) over frequency: L, the sensitivity S = 1/(1 + L) and the complementary L/(1
/// + L).
struct LoopResponse {
  std::vector<double> frequency_rad_per_s;
  std::vector<std::complex<double>> loop, sensitivity, complementary;
};

/// At each frequency in rad/s, above 0 and up to π/T. Precondition: check(loop).
LoopResponse loopResponse(const ServoLoop& loop, const std::vector<double>& frequencies_rad_per_s);

/// How the closed loop answers its reference and a load over frequency, at the sample.
struct ClosedResponse {
  std::vector<std::complex<double>> following;  ///< speed per reference (angle per reference in position mode), 1
  std::vector<std::complex<double>> yielding;   ///< speed per load torque, rad/(Nm s)
  std::vector<std::complex<double>> observing;  ///< τ̂ per load torque, 1: what the observer sees of it
};

/// At each frequency in rad/s, above 0 and up to π/T. Precondition: check(loop).
ClosedResponse closedResponse(const ServoLoop& loop, const std::vector<double>& frequencies_rad_per_s);

/// Margins of the loop cut at the encoder. They mean something only for a loop that is stable; of one that isn't, only
/// `stable` is set.
struct LoopMargins {
  bool stable = false;
  double gainMargin = 0.0;                ///< L may be this many times as large (openLoop()); infinite without a bound
  double gainReduction = 0.0;             ///< L must stay above this part of what it is; 0 without a bound
  double phaseMargin_rad = 0.0;           ///< the smallest at any crossing of |L| = 1; infinite without a crossing
  double gainCrossover_rad_per_s = 0.0;   ///< where that is; 0 without
  double phaseCrossover_rad_per_s = 0.0;  ///< where the gain margin is; 0 without
  double delayMargin_s = 0.0;             ///< the smallest phase margin per frequency; infinite without a crossing
  double peakSensitivity = 0.0;           ///< max |S|; 1/max|S| is how near L comes to −1
  double peakSensitivity_rad_per_s = 0.0;
  double peakComplementary = 0.0;  ///< max |L/(1 + L)|
  double damping = 0.0;            ///< of the closed loop's poles, see damping()
};

/// Searched over 600 logarithmic steps up to π/T and refined by bisection. Source: Åström, Murray, "Feedback Systems",
/// 2008, section 9.3 (stability margins). Precondition: check(loop).
LoopMargins margins(const ServoLoop& loop);
/// The same of any loop: L(z) is `cut`, one input and one output, and `closed` has its poles once it is closed.
LoopMargins margins(const DiscreteSystem& closed, const DiscreteSystem& cut);

}  // namespace breakaway
