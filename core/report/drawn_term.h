// What the pictures of terms share: curves with the interval that their parameters leave.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnose/model/effect.h"
#include "diagnose/simulate/stepper.h"
#include "diagnose/simulate/track.h"
#include "draw/svg_plot.h"

namespace breakaway {

/// What a term is drawn for: the effect, its parameter sets (the fitted one first, then each end of each interval) and
/// what the recordings saw.
struct Drawn {
  const Effect& effect;
  std::vector<std::vector<double>> sets;
  Physics physics;
  Excitation seen;
  const Track& track;
};
using Value = std::function<double(const std::vector<double>& parameters, double at)>;

/// The fitted curve with the extremes that the intervals allow.
Curve curveOf(const Drawn& drawn, const std::vector<double>& x, const Value& value, const Message& label = {},
              int colour = 0);
/// One curve for both ways where they are alike, else two; `value` for a direction.
void addWays(Figure& figure, const Drawn& drawn, const std::vector<double>& x,
             const std::function<Value(double direction)>& value);

/// Even steps, fine enough for a picture.
std::vector<double> between(double from, double to);
bool rotary(const Drawn& drawn);
enum class TorqueLabel { opposing, resisting, friction, transmitted, motor, knownLoad };
/// "opposing torque / mNm" or "opposing force / N", and Nm or N in it.
Message torqueLabel(const Drawn& drawn, TorqueLabel what);
double torqueScale(const Drawn& drawn);
/// Moving steadily towards growing position in the middle of what was seen.
Situation typical(const Drawn& drawn);
/// What opposes growing position, as torqueLabel() says.
double opposing(const Drawn& drawn, const std::vector<double>& parameters, const Situation& at);

// The pictures, by Effect::drawnOver().
Figure overVelocity(const Drawn& drawn);
Figure overAngle(const Drawn& drawn);
Figure overCurrent(const Drawn& drawn);
Figure overTime(const Drawn& drawn);
Figure overTravel(const Drawn& drawn);
Figure overFrequency(const Drawn& drawn);

}  // namespace breakaway
