// What the wiring check tells of motor, sensors and shaft.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/axis.h"
#include "base/estimate.h"
#include "base/message.h"

namespace breakaway {

class WiringCheck;

/// Errors of 0: not seen.
struct WiringFit {
  Estimate resistance_ohm;
  Estimate backEmf_V_s_per_rad;                        ///< as the encoder counts
  std::array<std::optional<Estimate>, 2> breakaway_A;  ///< by way, positive in it; none: something stops it that way
  std::array<bool, 2> stopped{};  ///< by way: a kick fell short of its length, and none the other way did
  bool currentSeen = false;
  double supply_V = 0.0;  ///< as it reads
};

/// Of a finished check. In a kick the voltage is constant, so that the current is i = a − (Ke/R)·ω once it has risen,
/// whatever the bridge loses; taken as integrals over time, ∫i dt = a·t − (Ke/R)·θ, and by least squares. R is the
/// slope from what the standing shaft bore to a.
WiringFit fitWiring(const WiringCheck& check);

/// One sentence each: motor and encoder, current sensor, supply, counts, shaft and load. `zero_A` was taken off the
/// sensor before; `supply_V` is what belongs.
std::vector<Message> inWords(const WiringFit& fit, const Estimate& zero_A, double noiseRms_A, double supply_V,
                             Axis axis);

}  // namespace breakaway
