#include "friction/map_json.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "base/json_text.h"
#include "friction/map_export.h"
#include "friction/map_table.h"

namespace breakaway {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* schema = "breakaway.map/1";
constexpr const char* wayNames[] = {"cw", "ccw"};

Json estimateJson(const Estimate& estimate) {
  return {{"value", estimate.value}, {"ci95", {estimate.low95(), estimate.high95()}}, {"std", estimate.standardError}};
}

/// Reads with the first fault kept; fields that it doesn't know are let be, because maps may carry more than this.
class Reader {
 public:
  Reader(const Json& json, std::string place) : json_(json), place_(std::move(place)) {}

  double number(const Json& object, const std::string& name, const std::string& where) {
    const auto it = object.is_object() ? object.find(name) : object.end();
    if (object.is_object() && it != object.end() && (it->is_number() || it->is_boolean())) return it->get<double>();
    fault(where + name,
          object.is_object() && it != object.end() ? "expected a number" : "is missing, expected a number");
    return 0.0;
  }
  Estimate estimate(const std::string& name) {
    const Json empty = Json::object();
    const Json& object = json_.contains(name) ? json_[name] : empty;
    Estimate result{number(object, "value", name + "."), 0.0};
    if (object.is_object() && object.contains("std")) result.standardError = number(object, "std", name + ".");
    return result;
  }
  void fault(const std::string& field, const std::string& fact) {
    if (!first_) first_ = Error{place_ + ", field " + field, fact};
  }
  const std::optional<Error>& first() const { return first_; }

 private:
  const Json& json_;
  std::string place_;
  std::optional<Error> first_;
};

std::vector<MapColumn> readBins(const Json& bins, Axis axis, Reader& reader) {
  FrictionMap like;
  like.axis = axis;
  std::vector<MapColumn> columns;
  for (const MapColumn& column : mapTable(like)) {
    const bool optional = column.name.rfind("outlier", 0) == 0 && !bins[0].contains(column.name);
    if (optional) continue;
    MapColumn filled{column.name, {}};
    for (size_t k = 0; k < bins.size(); ++k)
      filled.values.push_back(reader.number(bins[k], column.name, "bins[" + std::to_string(k) + "]."));
    columns.push_back(std::move(filled));
  }
  return columns;
}

void readTurns(const Json& json, FrictionMap& map, Reader& reader) {
  for (size_t w = 0; w < 2; ++w) {
    const std::string field = nameOn(map.axis, "turn_static_Nm"), place = field + "." + wayNames[w];
    if (!json.contains(field) || !json[field].contains(wayNames[w])) continue;
    for (const Json& turn : json[field][wayNames[w]]) {
      std::vector<double> values;
      bool good = turn.is_array() && turn.size() == map.bins.size();
      for (const Json& value : turn) {
        good = good && value.is_number();
        if (good) values.push_back(value.get<double>());
      }
      if (!good) return reader.fault(place, "expected turns of " + std::to_string(map.bins.size()) + " numbers");
      map.turnStatic_Nm[w].push_back(std::move(values));
    }
  }
}

Result<FrictionMap> readMapJson(const Json& json, const std::string& place) {
  Reader reader(json, place);
  if (!json.is_object()) return Error{place, "expected a JSON object"};
  if (!json.contains("schema") || json["schema"] != schema)
    return Error{place + ", field schema", std::string("expected \"") + schema + "\""};
  if (!json.contains("bins") || !json["bins"].is_array() || json["bins"].empty()) {
    return Error{place + ", field bins", "expected an array with at least one bin"};
  }
  FrictionMap map;
  if (json.contains("axis")) {
    if (json["axis"] != "rotary" && json["axis"] != "linear") reader.fault("axis", "expected rotary or linear");
    if (json["axis"] == "linear") map.axis = Axis::linear;
  }
  const auto name = [&map](const char* rotors) { return nameOn(map.axis, rotors); };
  if (json.contains("rig") && json["rig"].is_string()) map.rig = json["rig"].get<std::string>();
  const double turns = reader.number(json, "turns", "");
  if (!(turns >= 0.0 && turns < 1e6)) reader.fault("turns", "expected a count of turns");
  map.turns = reader.first() ? 0 : static_cast<size_t>(turns);
  map.totalVelocity_rad_per_s = reader.number(json, name("total_velocity_rad_per_s"), "");
  const Json settings = json.value("settings", Json::object());
  for (const auto& [key, value] : settings.items()) {
    if (value.is_number()) map.settings.emplace_back(key, value.get<double>());
  }
  for (size_t w = 0; w < 2 && map.turns > 1; ++w) {
    const std::string where = std::string("repeatability.") + wayNames[w] + ".";
    const Json row = json.contains("repeatability") && json["repeatability"].contains(wayNames[w])
                         ? json["repeatability"][wayNames[w]]
                         : Json();
    map.repeatability[w] = {reader.number(row, "correlation", where),
                            reader.number(row, name("rms_difference_Nm"), where)};
  }
  map.coulombAverage_Nm = reader.estimate(name("coulomb_average_Nm"));
  map.viscousAverage_Nm_s_per_rad = reader.estimate(name("viscous_average_Nm_s_per_rad"));
  if (json.contains(name("stribeck_velocity_rad_per_s")))
    map.stribeckVelocity_rad_per_s = reader.estimate(name("stribeck_velocity_rad_per_s"));
  for (const Json& remark : json.value("remarks", Json::array())) {
    if (!remark.is_string()) reader.fault("remarks", "expected texts");
    if (remark.is_string()) map.remarks.push_back(remark.get<std::string>());
  }
  const auto columns = readBins(json["bins"], map.axis, reader);
  for (const MapColumn& column : columns) {
    const bool count = column.name.rfind("samples", 0) == 0;
    for (const double value : column.values) {
      if (count && !(value >= 0.0 && value < 1e9)) reader.fault("bins." + column.name, "expected a count");
    }
  }
  if (!reader.first()) {
    fillFromTable(map, columns);
    readTurns(json, map, reader);
  }
  if (reader.first()) return *reader.first();
  return map;
}

}  // namespace

std::string mapJsonText(const FrictionMap& map) {
  const auto name = [&map](const char* rotors) { return nameOn(map.axis, rotors); };
  Json json{{"schema", schema},
            {"rig", map.rig},
            {"turns", map.turns},
            {name("total_velocity_rad_per_s"), map.totalVelocity_rad_per_s}};
  if (map.axis == Axis::linear) json["axis"] = "linear";
  json["settings"] = Json::object();
  for (const auto& [key, value] : map.settings) json["settings"][key] = value;
  for (size_t w = 0; w < 2 && map.turns > 1; ++w) {  // one turn repeats nothing
    json["repeatability"][wayNames[w]] = Json{{"correlation", map.repeatability[w].correlation},
                                              {name("rms_difference_Nm"), map.repeatability[w].rmsDifference_Nm}};
  }
  json[name("coulomb_average_Nm")] = estimateJson(map.coulombAverage_Nm);
  json[name("viscous_average_Nm_s_per_rad")] = estimateJson(map.viscousAverage_Nm_s_per_rad);
  if (map.stribeckVelocity_rad_per_s.value > 0.0)
    json[name("stribeck_velocity_rad_per_s")] = estimateJson(map.stribeckVelocity_rad_per_s);
  for (size_t w = 0; w < 2; ++w) json[name("turn_static_Nm")][wayNames[w]] = map.turnStatic_Nm[w];
  if (!map.remarks.empty()) json["remarks"] = map.remarks;
  const auto columns = mapTable(map);
  json["bins"] = Json::array();
  for (size_t k = 0; k < map.bins.size(); ++k) {
    Json row = Json::object();
    for (const MapColumn& column : columns) row[column.name] = column.values[k];
    json["bins"].push_back(std::move(row));
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<FrictionMap> readMapText(const std::string& text, const std::string& place) {
  if (text.empty()) return Error{place, "is empty, expected a JSON object"};
  if (auto fault = jsonFault(text, place)) return *fault;
  try {
    return readMapJson(Json::parse(text), place);
  } catch (const Json::exception&) {
    return Error{place, "has a field of another type than expected"};
  }
}

}  // namespace breakaway
