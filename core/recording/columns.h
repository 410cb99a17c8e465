// The columns of a recording that mean something: name, unit, axis, meaning, and what may stand in them. Reading,
// import, the recorder and the bench file share this table.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/axis.h"

namespace breakaway {

/// What a column holds. On a linear axis read position for the angle, force for the torque.
enum class Quantity {
  time,
  position,
  velocity,
  voltage,
  duty,
  current,
  torque,
  supply,
  temperature,
  positionReference,
  velocityReference,
  currentReference,
  disturbance,
  index,
  enabled
};

/// What stands in a cell, unless it is missing.
enum class Cell {
  number,  ///< finite
  ratio,   ///< −1 to 1, but for rounding: a larger one counts in something else
  flag     ///< 0 to 1; between them where a log was resampled
};

/// Columns that stand in no such row may hold anything.
struct Column {
  const char* name;  ///< ends in its unit
  const char* unit;  ///< SI; "1" for a plain number
  Quantity quantity;
  std::optional<Axis> axis;  ///< nothing: on either
  Cell cell;
  const char* meaning;
};

std::span<const Column> columns();

/// The column of exactly this name; nullptr for one that means nothing.
const Column* columnNamed(std::string_view name);

/// The column of this quantity that counts in this unit; nullptr when there is none.
const Column* columnIn(std::string_view unit, Quantity quantity);

/// What the quantity's column is called on this axis.
const char* columnName(Quantity quantity, Axis axis);

}  // namespace breakaway
