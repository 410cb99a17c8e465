// From strokes at several speeds over a linear axis' travel to friction per place and way, and to the moving mass.
#pragma once

#include <array>
#include <vector>

#include "base/estimate.h"
#include "base/result.h"
#include "experiment/travel_bins.h"
#include "friction/measurements.h"
#include "identify/velocity_friction.h"

namespace breakaway {

struct TravelFrictionOptions {
  double forceConstant_N_per_A = 0.0;  ///< per ampere as the sensor shows it
  double mass_kg = 0.0;                ///< as identified before
  double massError_kg = 0.0;           ///< its standard error; 0: the strokes alone tell
  double noiseRms_A = 0.0;             ///< of one sample of the current
  double zeroError_A = 0.0;            ///< standard error of the current sensor's zero at each speed
  double scaleError = 0.0;             ///< relative standard error of the force constant
  double tick_s = 0.0, count_m = 0.0;
  TravelBins bins;
  /// The breakaway map where it is known, by Way: slow strokes are freed of what friction falls by with speed.
  std::array<std::vector<double>, 2> static_N;
};

struct TravelFriction {
  std::array<MovingFriction, 2> moving;  ///< N and N s/m per bin, by Way
  Estimate mass_kg;                      ///< by the strokes' speeding up and slowing down; error 0: not known
  Estimate stribeck_m_per_s;             ///< 0: not seen
};

/// Per bin and way the force less what accelerates, Kf·i − m·a, is fitted over the speeds by C·(1 − e) + B·v + S·e with
/// e = exp(−(v/v_s)²) and one v_s for all; m is what the same bins passed at different accelerations say (their
/// friction is projected out, and so is what rounded counts make of accelerations), joined with what was known. What is
/// left in the bins sets the noise's scale. C and B are then smoothed over the travel (smooth_pair.h), and C is freed
/// of what a bin's mean flattens. Errors: a way with fewer than three speeds.
Result<TravelFriction> fitTravelFriction(const std::vector<TravelRun>& runs, const TravelFrictionOptions& options);

/// Whether the run crossed bins both ways; one that went steadily nowhere didn't.
bool tellsOfFriction(const TravelRun& run);

/// Current that keeps it moving in the slowest run that tells of friction, per bin, by Way, positive in the way's
/// direction; bins that the run left out take their neighbour's. Error: there is no run, or it left out a whole way.
Result<std::array<std::vector<double>, 2>> movingCurrent_A(const std::vector<TravelRun>& runs);

}  // namespace breakaway
