#include "recording/import/json_samples.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "recording/import/clock_time.h"
#include "recording/import/text_signals.h"
#include "recording/import/text_table.h"

namespace breakaway {

namespace {

constexpr size_t mostFields = 5000;

/// The fields of a sample, objects and short arrays of numbers and objects flattened.
void flatten(const Json& sample, const std::string& prefix, std::vector<std::pair<std::string, const Json*>>& fields) {
  for (const auto& [key, value] : sample.items()) {
    const std::string name = prefix.empty() ? key : prefix + "." + key;
    if (fields.size() >= mostFields) return;
    if (value.is_object()) {
      flatten(value, name, fields);
    } else if (value.is_array()) {
      for (size_t k = 0; k < value.size() && k < 64; ++k) {
        const std::string each = name + "[" + std::to_string(k) + "]";
        if (isPlain(value[k])) fields.emplace_back(each, &value[k]);
        if (value[k].is_object()) flatten(value[k], each, fields);
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

}  // namespace

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

}  // namespace breakaway
