// The gains of a tuning as text for other boards: SimpleFOC, ODrive, VESC.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace breakaway {

/// What tuning.json (breakaway.tuning/1) says of a rotary motor's loops.
struct TunedGains {
  std::string name;  ///< the rig's
  double velocityKp_A_s_per_rad = 0.0, velocityKi_A_per_rad = 0.0, velocityKd_A_s2_per_rad = 0.0;
  double positionKp_A_per_rad = 0.0, positionKi_A_per_rad_s = 0.0, positionKd_A_s_per_rad = 0.0;
  double cutoff_rad_per_s = 0.0;  ///< of the disturbance observer; 0: none
  double inertia_kg_m2 = 0.0;
  double torqueConstant_Nm_per_A = 0.0;
  double currentLimit_A = 0.0;  ///< 0: none
  double speedFilter_rad_per_s = 0.0;
  double currentBandwidth_rad_per_s = 0.0;
  std::optional<double> resistance_ohm = {}, inductance_H = {};
};

/// Errors name the file and the field; a linear axis is one, for these boards turn.
Result<TunedGains> readTuning(const std::string& path);

/// A loop without an observer that feeds back the same: with the observer's cutoff g, i = (1 + g/s)·i_c − (g J/Kt)·ω
/// (disturbance_observer.h), so what follows from e = −θ or −ω is a PID of these gains, whatever answers to the
/// reference.
struct SameFeedback {
  double p = 0.0, i = 0.0, d = 0.0;
};
SameFeedback velocityFeedback(const TunedGains& gains);  ///< A s/rad, A/rad, A s²/rad
SameFeedback positionFeedback(const TunedGains& gains);  ///< A/rad, A/(rad s), A s/rad

struct GainsExport {
  std::string text;
  std::vector<std::string> notes;  ///< what the board can't hold; the file says the same
};

/// simplefoc, odrive, vesc.
const std::vector<std::string>& gainForms();

/// Each line with its unit and formula. `polePairs` is asked for by vesc, whose speeds are electrical. Errors: what the
/// form needs and the tuning lacks. Precondition: one of gainForms().
Result<GainsExport> exportGains(const TunedGains& gains, const std::string& form, const std::string& tuning,
                                std::optional<double> polePairs);

}  // namespace breakaway
