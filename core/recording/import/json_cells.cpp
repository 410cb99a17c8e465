#include "recording/import/json_cells.h"

#include <cmath>
#include <limits>

#include "recording/import/clock_time.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

std::string within(const std::string& prefix, const std::string& key) {
  return prefix.empty() || key.empty() ? prefix + key : prefix + "." + key;
}

}  // namespace

std::string plainText(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool isPlain(const Json& value) {
  return value.is_number() || value.is_boolean() || value.is_null();
}

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

bool tellsUnit(const std::string& key) {
  const auto words = wordsOf(key, true);
  return !words.empty() && (words.back() == "unit" || words.back() == "units" || words.back() == "einheit");
}

}  // namespace breakaway
