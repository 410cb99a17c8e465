// Times of day and dates as people and programs write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace breakaway {

struct ClockTime {
  int64_t whole_s = 0;      ///< since midnight, or since 1970 when a date stands there
  double fraction_s = 0.0;  ///< 0 to 1
  bool dated = false;
  bool operator==(const ClockTime&) const = default;
};

/// "10:20:10.000", "10:20:10,5", "2024-05-01T10:20:10.000Z", "01.05.2024 10:20:10", "5/1/2024 3:20:10.5 PM",
/// "2024/05/01 10:20:10::123", "02:13.5" (minutes and seconds), also in brackets; nothing for all else. A zone is read
/// over: only differences count.
std::optional<ClockTime> readClock(std::string_view text);

}  // namespace breakaway
