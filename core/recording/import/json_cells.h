// Values of JSON as cells of a table.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "recording/import/raw_table.h"
#include "recording/import/unit_texts.h"

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

using Json = nlohmann::basic_json<FieldsInOrder>;

std::string plainText(const Json& value);

/// A number, true, false or nothing.
bool isPlain(const Json& value);

/// One cell; whole numbers beyond a double's digits are counted from the column's first.
void putCell(const Json& value, RawColumn& column, const std::string& place, bool first);

/// Units that stand in fields of their own: {"value": 1, "unit": "deg"}, {"pos": 1, "pos_unit": "deg"}, and
/// {"units": {"pos": "deg"}}.
void collectUnits(const Json& json, const std::string& prefix, UnitTexts& units);

/// A field that tells a unit.
bool tellsUnit(const std::string& key);

}  // namespace breakaway
