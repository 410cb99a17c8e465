// The messages that carry what a board compensates: friction by angle, the bridge's duty curve. Freestanding.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware_link/wire/bytes.h"

namespace breakaway::wire {

enum class FrictionCurve : std::uint8_t {
  coulombCw = 0,
  coulombCcw = 1,
  viscousCw = 2,
  viscousCcw = 3,
  staticCw = 4,
  staticCcw = 5
};
inline constexpr std::size_t movingCurves = 4, frictionCurves = 6;  ///< the first are of a rotor that turns

/// Part of one curve of the friction table that is being written.
struct FrictionChunk {
  static constexpr std::size_t mostValues = 96;
  FrictionCurve curve = FrictionCurve::coulombCw;
  std::uint16_t first = 0;
  std::uint8_t count = 0;
  float value[mostValues] = {};
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.curve), io(s.first), io.list(s.count, s.value);
  }
};

/// Makes the written table the one that is used, if its values' checksum is this one. No bins: no compensation.
struct FrictionUse {
  std::uint16_t bins = 0;
  std::uint32_t checksum = 0;  ///< CRC-32C over the first four curves' floats, one after the other, `bins` of each
  float index_rad = 0;         ///< of the encoder's index, within a turn, as the encoder counts it
  float blend_rad_per_s = 0;
  float cutoff_rad_per_s = 0;
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.bins), io(s.checksum), io(s.index_rad), io(s.blend_rad_per_s), io(s.cutoff_rad_per_s);
  }
};

/// The same for a table whose curves of static friction were written too; the checksum is over all six.
struct StaticFrictionUse {
  FrictionUse table;
  float stribeck_rad_per_s = 0;  ///< speed over which friction falls from static to Coulomb; 0: static isn't used
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io(s.table), io(s.stribeck_rad_per_s);
  }
};

/// Output duty over input duty, straight between its points, odd, of slope one beyond the last. The first point is the
/// dead zone's end with an output of 0; both rise strictly. Every voltage is asked for through its inverse.
struct BridgeCurve {
  static constexpr std::size_t mostPoints = 16;
  struct Point {
    float input = 0, output = 0;
    template <typename Self, typename Io>
    static void pass(Self& s, Io& io) {
      io(s.input), io(s.output);
    }
  };
  std::uint8_t count = 0;  ///< 0: the bridge gives what it is asked for
  Point point[mostPoints];
  template <typename Self, typename Io>
  static void pass(Self& s, Io& io) {
    io.list(s.count, s.point);
  }
};

}  // namespace breakaway::wire
