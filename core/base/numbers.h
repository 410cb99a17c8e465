// Numbers that have one definition. Boards' own processors compile this too.
#pragma once

namespace breakaway {

inline constexpr double turn_rad = 6.283185307179586;  ///< 2π

/// Half a 95 % interval of a normal error in standard errors: the normal distribution's 97.5 % quantile.
inline constexpr double normal95 = 1.959963984540054;

/// −1, 0 or 1.
template <typename Number>
constexpr Number signOf(Number value) {
  return static_cast<Number>(value > Number{}) - static_cast<Number>(value < Number{});
}

/// Of a way: 0 is falling, −1; 1 is growing, 1.
template <typename Number = double>
constexpr Number signOfWay(int way) {
  return way == 0 ? Number{-1} : Number{1};
}

}  // namespace breakaway
