// What a board lets a setting be.
#pragma once

#include <limits>

namespace breakaway {

struct SettingRange {
  bool offered = true;  ///< else the board keeps this setting to itself, and takes no value for it
  double least = 0.0;   ///< in the setting's own unit
  double most = std::numeric_limits<double>::infinity();  ///< infinite: the board names no bound
  bool operator==(const SettingRange&) const = default;
};

}  // namespace breakaway
