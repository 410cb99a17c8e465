// Speed observer and current loop: how fast they are best, and what more bandwidth of them costs in noise.
#pragma once

#include <string>
#include <vector>

#include "stability/auto_tuning.h"

namespace breakaway {

/// What the current loop is at one bandwidth.
struct CurrentLoopRow {
  double bandwidth_rad_per_s = 0.0;
  LoopMargins worst;       ///< at the corner of the winding where the sensitivity's peak is largest
  double current_A = 0.0;  ///< rms that the sensor's noise makes in the winding; NaN where the loop is unstable
  double voltage_V = 0.0;  ///< and at the bridge
  std::string lost;        ///< of what was asked for, in words; empty: nothing
};

/// What the speed observer makes of the velocity loop at one bandwidth, its gains tuned to it (tuneVelocity()).
struct SpeedObserverRow {
  double bandwidth_rad_per_s = 0.0;
  double loopBandwidth_rad_per_s = 0.0;    ///< 0: no gains hold, and the next three are nothing
  double cutoff_rad_per_s = 0.0;           ///< of the disturbance observer
  double yielding_rad_per_s_per_Nm = 0.0;  ///< the shaft's speed per load torque where it yields the most
  LoopNoise noise;                         ///< of the tuned loop
  std::string heldBy;                      ///< what would be lost first with higher gains
};

enum class BandwidthSource { chosen, given, board };
std::string_view nameOf(BandwidthSource source);

struct BandwidthChoice {
  double bandwidth_rad_per_s = 0.0;
  BandwidthSource source = BandwidthSource::board;
  std::string heldBy;  ///< of one that was chosen: what more of it would lose
};

struct InnerLoops {
  BandwidthChoice current, observer;
  std::vector<CurrentLoopRow> currentRows;     ///< over the bandwidth; empty without a winding
  std::vector<SpeedObserverRow> observerRows;  ///< over the bandwidth, with the current loop that `current` says
};

struct InnerLoopOptions {
  double current_rad_per_s = 0.0, observer_rad_per_s = 0.0;  ///< given ones; 0: to be chosen
  bool asBoards = false;                                     ///< what isn't given is as the boards have it
  double supply_V = 0.0;                                     ///< 0: unknown
  size_t rows = 13;                                          ///< bandwidths that are looked at, at least 2
};

/// The current loop first, then the speed observer around it, each with `rows` bandwidths from 0.02/T to 1/T and the
/// boards' own as rows.
///
/// Current loop: the shaft held, cut at the current's measurement. The largest bandwidth at which the margins of
/// `options.stiffness` hold for an inductance within ±20 % and a winding that is up to 60 K warmer (R +24 %), and the
/// sensor's noise makes no more current in the winding than its share of the current limit (nor more voltage than the
/// same share of the supply). Without a winding, as the boards have it.
///
/// Speed observer: a slow one lags, so that little gain holds; a fast one lets so much of the encoder's rounding
/// through that little gain stays within the share of noise. Of the bandwidths (rows) at which the shaft yields at most
/// a tenth more to a load than at the best one, the slowest. Where there is no current limit, the current's noise is
/// held against U/R; without either, or where no row holds, as the boards have it.
///
/// Precondition: check(loop). Errors: an interval of J or Kt that reaches zero.
Result<InnerLoops> chooseInnerLoops(const ServoLoop& loop, const Estimate& inertia_kg_m2,
                                    const Estimate& torqueConstant_Nm_per_A, const AutoTuningOptions& options,
                                    const InnerLoopOptions& inner);

/// The current loop around a held shaft: inputs reference and white error of the measurement in A, outputs current in A
/// and voltage in V; the controller's resistance and inductance are those of `loop.board`, the winding's those of
/// `loop.motor`. Precondition: check(loop), a winding.
DiscreteSystem closedCurrentLoop(const ServoLoop& loop);
/// The same cut where the measured current enters its controller.
DiscreteSystem openCurrentLoop(const ServoLoop& loop);

}  // namespace breakaway
