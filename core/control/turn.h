// Angles as a part of a turn in 32 bits: whole turns wrap away by themselves. Freestanding.
#pragma once

#include <cstdint>

namespace breakaway {

/// In 2^-32 turns, towards growing angle.
using Turn = std::uint32_t;

template <typename Scalar>
inline constexpr Scalar turnsPerRad = Scalar(0.15915494309189535);

/// `angle_rad` within ±2^31 turns; `perRad` is one over another period in place of a turn.
template <typename Scalar>
constexpr Turn turnOf(Scalar angle_rad, Scalar perRad = turnsPerRad<Scalar>) {
  const Scalar turns = angle_rad * perRad;
  auto whole = static_cast<std::int64_t>(turns);
  if (turns < Scalar(whole)) --whole;
  return static_cast<Turn>(static_cast<std::uint64_t>((turns - Scalar(whole)) * Scalar(4294967296.0)));
}

}  // namespace breakaway
