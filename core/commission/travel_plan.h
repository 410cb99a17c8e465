// How a linear axis' sweeps are laid out, from what is known of the axis.
#pragma once

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "experiment/drive.h"
#include "experiment/travel.h"
#include "experiment/travel_bins.h"
#include "experiment/travel_breakaway.h"
#include "experiment/travel_homing.h"
#include "experiment/travel_sweep.h"
#include "identify/motor_identification.h"
#include "identify/travel_friction.h"

namespace breakaway {

/// Positions as the encoder counts them.
struct KnownAxis {
  Identity board;
  Travel travel;
  IdentifiedMotor motor;
  double shownResistance_ohm = 0.0;  ///< with the current as the sensor shows it
  double noiseRms_A = 0.0;           ///< of the current sensor, per sample
  bool linearised = false;           ///< the board takes its voltages through the inverse of the bridge's curve
  double current_limit_A = 0.0;
  double index_m = 0.0;  ///< the lower end where there is none

  double count_m() const { return 1.0 / board.countsPerRev; }
  double forcePerAmpere() const { return motor.torquePerShownAmpere_Nm(); }
  double indexTolerance() const { return board.hasIndex ? indexTolerance_m(count_m()) : 0.0; }
};

/// Counted from elsewhere.
Travel moved(const Travel& travel, double by_m);
/// Whether both ends were felt at the same places again, within 1 % of the travel.
bool sameEnds(const Travel& before, const Travel& now);

/// The highest that strokes are run with.
struct TravelPace {
  double speed_m_per_s = 0.0, acceleration_m_per_s2 = 0.0;
};

/// So that the axis speeds up with about what friction takes, over less than a third of the travel.
TravelPace paceOf(const KnownAxis& axis);
/// Gains that are careful enough for every measurement.
ControllerSettings carefulSettings(const KnownAxis& axis, const TravelPace& pace, const ControllerSettings& present);

/// The index where there is none: the lower end.
Estimate lowerEnd(const KnownAxis& axis);
TravelHomingOptions homingOver(const KnownAxis& axis, const TravelPace& pace);
/// The speeds are these parts of the pace's, in this order, but not so slow that a stroke would take much longer than
/// `run_s`.
TravelSweepOptions velocitySweepOver(const KnownAxis& axis, const TravelPace& pace, const TravelBins& bins,
                                     std::span<const double> parts, double run_s);
/// `moving_A` as of movingCurrent_A().
TravelBreakawayOptions breakawaySweepOver(const KnownAxis& axis, const TravelPace& pace, const TravelBins& bins,
                                          size_t passes, const std::array<std::vector<double>, 2>& moving_A);
/// How the breakaways were measured, for the map's file.
std::vector<std::pair<std::string, double>> settingsOf(const TravelBreakawayOptions& measured, const TravelPace& pace,
                                                       size_t missed);
TravelFrictionOptions frictionOver(const KnownAxis& axis, const TravelBins& bins, double zeroError_A);

}  // namespace breakaway
