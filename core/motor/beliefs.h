// What is believed of a rig, held against what is measured of it: the one place that says when the two contradict.
#pragma once

#include <optional>
#include <string>

#include "base/axis.h"
#include "base/estimate.h"
#include "motor/bench.h"

namespace breakaway {

/// What can be believed; on a linear axis read N for Nm, m for rad, kg for kg m².
enum class BeliefOf { counts, supply, torqueConstant, backEmfConstant, resistance, inductance, inertia };

/// A value that somebody gave, and what came of measuring it; both in SI.
struct Belief {
  BeliefOf of = BeliefOf::counts;
  Message source;    ///< "the bench's"
  std::string name;  ///< of the field that holds it
  double believed = 0.0;
  bool trusted = false;
  Estimate measured;                          ///< error 0: exact
  Message from = message("but measured is");  ///< what stands before the other value
};

/// The factor by which an honest belief may be off, either way. Beliefs are start values: a magnet's strength is within
/// 20 %, copper gains 40 % of resistance over 100 K and a cable adds to it, a rotor carries several times its own
/// inertia. Mistakes of unit or of convention begin at √3. So what a motor's maker states and what somebody trusts may
/// be off by 1.4, what wires, frequency or load change by more; counts are a number of lines, which is right or wrong.
double honestFactor(BeliefOf of, bool trusted);

/// Believed over measured.
double ratioOf(const Belief& belief);

/// What `ratio`, believed over measured, looks like: "as mNm/A would be". Empty when no mistake is known that makes it.
/// Ratios of up to 15 % beside the mistake's own still suggest it: the belief is a start value besides.
Message suggestionOf(BeliefOf of, Axis axis, double ratio);

/// Both values, their ratio and what it suggests, where they part by more than honestFactor() and three standard errors
/// of the measured value; else nothing. Values must be positive; others contradict as well.
std::optional<Message> contradictionOf(const Belief& belief, Axis axis);

/// What a recording may hold in another unit than its column says; on a linear axis read position for the angle and
/// force for the torque.
enum class ScaledColumn { angle, current, voltage, torque };

/// A way to get a column wrong by a factor.
struct ScaleMistake {
  double ratio = 1.0;  ///< what stands there over what is true
  Message words;       ///< "as in degrees"
};

/// How far a ratio may be from a mistake's own to suggest it: 15 %.
inline constexpr double nearMistake = 0.15;

/// The mistake that `ratio`, recorded over true, looks like, within the relative `doubt` about it; nothing when none is
/// known.
std::optional<ScaleMistake> scaleMistakeOf(ScaledColumn column, Axis axis, double ratio, double doubt = nearMistake);

/// What a bench file contradicts itself by, with the field: torque and back-EMF constant are one quantity in SI, and a
/// motor's time constant J·R/(Kt·Ke), of which servos have 1 ms to 10 s, isn't hours. Nothing when it doesn't.
std::optional<Error> selfContradictionOf(const Bench& bench);

}  // namespace breakaway
