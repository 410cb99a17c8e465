#include "recording/json_log.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace breakaway {

namespace {

using Json = nlohmann::ordered_json;

const Json* entriesOf(const Json& json) {
  if (json.is_array()) return &json;
  for (const char* name : {"entries", "samples", "data"}) {
    if (json.is_object() && json.contains(name) && json[name].is_array()) return &json[name];
  }
  return nullptr;
}

std::string lineOf(const std::string& text, size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return std::to_string(1 + std::count(text.begin(), end, '\n'));
}

std::string plainText(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<RawTable> tableOf(const Json& json, const std::string& name) {
  const Json* entries = entriesOf(json);
  if (entries == nullptr || entries->empty() || !entries->front().is_object()) {
    return Error{name, "holds no log: expected \"entries\": an array of objects, one per sample"};
  }
  RawTable table;
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      if (value.is_primitive()) table.notes.emplace_back(key, plainText(value));
    }
  }
  for (const auto& [key, value] : entries->front().items()) {
    if (value.is_number() || value.is_boolean() || value.is_null()) {
      table.columns.push_back({{key, {}}, {}});
    } else {
      table.remarks.push_back("the field " + key + " holds no numbers and was left out");
    }
  }
  for (RawColumn& column : table.columns) {
    column.channel.values.reserve(entries->size());
    for (size_t k = 0; k < entries->size(); ++k) {
      const Json& entry = (*entries)[k];
      const auto field = entry.is_object() ? entry.find(column.channel.name) : entry.end();
      const bool there = entry.is_object() && field != entry.end();
      if (!there) {
        return Error{name + ", entry " + std::to_string(k + 1), "lacks the field " + column.channel.name};
      }
      const bool number = field->is_number() || field->is_boolean();
      const double value = field->is_boolean() ? (field->get<bool>() ? 1.0 : 0.0) : number ? field->get<double>() : NAN;
      column.channel.values.push_back(std::isfinite(value) ? value : NAN);
      if (!number && !field->is_null() && !column.fault) {
        column.fault = Error{name + ", entry " + std::to_string(k + 1) + ", field " + column.channel.name,
                             "expected a number, found " + plainText(*field).substr(0, 40)};
      }
    }
  }
  if (table.columns.empty()) return Error{name, "holds a log without any number"};
  return table;
}

}  // namespace

Result<RawTable> readJsonLog(const std::string& text, const std::string& name) {
  try {
    return tableOf(Json::parse(text), name);
  } catch (const Json::parse_error& error) {
    return Error{name + ", line " + lineOf(text, error.byte > 0 ? error.byte - 1 : 0), "is not valid JSON"};
  } catch (const Json::out_of_range&) {
    return Error{name, "holds a number that is beyond all that can be computed with"};
  }
}

}  // namespace breakaway
