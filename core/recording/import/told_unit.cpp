#include "recording/import/told_unit.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "recording/import/name_parts.h"

namespace breakaway {

std::optional<std::string> toldAngleUnit(const RawTable& table) {
  using Told = std::pair<std::string_view, const char*>;
  static constexpr auto sayings = std::to_array<Told>({{"indegrees=yes", "deg"},
                                                       {"indegrees=no", "rad"},
                                                       {"angles are in degrees", "deg"},
                                                       {"angles are in radians", "rad"},
                                                       {"angles in degrees", "deg"},
                                                       {"angles in radians", "rad"},
                                                       {"positions in degrees", "deg"},
                                                       {"positions in radians", "rad"}});
  for (const std::string& line : table.preamble) {
    std::string text = lowered(line);
    text.erase(std::unique(text.begin(), text.end(), [](char a, char b) { return a == ' ' && b == ' '; }), text.end());
    for (const auto& [saying, unit] : sayings) {
      if (text.find(saying) != std::string::npos) return unit;
    }
  }
  return std::nullopt;
}

}  // namespace breakaway
