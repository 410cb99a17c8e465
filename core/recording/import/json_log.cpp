#include "recording/import/json_log.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "base/json_text.h"
#include "recording/import/clock_time.h"
#include "recording/import/json_arrays.h"
#include "recording/import/json_cells.h"
#include "recording/import/sysid_json.h"
#include "recording/import/text_signals.h"
#include "recording/import/text_table.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

using Json = JsonInOrder;

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

/// Python's print of dicts and lists, {'t': 0.1, 'on': True, 'x': None}, as JSON.
std::string pythonAsJson(std::string_view text) {
  static constexpr auto words = std::to_array<std::pair<std::string_view, std::string_view>>(
      {{"True", "true"}, {"False", "false"}, {"None", "null"}, {"nan", "null"}, {"inf", "null"}, {"-inf", "null"}});
  std::string json;
  json.reserve(text.size());
  char quote = 0;
  for (size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (quote != 0) {
      if (c == '\\' && k + 1 < text.size()) {
        if (text[k + 1] != '\'') json += c;
        json += text[++k];
      } else if (c == quote) {
        json += '"';
        quote = 0;
      } else {
        json += c == '"' ? "\\\"" : std::string(1, c);
      }
      continue;
    }
    if (c == '\'' || c == '"') {
      quote = c;
      json += '"';
      continue;
    }
    const auto word = std::find_if(words.begin(), words.end(),
                                   [&](const auto& one) { return text.substr(k).starts_with(one.first); });
    json += word == words.end() ? std::string(1, c) : std::string(word->second);
    if (word != words.end()) k += word->first.size() - 1;
  }
  return json;
}

/// Begins with a dict's first key in single quotes, so that none of it stands within a text of JSON.
bool isPython(std::string_view text) {
  const size_t brace = text.find_first_not_of("[ \t\r\n");
  if (brace == std::string_view::npos || text[brace] != '{') return false;
  const size_t first = text.find_first_not_of(" \t\r\n", brace + 1);
  return first != std::string_view::npos && text[first] == '\'';
}

}  // namespace

Result<ReadTable> readJsonLog(const std::string& text, const std::string& name) {
  if (nestsTooDeep(text)) return Error{name, message("nests deeper than {} levels, as no log does", deepestJson)};
  if (isPython(text)) return readJsonLog(pythonAsJson(text), name);
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
