// The bridge's duty curve together with resistance and back-EMF constant, from all that the windings saw.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/estimate.h"
#include "base/result.h"
#include "experiment/spin_block.h"
#include "motor/duty_curve.h"
#include "motor/winding_line.h"

namespace breakaway {

/// Voltages and currents as the board shows them.
struct BridgeTests {
  std::vector<WindingPoint> standing;          ///< of the winding test
  double standingBlock_s = 0.01;               ///< over which each point is a mean
  std::vector<std::vector<SpinBlock>> moving;  ///< of the spin test, of the reversal test
  double timeConstant_s = 0.0;                 ///< L/R
  double supply_V = 0.0;
  double count_rad = 0.0;  ///< of the encoder, whose rounding is in every block's speed; 0: it doesn't round
};

struct BridgeFit {
  Estimate resistance_ohm;
  Estimate backEmfConstant_V_s_per_rad;
  Estimate deadZone_V;
  /// Known where the bridge bends its duty: by a tenth of the slope somewhere, and beyond doubt.
  DutyCurve curve;
};

/// Weighted least squares of i + (L/R)·di/dt = f(u)/R − (Ke/R)·ω + i₀ over all blocks, i₀ of each test its own, f odd
/// and straight between knots that lie closer towards the dead zone's end, which is searched. Friction, inertia and
/// load do not enter. Voltage and speed go together, so that a coarse encoder's rounding would make both slopes small,
/// R large and leave Ke right (W. A. Fuller, Measurement Error Models, section 2.2): what it adds to the square of ω is
/// taken off, and a part of what that changes is in R's error. A supply that the board doesn't see falling takes
/// Rs·(u/U)²·i away where it drives: Rs/R is an unknown beside, known to a few hundredths beforehand, so that R and Ke
/// are free of it, or in doubt as far as the tests leave it open. The scale of f can't be seen: beyond the last knot f
/// is taken to grow as the duty does, and a bridge that gives a common part less shows it in R, L and Ke. Errors: too
/// few blocks; voltages that don't reach far enough beyond the last knot; resistance and back-EMF constant that the
/// blocks don't tell apart; a curve that doesn't rise.
Result<BridgeFit> fitBridge(const BridgeTests& tests);

/// The back-EMF constant of the same fit, whatever curve the bridge has: where that curve, or the resistance, can't be
/// told, by so much more a constant is in doubt that takes the bridge as straight. None with too few blocks.
std::optional<Estimate> backEmfOfAnyCurve(const BridgeTests& tests);

}  // namespace breakaway
