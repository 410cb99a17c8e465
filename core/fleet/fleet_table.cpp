#include "fleet/fleet_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "draw/html_report.h"
#include "draw/svg_plot.h"
#include "fleet/summary_csv.h"
#include "fleet/table_script.h"

namespace breakaway {

namespace {

using OptionalValue = std::optional<FleetValue>;

/// A column of texts or of numbers; rows in the table's order.
struct Shown {
  std::string name;
  std::vector<std::string> texts = {};
  std::vector<OptionalValue> values = {};
  bool intervals = false, bySize = false;

  bool ofTexts() const { return !texts.empty(); }
  std::string text(size_t row) const {
    if (ofTexts()) return texts[row];
    if (!values[row]) return {};
    std::string number = numberText(values[row]->value);
    if (number.starts_with('-')) number.replace(0, 1, "\u2212");
    return number;
  }
};

/// Builds the columns in the table's order of rows.
class Rows {
 public:
  Rows(const std::vector<FleetEntry>& entries, const std::vector<StandsOut>& order)
      : entries_(entries), order_(order) {}

  template <typename TextOf>
  Shown texts(const std::string& name, const TextOf& textOf) const {
    Shown column{.name = name};
    column.texts.reserve(order_.size());
    for (const StandsOut& one : order_) column.texts.push_back(textOf(entries_[one.entry]));
    return column;
  }
  Shown parameter(const FleetColumn& of) const {
    std::map<size_t, size_t> places;
    for (size_t k = 0; k < of.entries.size(); ++k) places[of.entries[k]] = k;
    Shown column{.name = of.name, .intervals = of.intervals};
    column.values.reserve(order_.size());
    for (const StandsOut& one : order_) {
      const auto it = places.find(one.entry);
      column.values.push_back(it == places.end() ? OptionalValue() : of.values[it->second]);
    }
    return column;
  }
  Shown gain() const {
    Shown column{.name = "gain", .intervals = true};
    column.values.reserve(order_.size());
    for (const StandsOut& one : order_) {
      const auto& fit = entries_[one.entry].fit;
      column.values.push_back(fit ? OptionalValue(fit->gain) : OptionalValue());
    }
    return column;
  }
  /// How far it stands out, to a tenth, and by what.
  std::vector<Shown> apart() const {
    Shown far{.name = "stands out", .bySize = true}, by{.name = "by"};
    far.values.reserve(order_.size());
    by.texts.reserve(order_.size());
    for (const StandsOut& one : order_) {
      const bool failed = !entries_[one.entry].error.empty();
      far.values.push_back(failed ? OptionalValue() : FleetValue{std::round(one.distance * 10.0) / 10.0, 0.0, 0.0});
      by.texts.push_back(one.parameter);
    }
    return {std::move(far), std::move(by)};
  }

 private:
  const std::vector<FleetEntry>& entries_;
  const std::vector<StandsOut>& order_;
};

bool anyText(const Shown& column) {
  return std::any_of(column.texts.begin(), column.texts.end(), [](const std::string& one) { return !one.empty(); });
}

std::vector<Shown> columnsOf(const std::vector<FleetEntry>& entries, const std::vector<FleetColumn>& base,
                             const std::vector<StandsOut>& order) {
  const Rows rows(entries, order);
  std::vector<Shown> columns;
  columns.push_back(rows.texts("id", [](const FleetEntry& one) { return one.id; }));
  columns.push_back(rows.texts("verdict", [](const FleetEntry& one) { return one.verdict; }));
  columns.push_back(rows.texts("names", [](const FleetEntry& one) { return one.names(); }));
  columns.push_back(rows.gain());
  for (Shown& one : rows.apart()) columns.push_back(std::move(one));
  for (const FleetColumn& one : base) columns.push_back(rows.parameter(one));
  const auto addIfAny = [&columns](Shown&& column) {
    if (anyText(column)) columns.push_back(std::move(column));
  };
  addIfAny(rows.texts("at", [](const FleetEntry& one) { return one.at; }));
  for (const std::string& name : furtherNames(entries)) {
    addIfAny(rows.texts(name, [&name](const FleetEntry& one) {
      const auto it = std::find_if(one.further.begin(), one.further.end(),
                                   [&name](const auto& field) { return field.first == name; });
      return it == one.further.end() ? std::string() : it->second;
    }));
  }
  addIfAny(rows.texts("error", [](const FleetEntry& one) { return one.error; }));
  return columns;
}

/// As a JSON text that no HTML ends.
std::string quoted(const std::string& text) {
  std::string json = nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), out;
  out.reserve(json.size());
  for (const char c : json) out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

template <typename Items, typename AsText>
std::string listOf(const Items& items, const AsText& asText) {
  std::string out = "[";
  for (const auto& one : items) {
    if (out.size() > 1) out += ',';
    out += asText(one);
  }
  return out + "]";
}

/// Four digits.
std::string number(const OptionalValue& value, double FleetValue::*member) {
  return value && std::isfinite(*value.*member) ? fmt::format("{:.4g}", *value.*member) : "null";
}

std::string textsJson(const Shown& column) {
  std::map<std::string, size_t> places;
  std::vector<std::string> words;
  std::vector<size_t> indices;
  indices.reserve(column.texts.size());
  for (const std::string& text : column.texts) {
    const auto [it, isNew] = places.emplace(text, words.size());
    if (isNew) words.push_back(text);
    indices.push_back(it->second);
  }
  return "\"w\":" + listOf(words, quoted) + ",\"i\":" + listOf(indices, [](size_t one) { return std::to_string(one); });
}

std::string valuesJson(const Shown& column) {
  const auto of = [&column](double FleetValue::*member) {
    return listOf(column.values, [member](const OptionalValue& one) { return number(one, member); });
  };
  std::string json = "\"v\":" + of(&FleetValue::value);
  if (column.intervals) json += ",\"l\":" + of(&FleetValue::low95) + ",\"h\":" + of(&FleetValue::high95);
  return json + (column.bySize ? ",\"abs\":true" : "");
}

std::string dataJson(const std::vector<Shown>& columns, const std::vector<std::string>& reports, size_t rows,
                     size_t apart) {
  std::string json = fmt::format("{{\"rows\":{},\"apart\":{},\"columns\":", rows, apart);
  json += listOf(columns, [](const Shown& one) {
    return "{\"n\":" + quoted(one.name) + "," + (one.ofTexts() ? textsJson(one) : valuesJson(one)) + "}\n";
  });
  const bool any = std::any_of(reports.begin(), reports.end(), [](const std::string& one) { return !one.empty(); });
  if (any) json += ",\"reports\":" + listOf(reports, quoted);
  return json + "}";
}

/// A name that may be broken after its underscores.
std::string breakable(const std::string& name) {
  std::string out;
  for (const char c : escaped(name)) out += c == '_' ? std::string("_<wbr>") : std::string(1, c);
  return out;
}

/// In widths of a digit.
size_t widthOf(const Shown& column) {
  size_t widest = 0;
  for (size_t row = 0; row < std::max(column.texts.size(), column.values.size()); ++row)
    widest = std::max(widest, column.text(row).size());
  return std::clamp<size_t>(widest, 9, 26) + 3;
}

std::string head(const std::vector<Shown>& columns) {
  std::string cells, widths;
  size_t all = 0;
  for (const Shown& one : columns) {
    const size_t width = widthOf(one);
    all += width;
    widths += fmt::format("<col style=\"width:{}ch\">", width);
    cells += std::string(one.ofTexts() ? "<th>" : "<th class=\"number\">") + breakable(one.name) + "</th>";
  }
  return fmt::format("<table style=\"width:{}ch\"><colgroup>{}</colgroup><thead><tr>{}</tr></thead>\n", all, widths,
                     cells);
}

std::string plainRow(const std::vector<Shown>& columns, const std::string& report, size_t row, bool apart) {
  std::string out = apart ? "<tr class=\"apart\">" : "<tr>";
  for (const Shown& one : columns) {
    std::string text = escaped(one.text(row));
    if (&one == columns.data() && !report.empty()) text = "<a href=\"" + report + "\">" + text + "</a>";
    out += (one.ofTexts() ? "<td>" : "<td class=\"number\">") + text + "</td>";
  }
  return out + "</tr>\n";
}

std::string filters(const std::vector<FleetEntry>& entries) {
  std::map<std::string, size_t> verdicts;
  for (const FleetEntry& entry : entries) ++verdicts[entry.verdict];
  std::string choices = "<option value=\"\">every verdict</option>";
  for (const auto& [verdict, count] : verdicts)
    choices += fmt::format("<option value=\"{0}\">{0} ({1})</option>", escaped(verdict), count);
  return "<div class=\"filters\" hidden><label>Filter <input type=\"search\" id=\"fleet-search\" placeholder=\"any "
         "text\"></label><label>Verdict <select id=\"fleet-verdict\">" +
         choices +
         "</select></label><label><input type=\"checkbox\" id=\"fleet-apart\"> only what stands out</label><span "
         "id=\"fleet-count\" role=\"status\"></span></div>\n";
}

}  // namespace

std::string addressOf(const std::string& report) {
  const bool address = report.starts_with("http://") || report.starts_with("https://");
  std::string out;
  for (const char c : report) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-_./~").find(c) != std::string_view::npos ||
                       (address && std::string_view(":?&=%#+@,;").find(c) != std::string_view::npos);
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

std::string fleetTable(const std::vector<FleetEntry>& entries, const std::vector<FleetColumn>& base,
                       const std::vector<StandsOut>& order) {
  const std::vector<Shown> columns = columnsOf(entries, base, order);
  std::vector<std::string> reports;
  reports.reserve(order.size());
  for (const StandsOut& one : order) reports.push_back(addressOf(entries[one.entry].report));
  const auto isApart = [](const StandsOut& one) { return std::abs(one.distance) >= standsOutFrom; };
  const auto apart = static_cast<size_t>(std::count_if(order.begin(), order.end(), isApart));
  std::string html =
      fleetTableStyle + filters(entries) + "<div class=\"fleet\" tabindex=\"0\">" + head(columns) + "<tbody>\n";
  const size_t plain = std::min(order.size(), plainRows);
  for (size_t row = 0; row < plain; ++row) html += plainRow(columns, reports[row], row, row < apart);
  html += "</tbody></table></div>\n";
  if (plain < order.size())
    html += fmt::format(
        "<noscript><p>The first {} of {} rows: all of them are shown where scripts run, and in the "
        "table that <code>--out NAME.csv</code> writes.</p></noscript>\n",
        plain, order.size());
  html += "<script type=\"application/json\" id=\"fleet-data\">" + dataJson(columns, reports, order.size(), apart) +
          "</script>\n";
  return html + fleetTableScript;
}

}  // namespace breakaway
