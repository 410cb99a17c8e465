#include "recording/import/json_log.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "base/json_text.h"
#include "recording/import/json_arrays.h"
#include "recording/import/json_cells.h"
#include "recording/import/json_samples.h"
#include "recording/import/json_series.h"
#include "recording/import/python_dicts.h"
#include "recording/import/sysid_json.h"
#include "recording/import/unit_texts.h"

namespace breakaway {

namespace {

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

void addNotes(const Json& json, RawTable& table) {
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    if (value.is_primitive()) table.notes.emplace_back(key, plainText(value));
  }
}

/// Single values deeper than notes stand.
void addBeside(const Json& json, size_t depth, RawTable& table) {
  constexpr size_t deepest = 4, most = 1000;
  if (!json.is_object() || depth > deepest) return;
  for (const auto& [key, value] : json.items()) {
    if (value.is_primitive() && depth > 0 && table.beside.size() < most)
      table.beside.emplace_back(key, plainText(value));
    if (value.is_object()) addBeside(value, depth + 1, table);
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
  const Json* rowsBeside = longest(json, isArrayOfRows);  // objects that describe their columns are no samples
  const bool described = samples != nullptr && rowsBeside != nullptr && samples->size() == rowsBeside->front().size() &&
                         samples->front().contains("name");
  if (samples != nullptr && samples->size() > 1 && !described) {
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
  } else if (const Json* rows = rowsBeside) {
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
  addBeside(json, 0, *table);
  UnitTexts units;
  collectUnits(json, "", units);
  giveUnits(units, *table);
  return table;
}

Result<ReadTable> tableOf(const Json& json, const std::string& name) {
  auto series = readSeries(json, name);
  auto table = series ? std::move(*series) : plainLog(json, name);
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
