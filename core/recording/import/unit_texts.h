// Units that a log tells in fields of their own.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "recording/import/raw_table.h"

namespace breakaway {

/// Units by the field that has them.
using UnitTexts = std::map<std::string, std::string>;

/// What "pos_unit" or "posUnits" tells the unit of, "" of "unit"; nothing for other keys.
std::optional<std::string> toldUnitOf(const std::string& key);
void giveUnits(const UnitTexts& units, RawTable& table);

}  // namespace breakaway
