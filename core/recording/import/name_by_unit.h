// What a column is by its unit, where no word of its name tells: "rpm", "Iq_mA", "dc_bus_v".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "recording/import/column_name.h"
#include "recording/import/name_parts.h"

namespace breakaway {

/// The contract's name of what is counted in such a unit; empty where there is none.
std::string contractName(UnitKind kind, bool reference);

ColumnName nameAside(Message why, const NameParts& parts);
/// Aside, for no word of the name is known.
ColumnName nameThatSaysNothing(const NameParts& parts);

/// Taken as `to` in the unit of its name.
ColumnName nameTaken(const NameParts& parts, std::string to, int rank);

/// "logic_supply_v" comes after "dc_bus_v".
ColumnName supplyOf(const NameParts& parts);

bool isSingleLetter(const std::string& word, std::string_view letters);

/// Why a column of the electrical side isn't the motor's own; empty when it may be.
Message notTheMotors(UnitKind kind, const Words& words, bool supply);

/// Where no word names a quantity the unit may.
ColumnName nameByUnit(const NameParts& parts);

/// A name that is nothing but a unit: "rpm", "millis".
std::optional<ColumnName> unitAsName(std::string_view name);

}  // namespace breakaway
