// The motor from the bench's own tests: winding, back-EMF, inertia, average friction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/axis.h"
#include "base/estimate.h"
#include "base/result.h"
#include "experiment/spin_block.h"
#include "identify/bridge_fit.h"
#include "motor/winding_line.h"

namespace breakaway {

struct IdentifiedMotor {
  Estimate torqueConstant_Nm_per_A;
  bool torqueConstantTrusted = false;  ///< the bench's own; else tied to the back-EMF constant, Kt = Ke in SI
  Estimate backEmfConstant_V_s_per_rad;
  Estimate resistance_ohm;
  Estimate inductance_H;
  Estimate deadZone_V;
  Estimate inertia_kg_m2;          ///< of both methods together
  Estimate rampInertia_kg_m2;      ///< by speeding up and slowing down under voltage
  Estimate reversalInertia_kg_m2;  ///< by turning round under constant current; error 0: not done
  Estimate shownInertia_kg_m2;     ///< of both methods together, with the current as the sensor shows it
  Estimate coulomb_Nm;             ///< mean of both ways
  Estimate viscous_Nm_s_per_rad;
  /// Shown over true current. All that is counted in amperes hangs on it: R and L grow with it, J, F and B shrink.
  Estimate currentGain{1.0, 0.0};
  DutyCurve dutyCurve;  ///< of the bridge, where it bends; else unknown, and the dead zone says it all
  Message gauge;        ///< what the scale of all torques rests on, in words

  /// Of the current as the sensor shows it.
  double torquePerShownAmpere_Nm() const { return torqueConstant_Nm_per_A.value / currentGain.value; }
};

struct MotorIdentificationOptions {
  std::optional<double> trustedTorqueConstant_Nm_per_A;
  double window_s = 0.1;   ///< of the momentum balance
  double count_rad = 0.0;  ///< of the encoder, whose rounding is in every speed; 0: it doesn't round
};

/// The same motor identified twice, the second time with a disc of known inertia more (or less) on its shaft.
struct AddedInertia {
  Estimate shownOther_kg_m2;  ///< the other time's, with the current as the sensor shows it
  Estimate added_kg_m2;       ///< what this time has more than the other
};

struct CurrentScaleOptions {
  Axis axis = Axis::rotary;
  double gainInterval =
      0.027;  ///< half width of the 95 % interval of the sensor's gain, relative; ACS712: 180–190 mV/A
  std::optional<double> trustedInertia_kg_m2;  ///< known, with all that turns: then the gain is measured
  std::optional<AddedInertia> added;           ///< then it is measured by what that changed
};

/// The reversal's inertia taken in: both methods weighted by their errors, which grow by as much as they disagree.
/// Returns by how many standard errors they part.
double joinInertia(IdentifiedMotor& motor, const Estimate& reversal);

/// Takes resistance, back-EMF constant, dead zone and curve from the fit of all tests; what hangs on them follows: the
/// inductance by `timeConstant_s`, and torques where the torque constant is tied to the back-EMF constant.
void takeBridge(IdentifiedMotor& motor, const BridgeFit& bridge, const Estimate& timeConstant_s);

/// Widens the back-EMF constant's interval, and that of a torque constant tied to it, by what a bridge that bends its
/// duty may have done to it: `any` is the constant whatever the bridge's curve. Returns the relative standard error.
double widenByBridge(IdentifiedMotor& motor, const Estimate& any);

/// Puts the scale of the current on the motor, whose values must be as the sensor shows its current: the gain from a
/// trusted or an added inertia, or one with the interval given. An added inertia that doesn't stand out by five
/// standard errors measures nothing, and `gauge` says so. Values and intervals then are those of true amperes, and
/// `gauge` says on what they rest.
void setCurrentScale(IdentifiedMotor& motor, const CurrentScaleOptions& options);

/// Back-EMF constant and dead zone by least squares of v − R·i = Ke·ω + V0·sgn ω over the blocks that turn; inertia and
/// friction by the balance of momentum over windows, Kt·∫i dt = J·Δω + C·s·Δt + B·Δθ, which needs no second derivative.
/// What a coarse encoder's rounding adds to the square of Δω, which would make J small, is taken off; a part of what
/// that changes is in J's error. A gain error of the current sensor can't be told from Kt: all torques then carry it.
/// Errors: too few blocks that turn.
Result<IdentifiedMotor> identifyMotor(const std::vector<SpinBlock>& blocks, const WindingLine& winding,
                                      const Estimate& timeConstant_s, const MotorIdentificationOptions& options);

}  // namespace breakaway
