#include "fleet/summary_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "draw/html_report.h"
#include "fleet/fleet_figures.h"
#include "fleet/fleet_map.h"
#include "fleet/fleet_table.h"
#include "fleet/spread.h"

namespace breakaway {

namespace {

constexpr size_t mostOutliers = 12, mostErrors = 20;
constexpr int small_px = 430, smallHeight_px = 250;

std::string counted(size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

size_t apartOf(const std::vector<StandsOut>& order) {
  return static_cast<size_t>(std::count_if(
      order.begin(), order.end(), [](const StandsOut& one) { return std::abs(one.distance) >= standsOutFrom; }));
}

std::string verdictWords(const std::vector<FleetEntry>& entries, size_t apart) {
  std::map<std::string, size_t> verdicts;
  for (const FleetEntry& entry : entries) ++verdicts[entry.verdict];
  std::string words = counted(entries.size(), "entry", "entries");
  const std::pair<const char*, const char*> said[] = {{"nothing_missing", "nothing missing"},
                                                      {"named", "something missing that has a name"},
                                                      {"ambiguous", "ambiguous"},
                                                      {"outside_catalogue", "something without a name"},
                                                      {"undecided", "undecided"},
                                                      {"error", "ended in an error"}};
  std::string joint = ": ";
  for (const auto& [verdict, meaning] : said) {
    if (verdicts[verdict] == 0) continue;
    words += joint + std::to_string(verdicts[verdict]) + " " + meaning;
    joint = ", ";
  }
  return words + ".\n" + (apart == 1 ? "1 stands out" : std::to_string(apart) + " stand out") + " from the others.";
}

std::string valueText(const FleetValue& value) {
  if (value.low95 == value.high95) return numberText(value.value);
  return numberText(value.value) + " [" + numberText(value.low95) + ", " + numberText(value.high95) + "]";
}

void addOutliers(HtmlReport& page, const std::vector<FleetEntry>& entries, const std::vector<FleetColumn>& columns,
                 const std::vector<StandsOut>& order, size_t apart) {
  page.heading("What stands out");
  page.paragraph(fmt::format(
      "For each parameter: the fleet's median, and a robust deviation, 1.4826 times the median distance from it "
      "(1.2533 "
      "times the mean distance where more than half are equal). How far an entry lies from the others is told by the "
      "nearer end of its 95 % interval, so that a value that is merely uncertain doesn't stand out. An entry stands "
      "out "
      "from {} deviations on, by its furthest parameter; with fewer than {} values none does.",
      standsOutFrom, fewestForOutliers));
  std::vector<std::vector<Saying>> rows;
  std::vector<std::string> links;
  for (size_t k = 0; k < std::min(apart, mostOutliers); ++k) {
    const StandsOut& one = order[k];
    const auto column = std::find_if(columns.begin(), columns.end(),
                                     [&one](const FleetColumn& each) { return each.name == one.parameter; });
    const FleetParameters& parameters = entries[one.entry].parameters;
    const auto value = std::find_if(parameters.begin(), parameters.end(),
                                    [&one](const auto& each) { return each.first == one.parameter; });
    if (column == columns.end() || value == parameters.end()) continue;
    rows.push_back({entries[one.entry].id, one.parameter, valueText(value->second), numberText(column->median),
                    numberText(column->deviation, 2), numberText(one.distance, 2)});
    links.push_back(addressOf(entries[one.entry].report));
  }
  if (rows.empty()) return page.paragraph("None does.");
  page.table({"entry", "parameter", "value [95 %]", "the fleet's median", "deviation", "deviations away"}, rows,
             apart > rows.size() ? "The furthest " + std::to_string(rows.size()) + " of " + std::to_string(apart) : "",
             links);
}

void addSpread(HtmlReport& page, const std::vector<FleetColumn>& columns) {
  page.heading("How the parameters are spread");
  std::vector<std::vector<Saying>> rows;
  rows.reserve(columns.size());
  for (const FleetColumn& one : columns) {
    rows.push_back({one.name, std::to_string(one.values.size()), numberText(one.quantileOf(0.05), 3),
                    numberText(one.quantileOf(0.25), 3), numberText(one.median, 3), numberText(one.quantileOf(0.75), 3),
                    numberText(one.quantileOf(0.95), 3), numberText(one.deviation, 2)});
  }
  page.table({"parameter", "entries", "5 %", "25 %", "median", "75 %", "95 %", "deviation"}, rows);
  page.raw("<div class=\"figures\">\n");
  for (const FleetColumn& one : columns) {
    const size_t beyond = beyondSpread(one);
    page.figure(spreadFigure(one),
                beyond == 0 ? "" : counted(beyond, "entry lies", "entries lie") + " beyond the picture.", small_px,
                smallHeight_px);
  }
  page.raw("</div>\n");
}

void addTrend(HtmlReport& page, const std::vector<FleetEntry>& entries, const std::vector<FleetColumn>& columns) {
  std::vector<Figure> figures;
  for (const FleetColumn& one : columns) {
    if (auto figure = trendFigure(one, entries)) figures.push_back(std::move(*figure));
  }
  if (figures.empty()) return;
  std::string first;
  for (const FleetEntry& entry : entries) {
    if (daysOf(entry.at) && (first.empty() || *daysOf(entry.at) < *daysOf(first))) first = entry.at;
  }
  page.heading("By date");
  page.paragraph("The median of the entries of some days, with the middle half of them as a band. The first date is " +
                 first.substr(0, 10) + ".");
  page.raw("<div class=\"figures\">\n");
  for (const Figure& one : figures) page.figure(one, "", small_px, smallHeight_px);
  page.raw("</div>\n");
}

void addMaps(HtmlReport& page, const std::vector<FleetEntry>& entries) {
  const std::vector<Figure> figures = mapFigures(entries);
  if (figures.empty()) return;
  page.heading("Friction maps");
  page.paragraph(
      "Around the rotor, from the encoder's index: the median of the maps with the middle half of them as a band.");
  page.raw("<div class=\"figures\">\n");
  for (const Figure& one : figures) page.figure(one, "", small_px, smallHeight_px);
  page.raw("</div>\n");
}

void addFindings(HtmlReport& page, const std::vector<FleetEntry>& entries) {
  std::map<std::string, size_t> counts;
  for (const FleetEntry& entry : entries) {
    for (const FleetFinding& finding : entry.findings) ++counts[finding.effect];
  }
  if (counts.empty()) return;
  page.heading("What was missing");
  std::vector<std::pair<std::string, size_t>> order(counts.begin(), counts.end());
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  const std::vector<FleetColumn> columns = findingColumns(entries);
  std::vector<std::vector<Saying>> rows;
  for (const auto& [effect, count] : order) {
    std::string name = effect, found = std::to_string(count);
    for (const FleetColumn& one : columns) {
      if (!one.name.starts_with(effect + ".")) continue;
      rows.push_back({std::exchange(name, ""), std::exchange(found, ""), one.name.substr(effect.size() + 1),
                      numberText(one.quantileOf(0.25)), numberText(one.median), numberText(one.quantileOf(0.75))});
    }
    if (!name.empty()) rows.push_back({name, found, "", "", "", ""});
  }
  page.table({"effect", "entries", "parameter", "25 %", "median", "75 %"}, rows);
}

void addErrors(HtmlReport& page, const std::vector<FleetEntry>& entries) {
  std::vector<std::vector<Saying>> rows;
  std::vector<std::string> links;
  size_t failed = 0;
  for (const FleetEntry& entry : entries) {
    if (entry.error.empty()) continue;
    ++failed;
    if (rows.size() == mostErrors) continue;
    rows.push_back({entry.id, entry.error});
    links.push_back(addressOf(entry.report));
  }
  if (failed == 0) return;
  page.heading("What ended in an error");
  page.table({"entry", "error"}, rows,
             failed > rows.size() ? "The first " + std::to_string(rows.size()) + " of " + std::to_string(failed) : "",
             links);
}

}  // namespace

std::string summaryPage(const std::vector<FleetEntry>& entries) {
  const std::vector<FleetColumn> columns = baseColumns(entries);
  const std::vector<StandsOut> order = outliersFirst(entries, columns);
  const size_t apart = apartOf(order);
  HtmlReport page("Fleet", counted(entries.size(), "entry", "entries"));
  page.verdict(verdictWords(entries, apart));
  addOutliers(page, entries, columns, order, apart);
  page.heading("All entries");
  page.paragraph(
      "What stands out comes first, with a mark. A click on a column's name sorts by it, another one the other way; "
      "the "
      "interval of a number is shown where the pointer rests. The gain is the part of the held-out error that the "
      "findings take away.");
  page.raw(fleetTable(entries, columns, order));
  addSpread(page, columns);
  addMaps(page, entries);
  addFindings(page, entries);
  addTrend(page, entries, columns);
  addErrors(page, entries);
  return page.html();
}

}  // namespace breakaway
