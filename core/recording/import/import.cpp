#include "recording/import/import.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/exact_text.h"
#include "recording/import/known_logs.h"
#include "recording/import/read_table.h"

namespace breakaway {

namespace {

/// Puts the rows of `more` behind those of `table`; both have the same columns.
Result<void> append(RawTable& table, RawTable more, const std::string& name) {
  for (RawColumn& column : table.columns) {
    const auto it = std::find_if(more.columns.begin(), more.columns.end(),
                                 [&](const RawColumn& one) { return one.channel.name == column.channel.name; });
    if (it == more.columns.end())
      return Error{name, "has no column " + column.channel.name + ", as the first file has"};
    const double shift = it->origin - column.origin;
    for (const double value : it->channel.values) column.channel.values.push_back(value + shift);
    if (!column.fault) column.fault = it->fault;
  }
  return {};
}

Result<ReadTable> readAll(const std::string& path, const ImportMap& map) {
  auto first = readTable(path);
  if (!first) return first.error();
  for (const std::string& other : map.join) {
    const std::filesystem::path beside = std::filesystem::path(path).parent_path() / other;
    auto more = readTable(beside.string());
    if (!more) return more.error();
    first->newPart.push_back(first->table.rows());
    if (const auto done = append(first->table, std::move(more->table), beside.string()); !done) return done.error();
    first->table.remarks.push_back(other + " follows from row " + std::to_string(first->newPart.back() + 1));
  }
  return first;
}

/// One table per value of the column.
Result<std::vector<RawTable>> partsOf(const RawTable& table, const std::string& column, const std::string& path) {
  const auto by = std::find_if(table.columns.begin(), table.columns.end(),
                               [&](const RawColumn& one) { return one.channel.name == column; });
  if (by == table.columns.end()) return Error{path, "has no column \"" + column + "\", by which the map splits"};
  constexpr size_t mostParts = 1000;
  std::vector<double> kinds;
  for (const double value : by->channel.values) {
    if (std::isfinite(value) && std::find(kinds.begin(), kinds.end(), value) == kinds.end()) kinds.push_back(value);
    if (kinds.size() > mostParts) return Error{path + ", column " + column, "holds more than 1000 values to split by"};
  }
  std::vector<RawTable> parts;
  for (const double kind : kinds) {
    RawTable part = table;
    for (size_t c = 0; c < table.columns.size(); ++c) {
      auto& values = part.columns[c].channel.values;
      values.clear();
      for (size_t k = 0; k < by->channel.values.size(); ++k) {
        if (by->channel.values[k] == kind) values.push_back(table.columns[c].channel.values[k]);
      }
    }
    part.notes.emplace_back(column, exactText(kind));
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

Result<std::vector<Imported>> importRecordings(const std::string& path, const ImportMap& map) {
  auto read = readAll(path, map);
  if (!read) return read.error();
  if (map.columns.empty()) {
    if (const auto known = translateKnownLog(read->table, path); !known) return known.error();
  }
  std::vector<Imported> recordings;
  if (map.split.empty()) {
    auto one = settleTable(std::move(read->table), map, path, read->newPart);
    if (!one) return one.error();
    recordings.push_back(std::move(*one));
    return recordings;
  }
  auto parts = partsOf(read->table, map.split, path);
  if (!parts) return parts.error();
  for (RawTable& part : *parts) {
    const std::string name = path + " (" + map.split + " " + part.notes.back().second + ")";
    auto one = settleTable(std::move(part), map, name, {});
    if (!one) return one.error();
    recordings.push_back(std::move(*one));
  }
  return recordings;
}

Result<Imported> importRecording(const std::string& path, const ImportMap& map) {
  auto all = importRecordings(path, map);
  if (!all) return all.error();
  if (all->size() != 1)
    return Error{path, "is split into " + std::to_string(all->size()) + " recordings, expected one"};
  return std::move(all->front());
}

}  // namespace breakaway
