#include "recording/import/import_map.h"

#include <nlohmann/json.hpp>

#include "base/json_object.h"
#include "recording/import/units.h"

namespace breakaway {

namespace {

Result<ImportMap> readMap(JsonObject& root) {
  ImportMap map;
  JsonObject columns = root.object("columns", false);
  for (const std::string& name : columns.objectNames()) {
    JsonObject rule = columns.object(name);
    ColumnRule& read = map.columns[name];
    read = {rule.text("to"), rule.number("scale", 1.0), rule.number("offset", 0.0), rule.text("unit", "")};
    if (read.to.empty() || read.to.find_first_of(",\"#\n") != std::string::npos)
      rule.fault("to", "expected a column's name without commas, quotes and #");
    if (read.scale == 0.0) rule.fault("scale", "is 0, which would leave nothing of the column");
    if (!read.unit.empty() && unitNamed(read.unit) == nullptr) rule.fault("unit", "is no unit that import knows");
    if (!read.unit.empty() && (rule.has("scale") || rule.has("offset")))
      rule.fault("unit", "stands beside scale or offset; say one of them");
  }
  map.sample_time_s = root.optionalNumber("sample_time_s", Allowed::positive);
  map.counts_per_rev = root.optionalNumber("counts_per_rev", Allowed::positive);
  map.pole_pairs = root.optionalNumber("pole_pairs", Allowed::positive);
  map.gear_ratio = root.optionalNumber("gear_ratio", Allowed::positive);
  map.integrate = root.text("integrate", "");
  map.differentiate = root.text("differentiate", "");
  map.split = root.text("split", "");
  if (root.has("join")) map.join = root.texts("join");
  JsonObject sign = root.object("sign", false);
  for (const auto& [name, value] : sign.numbers()) {
    if (value != 1.0 && value != -1.0) sign.fault(name, "must be 1 or -1");
    map.sign[name] = value;
  }
  if (const auto done = root.finish(); !done) return done.error();
  return map;
}

}  // namespace

bool ImportMap::empty() const {
  return columns.empty() && !sample_time_s && !counts_per_rev && !pole_pairs && !gear_ratio && integrate.empty() &&
         differentiate.empty() && join.empty() && split.empty() && sign.empty();
}

std::string importMapText(const ImportMap& map) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, rule] : map.columns) {
    auto& written = json["columns"][name];
    written["to"] = rule.to;
    if (!rule.unit.empty()) {
      written["unit"] = rule.unit;
      continue;
    }
    if (rule.scale != 1.0) written["scale"] = rule.scale;
    if (rule.offset != 0.0) written["offset"] = rule.offset;
  }
  const auto put = [&json](const char* name, const std::optional<double>& value) {
    if (value) json[name] = *value;
  };
  put("sample_time_s", map.sample_time_s);
  put("counts_per_rev", map.counts_per_rev);
  put("pole_pairs", map.pole_pairs);
  put("gear_ratio", map.gear_ratio);
  if (!map.integrate.empty()) json["integrate"] = map.integrate;
  if (!map.differentiate.empty()) json["differentiate"] = map.differentiate;
  if (!map.join.empty()) json["join"] = map.join;
  if (!map.split.empty()) json["split"] = map.split;
  for (const auto& [name, sign] : map.sign) json["sign"][name] = sign;
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Result<ImportMap> readImportMap(const std::string& path) {
  auto root = JsonObject::fromFile(path);
  if (!root) return root.error();
  return readMap(*root);
}

Result<ImportMap> readImportMapText(const std::string& text, const std::string& place) {
  auto root = JsonObject::fromText(text, place);
  if (!root) return root.error();
  return readMap(*root);
}

}  // namespace breakaway
