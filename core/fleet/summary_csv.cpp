#include "fleet/summary_csv.h"

#include <algorithm>
#include <set>

#include "base/exact_text.h"
#include "fleet/spread.h"

namespace breakaway {

namespace {

/// A table that is filled column by column.
class Table {
 public:
  explicit Table(size_t rows) : rows_(rows) {}

  std::vector<std::string>& column(const std::string& name) {
    names_.push_back(name);
    columns_.emplace_back(rows_);
    return columns_.back();
  }
  bool has(const std::string& name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }
  std::string text() const;

 private:
  size_t rows_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> columns_;
};

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string Table::text() const {
  std::string out;
  for (size_t c = 0; c < names_.size(); ++c) out += (c == 0 ? "" : ",") + cell(names_[c]);
  out += '\n';
  for (size_t row = 0; row < rows_; ++row) {
    for (size_t c = 0; c < columns_.size(); ++c) out += (c == 0 ? "" : ",") + cell(columns_[c][row]);
    out += '\n';
  }
  return out;
}

void addValues(Table& table, const FleetColumn& column) {
  for (const auto& [suffix, member] :
       {std::pair("", &FleetValue::value), {"_low95", &FleetValue::low95}, {"_high95", &FleetValue::high95}}) {
    if (!column.intervals && member != &FleetValue::value) break;
    auto& cells = table.column(column.name + suffix);
    for (size_t k = 0; k < column.entries.size(); ++k) cells[column.entries[k]] = exactText(column.values[k].*member);
  }
}

template <typename TextOf>
void addTexts(Table& table, const std::string& name, const std::vector<FleetEntry>& entries, const TextOf& textOf) {
  auto& cells = table.column(name);
  for (size_t k = 0; k < entries.size(); ++k) cells[k] = textOf(entries[k]);
}

void addFits(Table& table, const std::vector<FleetEntry>& entries) {
  const auto add = [&](const std::string& name, const auto& numberOf) {
    addTexts(table, name, entries,
             [&numberOf](const FleetEntry& one) { return one.fit ? exactText(numberOf(*one.fit)) : std::string(); });
  };
  add("gain", [](const FleetFit& fit) { return fit.gain.value; });
  add("gain_low95", [](const FleetFit& fit) { return fit.gain.low95; });
  add("gain_high95", [](const FleetFit& fit) { return fit.gain.high95; });
  add("heldout_before", [](const FleetFit& fit) { return fit.before; });
  add("heldout_after", [](const FleetFit& fit) { return fit.after; });
  add("floor", [](const FleetFit& fit) { return fit.floor; });
  addTexts(table, "channel", entries, [](const FleetEntry& one) { return one.fit ? one.fit->channel : std::string(); });
}

void addOutliers(Table& table, const std::vector<FleetEntry>& entries, const std::vector<FleetColumn>& columns) {
  const std::vector<StandsOut> order = outliersFirst(entries, columns);
  auto& far = table.column("stands_out");
  for (const StandsOut& one : order) {
    if (entries[one.entry].error.empty()) far[one.entry] = exactText(one.distance);
  }
  auto& by = table.column("stands_out_by");
  for (const StandsOut& one : order) by[one.entry] = one.parameter;
}

void addFurther(Table& table, const std::vector<FleetEntry>& entries) {
  for (const std::string& name : furtherNames(entries)) {
    addTexts(table, table.has(name) ? "manifest_" + name : name, entries, [&name](const FleetEntry& one) {
      for (const auto& [field, text] : one.further) {
        if (field == name) return text;
      }
      return std::string();
    });
  }
}

}  // namespace

std::vector<std::string> furtherNames(const std::vector<FleetEntry>& entries) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const FleetEntry& entry : entries) {
    for (const auto& [name, text] : entry.further) {
      if (seen.insert(name).second) names.push_back(name);
    }
  }
  return names;
}

std::string summaryCsv(const std::vector<FleetEntry>& entries) {
  Table table(entries.size());
  addTexts(table, "id", entries, [](const FleetEntry& one) { return one.id; });
  addTexts(table, "verdict", entries, [](const FleetEntry& one) { return one.verdict; });
  addTexts(table, "names", entries, [](const FleetEntry& one) { return one.names(); });
  addFits(table, entries);
  const std::vector<FleetColumn> base = baseColumns(entries);
  for (const FleetColumn& column : base) addValues(table, column);
  for (const FleetColumn& column : findingColumns(entries)) addValues(table, column);
  addOutliers(table, entries, base);
  addTexts(table, "at", entries, [](const FleetEntry& one) { return one.at; });
  addTexts(table, "report", entries, [](const FleetEntry& one) { return one.report; });
  addTexts(table, "error", entries, [](const FleetEntry& one) { return one.error; });
  addFurther(table, entries);
  return table.text();
}

}  // namespace breakaway
