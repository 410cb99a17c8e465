#include "recording/import/import.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/exact_text.h"
#include "recording/import/axes_in_turn.h"
#include "recording/import/known_logs.h"
#include "recording/import/read_table.h"

namespace breakaway {

namespace {

/// Texts of further rows, counted as those of the first.
void appendTexts(RawColumn& column, const RawColumn& more) {
  column.manyTexts = column.manyTexts || more.manyTexts;
  if (column.manyTexts) column.texts.clear();
  if (column.manyTexts || (column.texts.empty() && more.texts.empty())) return;
  column.textOf.resize(column.channel.values.size());
  for (size_t k = 0; k < more.channel.values.size(); ++k) {
    const size_t kind = k < more.textOf.size() && !more.texts.empty() ? more.textOf[k] : 0;
    if (kind == 0) {
      column.textOf.push_back(0);
      continue;
    }
    auto at = std::find(column.texts.begin(), column.texts.end(), more.texts[kind - 1]);
    if (at == column.texts.end()) at = column.texts.insert(at, more.texts[kind - 1]);
    column.textOf.push_back(static_cast<uint16_t>(at - column.texts.begin() + 1));
  }
}

/// Puts the rows of `more` behind those of `table`; both have the same columns.
Result<void> append(RawTable& table, RawTable more, const std::string& name) {
  for (RawColumn& column : table.columns) {
    const auto it = std::find_if(more.columns.begin(), more.columns.end(),
                                 [&](const RawColumn& one) { return one.channel.name == column.channel.name; });
    if (it == more.columns.end())
      return Error{name, message("has no column {}, as the first file has", column.channel.name)};
    const double shift = it->origin - column.origin;
    appendTexts(column, *it);
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
    first->table.remarks.push_back(message("{} follows from row {}", other, first->newPart.back() + 1));
  }
  return first;
}

/// Its values, as kinds of rows.
Result<RowKinds> kindsOf(const RawColumn& column, const std::string& path) {
  if (!column.texts.empty()) return *rowKinds(column);
  constexpr size_t mostParts = 1000;
  RowKinds kinds;
  std::vector<double> seen;
  for (const double value : column.channel.values) {
    const auto at = std::find(seen.begin(), seen.end(), value);
    kinds.of.push_back(std::isfinite(value) ? static_cast<size_t>(at - seen.begin()) + 1 : 0);
    if (!std::isfinite(value) || at != seen.end()) continue;
    seen.push_back(value);
    kinds.names.push_back(exactText(value));
    if (seen.size() > mostParts)
      return Error{path + ", column " + column.channel.name, message("holds more than 1000 values to split by")};
  }
  return kinds;
}

}  // namespace

Result<std::vector<RawTable>> partsByColumn(const RawTable& table, const std::string& column, const std::string& path) {
  const auto by = std::find_if(table.columns.begin(), table.columns.end(),
                               [&](const RawColumn& one) { return one.channel.name == column; });
  if (by == table.columns.end()) return Error{path, message("has no column \"{}\", by which the map splits", column)};
  const auto kinds = kindsOf(*by, path);
  if (!kinds) return kinds.error();
  std::vector<RawTable> parts;
  for (size_t kind = 1; kind <= kinds->names.size(); ++kind) {
    RawTable part = table;
    for (size_t c = 0; c < table.columns.size(); ++c) {
      auto& values = part.columns[c].channel.values;
      values.clear();
      part.columns[c].texts.clear();
      for (size_t k = 0; k < kinds->of.size(); ++k) {
        if (kinds->of[k] == kind) values.push_back(table.columns[c].channel.values[k]);
      }
    }
    part.notes.emplace_back(column, kinds->names[kind - 1]);
    parts.push_back(std::move(part));
  }
  return parts;
}

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
  auto parts = partsByColumn(read->table, map.split, path);
  if (!parts) return parts.error();
  const auto all = parts->size();
  std::erase_if(*parts, [all](const RawTable& part) { return all > 1 && part.rows() < 2; });  // no motion
  const size_t leftOut = all - parts->size();
  for (RawTable& part : *parts) {
    const std::string name = path + " (" + map.split + " " + part.notes.back().second + ")";
    auto one = settleTable(std::move(part), map, name, {});
    if (!one) return one.error();
    recordings.push_back(std::move(*one));
  }
  if (recordings.empty()) return Error{path, message("is split by \"{}\" into single rows", map.split)};
  if (leftOut > 0)
    recordings.front().remarks.push_back(
        leftOut == 1 ? message("1 part of the log is a single row and was left out")
                     : message("{} parts of the log are single rows and were left out", leftOut));
  return recordings;
}

Result<Imported> importRecording(const std::string& path, const ImportMap& map) {
  auto all = importRecordings(path, map);
  if (!all) return all.error();
  if (all->size() != 1) return Error{path, message("is split into {} recordings, expected one", all->size())};
  return std::move(all->front());
}

}  // namespace breakaway
