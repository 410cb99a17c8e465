#include "recording/import/json_log.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "base/json_text.h"
#include "recording/import/clock_time.h"
#include "recording/import/python_dicts.h"
#include "recording/import/sysid_json.h"
#include "recording/import/text_signals.h"
#include "recording/import/text_table.h"
#include "recording/import/unit_texts.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

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

std::string within(const std::string& prefix, const std::string& key) {
  return prefix.empty() || key.empty() ? prefix + key : prefix + "." + key;
}

std::string plainText(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// A number, true, false or nothing.
bool isPlain(const Json& value) {
  return value.is_number() || value.is_boolean() || value.is_null();
}

/// One cell; whole numbers beyond a double's digits are counted from the column's first.
void putCell(const Json& value, RawColumn& column, const std::string& place, bool first) {
  auto& values = column.channel.values;
  if (value.is_number_integer() && std::abs(value.get<double>()) >= 1e15) {
    const auto whole = value.get<int64_t>();
    if (first) column.origin = static_cast<double>(whole);
    values.push_back(static_cast<double>(whole - static_cast<int64_t>(column.origin)));
    return;
  }
  double number = std::numeric_limits<double>::quiet_NaN();
  if (value.is_boolean()) number = value.get<bool>() ? 1.0 : 0.0;
  if (value.is_number()) number = value.get<double>() - column.origin;
  if (value.is_string()) {
    if (const auto clock = readClock(value.get_ref<const std::string&>())) {
      if (first) column.origin = static_cast<double>(clock->whole_s), column.clock = true;
      number = static_cast<double>(clock->whole_s) - column.origin + clock->fraction_s;
      values.push_back(column.clock ? number : NAN);
      return;
    }
  }
  if (value.is_string()) rememberText(column, values.size(), value.get_ref<const std::string&>());
  values.push_back(std::isfinite(number) ? number : NAN);
  if (!isPlain(value) && !column.fault)
    column.fault = Error{place + ", field " + column.channel.name,
                         message("expected a number, found {}", plainText(value).substr(0, 40))};
}

/// Units that stand in fields of their own: {"value": 1, "unit": "deg"}, {"pos": 1, "pos_unit": "deg"}, and
/// {"units": {"pos": "deg"}}.
void collectUnits(const Json& json, const std::string& prefix, UnitTexts& units) {
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    const auto told = toldUnitOf(key);
    if (told && value.is_string()) units[within(prefix, *told)] = value.get<std::string>();
    if (told && value.is_object()) {
      for (const auto& [name, unit] : value.items()) {
        if (unit.is_string()) units[name] = unit.get<std::string>();
      }
    } else {
      collectUnits(value, within(prefix, key), units);
    }
  }
}

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
    for (const Json& one : *it) names.push_back(plainText(one));
    return names;
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

/// {"time": […], "angle": […]}, also an object deeper; lists of lists, one per row or one per signal, become NAME[0],
/// NAME[1] ….
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

/// Whether the rows are but one of several arrays by name that are as long: {"time": […], "joints": [[…], […]]}.
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

/// {"time": {"0": 0.1, "1": 0.2}, …}, as pandas writes it.
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

/// Rows, with the names of their columns beside them.
Result<RawTable> rowsOf(const Json& json, const Json& rows, const std::string& name) {
  const size_t width = rows.front().size();
  const std::vector<std::string> names = namesOf(json, width);
  RawTable table;
  for (size_t c = 0; c < width; ++c) {
    RawColumn column{{c < names.size() ? names[c] : "column_" + std::to_string(c + 1), {}}, {}};
    for (size_t k = 0; k < rows.size(); ++k) {
      if (!rows[k].is_array() || rows[k].size() != width)
        return Error{name + ", entry " + std::to_string(k + 1), message("has other than {} numbers", width)};
      putCell(rows[k][c], column, name + ", entry " + std::to_string(k + 1), k == 0);
    }
    table.columns.push_back(std::move(column));
  }
  return table;
}

bool isArrayOfRows(const Json& array) {
  return array.size() > 1 && array.front().is_array() && array.front().size() > 1 && isPlain(array.front().front());
}

constexpr size_t mostFields = 5000;

std::string lineOf(const std::string& text, size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return std::to_string(1 + std::count(text.begin(), end, '\n'));
}

/// The longest array that `fits`, wherever it stands; its path of keys in `key`.
const Json* longest(const Json& json, bool (*fits)(const Json&)) {
  const Json* best = nullptr;
  const std::function<void(const Json&)> look = [&](const Json& one) {
    if (one.is_array() && fits(one) && (best == nullptr || one.size() > best->size())) best = &one;
    if (one.is_object()) {
      for (const auto& [key, value] : one.items()) look(value);
    }
  };
  look(json);
  return best;
}

bool isArrayOfObjects(const Json& array) {
  return !array.empty() && array.front().is_object();
}

/// The fields of a sample, objects and short arrays of numbers flattened.
void flatten(const Json& sample, const std::string& prefix, std::vector<std::pair<std::string, const Json*>>& fields) {
  for (const auto& [key, value] : sample.items()) {
    const std::string name = prefix.empty() ? key : prefix + "." + key;
    if (fields.size() >= mostFields) return;
    if (value.is_object()) {
      flatten(value, name, fields);
    } else if (value.is_array()) {
      for (size_t k = 0; k < value.size() && k < 64; ++k) {
        if (isPlain(value[k])) fields.emplace_back(name + "[" + std::to_string(k) + "]", &value[k]);
      }
    } else {
      fields.emplace_back(name, &value);
    }
  }
}

/// Entries of one signal each, {"time": 1, "name": "angle", "value": 2}: as the table of text that they would be.
bool areOfOneSignalEach(const Json& sample) {
  if (!sample.is_object()) return false;
  bool signal = false, value = false;
  for (const auto& [key, one] : sample.items()) {
    signal = signal || (one.is_string() && tellsSignal(key));
    value = value || (one.is_number() && tellsValue(key));
  }
  return signal && value;
}

std::string longTableOf(const std::vector<const Json*>& samples) {
  std::vector<std::string> keys;
  for (const auto& [key, one] : samples.front()->items()) {
    if (one.is_primitive()) keys.push_back(key);
  }
  std::string text;
  const auto add = [&text](std::string cell, bool last) {
    std::replace_if(
        cell.begin(), cell.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r' || c == '"'; }, ' ');
    text += cell + (last ? "\n" : "\t");
  };
  for (const std::string& key : keys) add(key, &key == &keys.back());
  for (const Json* sample : samples) {
    for (const std::string& key : keys) {
      const auto one = sample->is_object() ? sample->find(key) : sample->end();
      const bool missing = one == sample->end() || one->is_null() || one->is_structured();
      add(missing ? std::string() : plainText(*one), &key == &keys.back());
    }
  }
  return text;
}

bool tellsUnit(const std::string& key) {
  const auto words = wordsOf(key, true);
  return !words.empty() && (words.back() == "unit" || words.back() == "units" || words.back() == "einheit");
}

Result<RawTable> samplesOf(const std::vector<const Json*>& samples, const std::string& name) {
  if (areOfOneSignalEach(*samples.front())) {
    if (auto table = readTextTable(longTableOf(samples), name)) return table;
  }
  RawTable table;
  std::vector<std::pair<std::string, const Json*>> fields;
  flatten(*samples.front(), "", fields);
  for (const auto& [key, value] : fields) {
    // Texts may tell which motor an entry is about; those that are units are heeded elsewhere.
    if (isPlain(*value) || (value->is_string() && !tellsUnit(key))) {
      table.columns.push_back({{key, {}}, {}});
    } else {
      table.remarks.push_back(message("the field {} holds no numbers and was left out", key));
    }
  }
  const bool anyNumber =
      std::any_of(fields.begin(), fields.end(), [](const std::pair<std::string, const Json*>& field) {
        const Json& value = *field.second;
        return isPlain(value) || (value.is_string() && readClock(value.get_ref<const std::string&>()));
      });
  if (!anyNumber) return Error{name, message("holds a log without any number")};
  UnitTexts units;
  collectUnits(*samples.front(), "", units);
  giveUnits(units, table);
  size_t without = 0;
  for (size_t k = 0; k < samples.size(); ++k) {
    const std::string place = name + ", entry " + std::to_string(k + 1);
    if (!units.empty()) {
      UnitTexts these;
      collectUnits(*samples[k], "", these);
      if (these != units && !these.empty()) return Error{place, message("has other units than the first entry")};
    }
    fields.clear();
    if (samples[k]->is_object()) flatten(*samples[k], "", fields);
    size_t next = 0;
    for (RawColumn& column : table.columns) {
      auto field = next < fields.size() && fields[next].first == column.channel.name
                       ? fields.begin() + static_cast<std::ptrdiff_t>(next)
                       : std::find_if(fields.begin(), fields.end(),
                                      [&](const auto& one) { return one.first == column.channel.name; });
      if (field == fields.end() && column.fault) {
        column.channel.values.push_back(NAN);
        continue;
      }
      if (field == fields.end()) {
        if (++without > samples.size() / 50 * table.columns.size())
          return Error{place, message("lacks the field {}", column.channel.name)};
        column.channel.values.push_back(NAN);
        continue;
      }
      putCell(*field->second, column, place, k == 0);
      next = static_cast<size_t>(field - fields.begin()) + 1;
    }
  }
  if (without > 0) table.remarks.push_back(message("{} fields lack in some entries; they are missing values", without));
  return table;
}

/// {"0": {"time": 0.1, …}, "1": {…}, …}: samples by their number, stamp or key.
bool areSamplesByKey(const Json& json) {
  constexpr size_t fewest = 3;
  if (!json.is_object() || json.size() < fewest) return false;
  const Json& first = *json.begin();
  if (!first.is_object() || first.empty()) return false;
  return std::all_of(json.begin(), json.end(), [&first](const Json& one) {
    return one.is_object() && one.size() == first.size() && one.begin().key() == first.begin().key() &&
           std::all_of(one.begin(), one.end(), [](const Json& field) { return field.is_primitive(); });
  });
}

/// Keys that are stamps are a column of their own: numbers other than the samples' own, or dates.
Json withKeys(const Json& json) {
  Json samples = Json::array();
  for (const auto& [key, sample] : json.items()) {
    Json one = Json::object();
    double number = 0.0;
    const auto [stop, code] = std::from_chars(key.data(), key.data() + key.size(), number);
    const bool isNumber = code == std::errc() && stop == key.data() + key.size();
    const bool counts = isNumber && number < static_cast<double>(json.size()) + 1.0 && number == std::floor(number);
    if (!sample.contains("timestamp")) {
      if (isNumber && !counts) one["timestamp"] = number;
      if (!isNumber && readClock(key)) one["timestamp"] = key;
    }
    for (const auto& [name, value] : sample.items()) one[name] = value;
    samples.push_back(std::move(one));
  }
  return samples;
}

void addNotes(const Json& json, RawTable& table) {
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    if (value.is_primitive()) table.notes.emplace_back(key, plainText(value));
  }
}

Result<RawTable> plainLog(const Json& json, const std::string& name) {
  const Json* samples = nullptr;
  for (const char* key : {"entries", "samples", "data"}) {
    if (json.is_object() && json.contains(key) && json[key].is_array() && isArrayOfObjects(json[key]))
      samples = &json[key];
  }
  if (samples == nullptr) samples = longest(json, isArrayOfObjects);
  Result<RawTable> table = Error{name, message("holds no log")};
  if (samples != nullptr && samples->size() > 1) {
    std::vector<const Json*> each;
    for (const Json& one : *samples) each.push_back(&one);
    table = samplesOf(each, name);
  } else if (isByIndex(json)) {
    table = byIndex(json, name);
  } else if (areSamplesByKey(json)) {
    const Json keyed = withKeys(json);
    std::vector<const Json*> each;
    for (const Json& one : keyed) each.push_back(&one);
    table = samplesOf(each, name);
  } else if (const Json* rows = longest(json, isArrayOfRows)) {
    table = isTableOfArrays(json, *rows) ? arraysOf(json, name) : rowsOf(json, *rows, name);
  } else if (json.is_object()) {
    table = arraysOf(json, name);
  }
  if (!table) {
    if (table.error().fact != "holds no log") return table.error();
    return Error{name,
                 message("holds no log: expected \"entries\": an array of objects, one per sample, or arrays by name")};
  }
  addNotes(json, *table);
  UnitTexts units;
  collectUnits(json, "", units);
  giveUnits(units, *table);
  return table;
}

Result<ReadTable> tableOf(const Json& json, const std::string& name) {
  auto table = plainLog(json, name);
  if (!table) return table.error();
  return ReadTable{std::move(*table), {}};
}

/// One object per line; other lines are left out.
Result<ReadTable> linesOf(const std::string& text, const std::string& name) {
  std::vector<Json> kept;
  size_t others = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    const size_t start = text.find_first_not_of(" \t\r,", at);
    if (start < end) {
      Json one = Json::parse(text.begin() + static_cast<std::ptrdiff_t>(start),
                             text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
      if (one.is_object()) {
        kept.push_back(std::move(one));
      } else {
        ++others;
      }
    }
    at = end + 1;
  }
  if (kept.size() < 2 || others > kept.size() / 10 + 1) return Error{name, message("holds no log")};
  std::vector<const Json*> samples;
  samples.reserve(kept.size());
  for (const Json& one : kept) samples.push_back(&one);
  auto table = samplesOf(samples, name);
  if (!table) return table.error();
  if (others > 0) table->remarks.push_back(message("{} lines are no JSON objects and were left out", others));
  return ReadTable{std::move(*table), {}};
}

}  // namespace

Result<ReadTable> readJsonLog(const std::string& text, const std::string& name) {
  if (nestsTooDeep(text)) return Error{name, message("nests deeper than {} levels, as no log does", deepestJson)};
  if (isPythonDicts(text)) return readJsonLog(pythonAsJson(text), name);
  const auto fault = jsonFault(text, name);
  if (fault && fault->fact.ends_with("twice in one object")) return *fault;
  try {
    if (auto tests = readSysId(text, name)) return std::move(*tests);
    return tableOf(Json::parse(text), name);
  } catch (const Json::parse_error& error) {
    try {
      if (auto lines = linesOf(text, name)) return lines;
    } catch (const Json::exception&) {  // not one object per line either
    }
    return Error{name + ", line " + lineOf(text, error.byte > 0 ? error.byte - 1 : 0), message("is not valid JSON")};
  } catch (const Json::out_of_range&) {
    return Error{name, message("holds a number that is beyond all that can be computed with")};
  } catch (const Json::exception&) {
    return Error{name, message("holds no log that is understood")};
  }
}

}  // namespace breakaway
