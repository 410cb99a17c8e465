// What the recognisers of known tools share.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/import/column_name.h"
#include "recording/import/raw_table.h"

namespace breakaway::tools {

inline const RawColumn* find(const RawTable& table, std::string_view name) {
  const auto it = std::find_if(table.columns.begin(), table.columns.end(),
                               [name](const RawColumn& one) { return isSameWord(one.channel.name, name); });
  return it == table.columns.end() ? nullptr : &*it;
}

inline bool hasAll(const RawTable& table, std::initializer_list<std::string_view> names) {
  return std::all_of(names.begin(), names.end(), [&](std::string_view name) { return find(table, name) != nullptr; });
}

inline bool hasWord(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

inline ColumnName in(std::string to, double scale, const char* unit, int rank = 0,
                     UnitNeeds needs = UnitNeeds::nothing) {
  ColumnName name;
  name.to = std::move(to);
  name.scale = scale;
  name.unit = unit;
  name.rank = rank;
  name.needs = needs;
  return name;
}

inline ColumnName setAside(Message why) {
  ColumnName name;
  name.aside = std::move(why);
  return name;
}

}  // namespace breakaway::tools
