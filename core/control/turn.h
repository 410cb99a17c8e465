// Angles as a part of a turn in 32 bits: whole turns wrap away by themselves. Freestanding.
#pragma once

#include <cstdint>

namespace breakaway {

/// In 2^-32 turns, towards growing angle.
using Turn = std::uint32_t;

/// `angle_rad` within ±2^31 turns.
template <typename Scalar>
constexpr Turn turnOf(Scalar angle_rad) {
  const Scalar turns = angle_rad * Scalar(0.15915494309189535);
  auto whole = static_cast<std::int64_t>(turns);
  if (turns < Scalar(whole)) --whole;
  return static_cast<Turn>(static_cast<std::uint64_t>((turns - Scalar(whole)) * Scalar(4294967296.0)));
}

}  // namespace breakaway
