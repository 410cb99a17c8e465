#include "recording/import/json_arrays.h"

#include <algorithm>
#include <vector>

namespace breakaway {

namespace {

constexpr size_t mostOfAList = 64;

/// An array by its path of keys.
struct NamedArray {
  std::string path;
  const Json* values = nullptr;

  const Json& first() const { return values->front(); }
  bool plain() const { return isPlain(first()) || first().is_string(); }
  /// Lists of values, one per row, or one per signal.
  bool ofLists() const { return first().is_array() && !first().empty() && isPlain(first().front()); }
};

void collectArrays(const Json& json, const std::string& prefix, std::vector<NamedArray>& arrays) {
  for (const auto& [key, value] : json.items()) {
    const std::string path = prefix.empty() ? key : prefix + "." + key;
    if (value.is_object()) collectArrays(value, path, arrays);
    const NamedArray array{path, &value};
    if (value.is_array() && !value.empty() && (array.plain() || array.ofLists())) arrays.push_back(array);
  }
}

/// The names of so many columns, as a field beside the rows tells them; empty where none does.
std::vector<std::string> namesOf(const Json& json, size_t width) {
  if (!json.is_object()) return {};
  for (const char* key : {"columns", "header", "names", "fields", "labels"}) {
    const auto it = json.find(key);
    if (it == json.end() || !it->is_array() || it->size() != width) continue;
    std::vector<std::string> names;
    for (const Json& one : *it)
      names.push_back(one.is_object() && one.contains("name") ? plainText(one["name"]) : plainText(one));
    return names;
  }
  return {};
}

/// The units of so many columns, where what tells their names does so by objects: {"name": "t", "unit": "ms"}.
std::vector<std::string> unitsOf(const Json& json, size_t width) {
  if (!json.is_object()) return {};
  for (const auto& [key, value] : json.items()) {
    if (!value.is_array() || value.size() != width || !value.front().is_object()) continue;
    std::vector<std::string> units;
    for (const Json& one : value) {
      const auto unit = one.is_object() ? one.find("unit") : one.end();
      units.push_back(unit != one.end() && unit->is_string() ? unit->get<std::string>() : std::string());
    }
    return units;
  }
  return {};
}

std::string placeOf(const std::string& name, size_t row) {
  return name + ", entry " + std::to_string(row + 1);
}

/// NAME[0], NAME[1] … of lists, one per row; where `bySignal`, of lists that are a signal each.
void addLists(const NamedArray& array, size_t rows, bool bySignal, const std::string& name, RawTable& table) {
  static const Json nothing;
  const Json& values = *array.values;
  const size_t width = bySignal ? values.size() : array.first().size();
  for (size_t c = 0; c < std::min(width, mostOfAList); ++c) {
    RawColumn column{{array.path + "[" + std::to_string(c) + "]", {}}, {}};
    for (size_t k = 0; k < rows; ++k) {
      const Json& list = values[bySignal ? c : k];
      const size_t at = bySignal ? k : c;
      putCell(list.is_array() && at < list.size() ? list[at] : nothing, column, placeOf(name, k), k == 0);
    }
    table.columns.push_back(std::move(column));
  }
}

}  // namespace

Result<RawTable> arraysOf(const Json& json, const std::string& name) {
  std::vector<NamedArray> arrays;
  collectArrays(json, "", arrays);
  size_t rows = 0;
  for (const bool plain : {true, false}) {
    for (const NamedArray& array : arrays) {
      if (array.plain() == plain && (plain || rows < 2)) rows = std::max(rows, array.values->size());
    }
  }
  if (rows < 2) return Error{name, message("holds no log")};
  RawTable table;
  for (const NamedArray& array : arrays) {
    const bool asLong = array.values->size() == rows;
    if (asLong && array.plain()) {
      RawColumn column{{array.path, {}}, {}};
      for (size_t k = 0; k < rows; ++k) putCell((*array.values)[k], column, placeOf(name, k), k == 0);
      table.columns.push_back(std::move(column));
    } else if (!array.plain() && (asLong || array.first().size() == rows)) {
      addLists(array, rows, !asLong, name, table);
    } else {
      table.remarks.push_back(
          message("{} has {} values, not {}, and was left out", array.path, array.values->size(), rows));
    }
  }
  return table;
}

bool isTableOfArrays(const Json& json, const Json& rows) {
  if (!json.is_object() || !namesOf(json, rows.front().size()).empty()) return false;
  std::vector<NamedArray> arrays;
  collectArrays(json, "", arrays);
  const auto beside = std::count_if(arrays.begin(), arrays.end(), [&rows](const NamedArray& one) {
    const size_t length = one.values->size();
    return one.values != &rows && length > 1 &&
           (length == rows.size() || (one.plain() && length == rows.front().size()));
  });
  return beside > 0;
}

bool isByIndex(const Json& json) {
  return json.is_object() && !json.empty() && std::all_of(json.begin(), json.end(), [](const Json& column) {
           return column.is_object() && column.contains("0") && isPlain(column["0"]);
         });
}

Result<RawTable> byIndex(const Json& json, const std::string& name) {
  Json arrays = Json::object();
  for (const auto& [key, column] : json.items()) {
    Json values = Json::array();
    for (const auto& [index, value] : column.items()) values.push_back(value);
    arrays[key] = std::move(values);
  }
  return arraysOf(arrays, name);
}

Result<RawTable> rowsOf(const Json& json, const Json& rows, const std::string& name) {
  const size_t width = rows.front().size();
  const std::vector<std::string> names = namesOf(json, width), units = unitsOf(json, width);
  RawTable table;
  for (size_t c = 0; c < width; ++c) {
    RawColumn column{{c < names.size() ? names[c] : "column_" + std::to_string(c + 1), {}}, {}};
    for (size_t k = 0; k < rows.size(); ++k) {
      if (!rows[k].is_array() || rows[k].size() != width)
        return Error{name + ", entry " + std::to_string(k + 1), message("has other than {} numbers", width)};
      putCell(rows[k][c], column, name + ", entry " + std::to_string(k + 1), k == 0);
    }
    if (c < units.size()) column.unit = units[c];
    table.columns.push_back(std::move(column));
  }
  return table;
}

bool isArrayOfRows(const Json& array) {
  return array.size() > 1 && array.front().is_array() && array.front().size() > 1 && isPlain(array.front().front());
}

}  // namespace breakaway
