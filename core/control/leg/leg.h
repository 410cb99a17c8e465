// A leg: the part of a procedure that has to react in the very tick. The same machines run in a board's control tick,
// templated on its scalar, and on the host for boards that can't. Freestanding, no heap, no unbounded loop.
#pragma once

#include <cstdint>

#include "control/magnitude.h"
#include "control/servo_controller.h"

namespace breakaway {

/// What a leg sees in each tick.
template <typename Scalar>
struct LegSeen {
  std::uint32_t time_us = 0;  ///< wrapping
  std::int32_t count = 0;     ///< of the encoder, wrapping
  bool index = false;         ///< was passed since the last tick
  Scalar velocity_rad_per_s = 0;
  Scalar supply_V = 0;
};

/// What it asks for from the next tick on.
template <typename Scalar>
struct LegAsk {
  ServoMode mode = ServoMode::off;
  Scalar target = 0;              ///< V or rad/s
  std::int32_t targetCounts = 0;  ///< of a position, as LegSeen counts
};

/// What a turn is in the counts of whoever runs the leg.
template <typename Scalar>
struct LegUnits {
  static constexpr Scalar most = Scalar(1 << 27);  ///< counts: sums of a few stay whole
  std::int32_t countsPerTurn = 0;

  /// Whole counts, held within ±most.
  std::int32_t turns(Scalar turns) const {
    return static_cast<std::int32_t>(within(turns * static_cast<Scalar>(countsPerTurn) + Scalar(0.5), most));
  }
  std::int32_t counts(Scalar angle_rad) const { return turns(angle_rad * Scalar(0.15915494309189535)); }
};

/// How far a leg is: 0 not begun, below legEnds one of its stages, from there on how it ended. Four bits.
using LegPhase = std::uint8_t;
inline constexpr LegPhase notBegun = 0, legEnds = 8;
constexpr bool legHasEnded(LegPhase phase) {
  return phase >= legEnds;
}

/// At most half of what wraps.
template <typename Scalar>
constexpr std::uint32_t microseconds(Scalar duration_s) {
  if (!(duration_s > Scalar(0))) return 0;
  return duration_s < Scalar(2000) ? static_cast<std::uint32_t>(duration_s * Scalar(1e6) + Scalar(0.5))
                                   : 2'000'000'000u;
}

/// By which a wrapping count or time is ahead of another.
constexpr std::int32_t aheadOf(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
/// |way| ≤ room
constexpr bool isWithin(std::int32_t way, std::int32_t room) {
  return way <= room && way >= -room;
}

}  // namespace breakaway
