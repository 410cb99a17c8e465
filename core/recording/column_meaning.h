// What a column of a foreign log is, by its name: "Drehzahl [1/min]", "t_ms", "goal_position".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breakaway {

/// value in the column's unit = scale × value + offset.
struct Meaning {
  std::string to;  ///< the column's name, with its unit
  double scale = 1.0;
  double offset = 0.0;
  bool unitGiven = false;  ///< the name told the unit; else SI is assumed

  bool operator==(const Meaning&) const = default;
};

/// The meaning of a column's name, or nothing when the quantity is unknown, or its unit is unknown or no unit of that
/// quantity. A unit may stand in brackets, after " in ", after a slash or as the last words ("angle_deg"); case and
/// separators don't matter.
std::optional<Meaning> meaningOf(std::string_view name);

/// Whether the text is a unit that is understood, with or without brackets.
bool isUnit(std::string_view text);

}  // namespace breakaway
