#include "recording/import/sysid_json.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

namespace breakaway {

namespace {

using SysidJson = nlohmann::json;

constexpr auto tests = std::to_array<const char*>({"slow-forward", "slow-backward", "fast-forward", "fast-backward"});

bool isTest(const SysidJson& value) {
  return value.is_array() && !value.empty() && value.front().is_array() && value.front().size() >= 4;
}

std::string textOf(const SysidJson& json, const char* key) {
  const auto it = json.find(key);
  return it != json.end() && it->is_string() ? it->get<std::string>() : std::string();
}

struct Named {
  const char* name;
  const char* unit;  ///< "" for the file's unit of position, "/s" for that of speed
};

std::vector<Named> columnsOf(size_t width) {
  if (width == 4) return {{"time", "s"}, {"voltage", "V"}, {"position", ""}, {"velocity", "/s"}};
  if (width == 9 || width == 8)
    return {{"time", "s"},
            {"left voltage", "V"},
            {"right voltage", "V"},
            {"left position", ""},
            {"right position", ""},
            {"left velocity", "/s"},
            {"right velocity", "/s"},
            {"heading", "rad"},
            {"heading rate", "rad/s"}};
  if (width == 10)
    return {{"time", "s"},          {"battery voltage", "V"}, {"autospeed", "1"},
            {"left voltage", "V"},  {"right voltage", "V"},   {"left position", ""},
            {"right position", ""}, {"left velocity", "/s"},  {"right velocity", "/s"},
            {"heading", "rad"}};
  return {};
}

bool holdsTests(const SysidJson& json) {
  if (!json.is_object()) return false;
  return std::any_of(tests.begin(), tests.end(),
                     [&json](const char* test) { return json.contains(test) && isTest(json[test]); });
}

Result<ReadTable> readTests(const SysidJson& json, const std::string& name) {
  ReadTable read;
  RawTable& table = read.table;
  const std::string unit = textOf(json, "units");
  std::vector<Named> columns;
  for (const char* test : tests) {
    if (!json.contains(test) || !isTest(json[test])) continue;
    const SysidJson& rows = json[test];
    if (columns.empty()) {
      columns = columnsOf(rows.front().size());
      if (columns.empty())
        return Error{name + ", " + test, message("has rows of {} numbers, expected time, voltage, position, velocity",
                                                 rows.front().size())};
      columns.resize(std::min(columns.size(), rows.front().size()));
      for (const Named& one : columns) {
        RawColumn column{{one.name, {}}, {}};
        const std::string_view own = one.unit;
        column.unit = own.empty()                    ? unit
                      : own == "/s" && !unit.empty() ? unit + "/s"
                      : own == "/s"                  ? ""
                                                     : std::string(own);
        table.columns.push_back(std::move(column));
      }
    }
    if (table.rows() > 0) read.newPart.push_back(table.rows());
    const size_t before = table.rows();
    for (const SysidJson& row : rows) {
      if (!row.is_array() || row.size() < columns.size())
        return Error{name + ", " + test, message("has a row of another length, expected {}", columns.size())};
      for (size_t c = 0; c < columns.size(); ++c) {
        if (!row[c].is_number()) return Error{name + ", " + test, message("has a row with other than numbers")};
        table.columns[c].channel.values.push_back(row[c].get<double>());
      }
    }
    table.remarks.push_back(message("{}: {} rows, from row {}", test, rows.size(), before + 1));
  }
  table.remarks.push_back(unit.empty()
                              ? message("recognised SysId's tests, without a unit; each begins anew, after a pause")
                              : message("recognised SysId's tests, in {}; each begins anew, after a pause", unit));
  return read;
}

}  // namespace

std::optional<Result<ReadTable>> readSysId(const std::string& text, const std::string& name) {
  if (std::none_of(tests.begin(), tests.end(),
                   [&text](const char* test) { return text.find(test) != std::string::npos; }))
    return std::nullopt;
  const SysidJson json = SysidJson::parse(text, nullptr, false);
  if (!holdsTests(json)) return std::nullopt;
  return readTests(json, name);
}

}  // namespace breakaway
