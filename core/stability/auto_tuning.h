// Gains and cutoff from the identified motor and its uncertainty, so that margins hold wherever in its intervals it is.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/estimate.h"
#include "stability/loop_noise.h"
#include "stability/margins.h"

namespace breakaway {

enum class Stiffness { soft, medium, stiff };

std::string_view nameOf(Stiffness stiffness);
std::optional<Stiffness> stiffnessNamed(std::string_view name);

/// What a loop must keep at every corner of its motor's intervals.
struct WantedMargins {
  double gainMargin = 0.0;       ///< at least
  double phaseMargin_rad = 0.0;  ///< at least
  double peakSensitivity = 0.0;  ///< at most
  double noiseShare = 0.0;       ///< at most, rms of the current reference's noise per current limit
};

/// Peak of the sensitivity 1.4 (soft), 1.6 (medium), 2.0 (stiff): the careful and the bold design value of Åström and
/// Hägglund ("Advanced PID Control", 2006, section 4.6) and one between. Gain margin 4, 3, 2 and phase margin 60°, 45°,
/// 30° within the range of Åström and Murray ("Feedback Systems", 2008, section 9.3). Noise: 1, 2, 5 % of the current
/// limit.
WantedMargins wantedMargins(Stiffness stiffness);

/// What of it these margins don't keep, in words ("peak of the sensitivity"); empty when they keep all.
std::string lossOfMargins(const LoopMargins& found, const WantedMargins& wanted);

struct AutoTuningOptions {
  Stiffness stiffness = Stiffness::medium;
  double cutoffPerBandwidth = 10.0 / 3.0;  ///< g/w: nominally the closed loop's poles lie at −g and −w
  SensorNoise noise;
};

/// The motor at one corner of its intervals and what its loops keep there.
struct TuningCorner {
  double inertia_kg_m2 = 0.0;
  double torqueConstant_Nm_per_A = 0.0;
  LoopMargins velocity, position;
};

struct Tuning {
  Stiffness stiffness = Stiffness::medium;
  WantedMargins wanted;
  ServoSettings<double> settings;  ///< nominal values are the identified ones, the current limit is the board's
  double velocityBandwidth_rad_per_s = 0.0;
  double positionBandwidth_rad_per_s = 0.0;
  std::string heldBy;  ///< what would be lost first if the gains were higher, in words ("peak of the sensitivity")
  TuningCorner nominal;
  std::vector<TuningCorner> corners;         ///< all four
  LoopMargins worstVelocity, worstPosition;  ///< field by field the worst of the corners
  LoopNoise noise;                           ///< of the velocity loop, nominally
};

/// Tunes velocity PI-with-observer and position loop: velocity kp = J·w/Kt and cutoff g = cutoffPerBandwidth·w for the
/// largest w at which `wantedMargins` hold at all four corners of the 95 % intervals of J and Kt; position gains
/// (tuneMotion()) with the largest w_p ≤ w at which the same holds. "Largest" is the upper end of the first stretch of
/// w that is met from below: very slow loops can be the less robust ones, for the current loop feeds the speed back
/// too. ki stays 0: the observer is the integral. Of `loop` board, speed source, current path, delay, the other motor
/// values and the current limit are used. Errors: a missing or impossible value (check()), an interval that reaches
/// zero, no w that holds.
Result<Tuning> autoTune(const ServoLoop& loop, const Estimate& inertia_kg_m2, const Estimate& torqueConstant_Nm_per_A,
                        const AutoTuningOptions& options);

/// The velocity loop of autoTune() alone, nominally.
struct VelocityTuning {
  double bandwidth_rad_per_s = 0.0;  ///< 0: no gains hold at every corner, for `heldBy` is lost
  std::string heldBy;
  ServoLoop loop;
  LoopNoise noise;
};

/// Errors: those of autoTune(), but that no w holds.
Result<VelocityTuning> tuneVelocity(const ServoLoop& loop, const Estimate& inertia_kg_m2,
                                    const Estimate& torqueConstant_Nm_per_A, const AutoTuningOptions& options);

}  // namespace breakaway
