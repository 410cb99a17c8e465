// The values of a log in JSON, cell by cell, and the units that stand beside them.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "recording/import/raw_table.h"

namespace breakaway {

/// Fields in their order. A new one is appended without a look at all the others: texts are checked before for fields
/// that stand twice.
template <typename Key, typename T, typename Ignored = std::less<Key>,
          typename Allocator = std::allocator<std::pair<const Key, T>>>
struct FieldsInOrder : nlohmann::ordered_map<Key, T, Ignored, Allocator> {
  using Base = nlohmann::ordered_map<Key, T, Ignored, Allocator>;
  using Base::Base;

  T& operator[](const Key& key) { return this->Base::Container::emplace_back(key, T{}).second; }
};

using JsonInOrder = nlohmann::basic_json<FieldsInOrder>;

/// A number, true, false or nothing.
bool isPlain(const JsonInOrder& value);
std::string plainText(const JsonInOrder& value);

/// One cell; whole numbers beyond a double's digits are counted from the column's first.
void putCell(const JsonInOrder& value, RawColumn& column, const std::string& place, bool first);

/// Units by the field that has them.
using UnitTexts = std::map<std::string, std::string>;

/// Units that stand in fields of their own: {"value": 1, "unit": "deg"}, {"pos": 1, "pos_unit": "deg"}, and
/// {"units": {"pos": "deg"}}.
void collectUnits(const JsonInOrder& json, const std::string& prefix, UnitTexts& units);
void giveUnits(const UnitTexts& units, RawTable& table);

}  // namespace breakaway
