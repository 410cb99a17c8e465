// What a column of a foreign log is, by its name and unit: "Drehzahl [1/min]", "t_ms", "axis0.encoder.pos_estimate".
#pragma once

#include <string>
#include <string_view>

#include "base/message.h"
#include "recording/import/units.h"

namespace breakaway {

/// What a name and its unit tell: value in the contract's unit = scale × value + offset, divided by what is needed.
struct ColumnName {
  std::string to;                ///< the contract's name, with its unit; empty when the column isn't understood
  Message aside;                 ///< then: why
  bool saysNothing = false;      ///< then: no word of the name is known
  bool nameless = false;         ///< then: there is no word
  std::string unknownWord = {};  ///< then: the word behind the quantity that may change everything
  double scale = 1.0;
  double offset = 0.0;
  std::string unit;        ///< as written; empty when the name tells none, and SI is assumed
  std::string usual = {};  ///< then: the unit in which people count such a thing, if its word tells one
  UnitNeeds needs = UnitNeeds::nothing;
  std::string group;       ///< which of several axes: the numbers in the name; empty for all or none
  bool byUnit = false;     ///< no word tells what it is, its unit alone does
  Message guess = {};      ///< why it may be otherwise; empty when nothing says so
  int rank = 0;            ///< of several columns for the same thing the lowest is taken
  bool qualified = false;  ///< an unknown word stands before: "hand_torque" comes after "torque"

  bool understood() const { return !to.empty(); }
  bool operator==(const ColumnName&) const = default;
};

/// The last word that names a quantity decides, with its unit, whatever stands before it; words behind it that may
/// change everything ("velocity error", "current limit") leave the column aside, and so do those of other things
/// ("gyro", "load torque", "battery current", "d axis"). A unit may stand in brackets anywhere, after " in ", after a
/// slash, as the last words ("angle_deg", "omega_rad_s"), or, as `unit`, apart. Case and separators don't matter. A
/// unit that is unknown or is none of that quantity leaves the column aside.
ColumnName understandName(std::string_view name, std::string_view unit = {});

/// Whether a word of the name is that of a quantity.
bool knowsQuantity(std::string_view name);

}  // namespace breakaway
