#include "recording/import/json_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "recording/import/signal_log.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

template <typename Names>
bool isOneOf(const Names& names, std::string_view key) {
  return std::any_of(names.begin(), names.end(), [key](std::string_view one) { return isSameWord(key, one); });
}

bool isNumbers(const Json& array) {
  return array.is_array() && array.size() > 1 && std::all_of(array.begin(), array.end(), isPlain);
}

bool isPairs(const Json& array) {
  return array.is_array() && array.size() > 1 && std::all_of(array.begin(), array.end(), [](const Json& one) {
           return one.is_array() && one.size() == 2 && one[0].is_number() && one[1].is_number();
         });
}

void put(Signal& signal, const Json& stamp, const Json& value) {
  constexpr double most = 9e18;
  const double at = stamp.is_number() ? stamp.get<double>() : NAN;
  if (!(std::abs(at) < most)) return;
  const auto whole = static_cast<int64_t>(std::floor(at));
  signal.stamps.push_back(stamp.is_number_integer() ? Stamp{stamp.get<int64_t>(), 0.0}
                                                    : Stamp{whole, at - static_cast<double>(whole)});
  signal.values.push_back(value.is_boolean()  ? (value.get<bool>() ? 1.0 : 0.0)
                          : value.is_number() ? value.get<double>()
                                              : NAN);
}

bool rises(const Json& pairs, size_t side) {
  for (size_t k = 1; k < pairs.size(); ++k) {
    if (pairs[k][side].get<double>() < pairs[k - 1][side].get<double>()) return false;
  }
  return pairs.back()[side].get<double>() > pairs.front()[side].get<double>();
}

void takePairs(const Json& pairs, Signal signal, std::vector<Signal>& signals) {
  const size_t side = rises(pairs, 0) ? 0 : 1;
  if (!rises(pairs, side)) return;
  for (const Json& one : pairs) put(signal, one[side], one[1 - side]);
  signals.push_back(std::move(signal));
}

/// An object's texts that tell of which signal it is, and its unit.
Signal headOf(const Json& json, const std::string& path) {
  static constexpr auto names = std::to_array<std::string_view>(
      {"name", "label", "signal", "target", "channel", "metric", "title", "key", "field", "topic"});
  Signal signal{path, "", {}, {}};
  bool named = false;
  for (const auto& [key, value] : json.items()) {
    if (!value.is_string()) continue;
    if (tellsUnit(key)) signal.unit = value.get<std::string>();
    if (!named && isOneOf(names, key)) {
      signal.name = value.get<std::string>();
      named = true;
    }
  }
  return signal;
}

void collect(const Json& json, const std::string& path, std::vector<Signal>& signals) {
  static constexpr auto stamps =
      std::to_array<std::string_view>({"x", "t", "time", "times", "timestamp", "timestamps", "stamps"});
  static constexpr auto values = std::to_array<std::string_view>({"y", "v", "value", "values", "data"});
  if (json.is_array()) {
    for (const Json& one : json) {
      if (one.is_object()) collect(one, path, signals);
    }
  }
  if (!json.is_object()) return;
  Signal signal = headOf(json, path);
  const Json *at = nullptr, *of = nullptr, *pairs = nullptr;
  size_t arrays = 0;
  for (const auto& [key, value] : json.items()) {
    arrays += value.is_array() ? 1 : 0;
    if (isNumbers(value) && isOneOf(stamps, key)) at = &value;
    if (isNumbers(value) && isOneOf(values, key)) of = &value;
    if (isPairs(value)) pairs = &value;
  }
  const bool apart = arrays == 2 && at != nullptr && of != nullptr && at->size() == of->size();
  if (!signal.name.empty() && apart) {
    for (size_t k = 0; k < at->size(); ++k) put(signal, (*at)[k], (*of)[k]);
    signals.push_back(std::move(signal));
  } else if (arrays == 1 && pairs != nullptr && signal.name != path) {
    takePairs(*pairs, std::move(signal), signals);
  } else {
    for (const auto& [key, value] : json.items()) collect(value, path.empty() ? key : path + "." + key, signals);
  }
}

}  // namespace

std::optional<Result<RawTable>> readSeries(const Json& json, const std::string& name) {
  std::vector<Signal> signals;
  collect(json, "", signals);
  if (signals.empty()) return std::nullopt;
  return tableOfSignals(signals, {"time", "", false}, message("signals with stamps of their own"), name);
}

}  // namespace breakaway
